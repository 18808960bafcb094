// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/Population/PopulationSearch.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

namespace ruc
{
/**
 * The state of a search as bytes, from which it is resumed (SearchByGradient, SearchByPopulation).
 *
 * Format, version 1, all numbers little-endian as the machine has them: the text "RUCSTATE",
 * version (32 bits), length of what follows without the checksum (64), the four fingerprints (64
 * each), the state as Base/Bytes.h writes it, FNV-1a-64 of everything before (64).
 */

/**
 * What a search is about, as fingerprints (FNV-1a-64). Settings that only say when a search ends,
 * and can be changed for it to be carried on, are left out: maximum iterations or generations,
 * patience, target objective.
 */
struct SearchKey
{
  std::uint64_t Method = 0;   // gradient or population
  std::uint64_t Contents = 0; // of the cell
  std::uint64_t Target = 0;   // S_rs and lags
  std::uint64_t Settings = 0; // seed included

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Method, self.Contents, self.Target, self.Settings);
  }
};

SearchKey MakeKey(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings);
SearchKey MakeKey(const CellContents& contents, const TwoPointProbability& target,
  const PopulationSettings& settings);

std::string WriteCheckpoint(const GradientState& state, const SearchKey& key);
std::string WriteCheckpoint(const PopulationState& state, const SearchKey& key);

/**
 * Reads what WriteCheckpoint wrote. Throws std::invalid_argument that says what is wrong with the
 * bytes: they are no checkpoint, of another version, truncated, damaged, holding a value that
 * cannot be, or of another search, and then in what it differs: method, contents, target or
 * settings.
 */
GradientState ReadGradientCheckpoint(std::string_view bytes, const SearchKey& key);
PopulationState ReadPopulationCheckpoint(std::string_view bytes, const SearchKey& key);
}
