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
 * @file
 * The state of a search as bytes, from which it is resumed (SearchByGradient, SearchByPopulation).
 *
 * The format has version 5, with all numbers in the byte order of the machine: the text "RUCSTATE";
 * the version (32 bits); the length of what follows without the checksum (64 bits); the four
 * fingerprints (64 bits each); the stops and the state as Base/Bytes.h writes them; and the
 * FNV-1a-64 checksum of everything before (64 bits).
 */

/**
 * What a search is about, as fingerprints (FNV-1a-64). Settings that only say when a search ends,
 * and may be changed for it to be carried on, are left out: the maximum of iterations or
 * generations, the patience and the target objective.
 */
struct SearchKey
{
  std::uint64_t Method = 0;   // gradient or population
  std::uint64_t Contents = 0; // of the cell
  std::uint64_t Target = 0;   // S_rs and lags, near neighbours, pores, spectrum, third order
  std::uint64_t Settings = 0; // with the seed

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

/** How often a search was ended from outside before its end. */
struct SearchStops
{
  int Count = 0;
  bool BeforeState = false; // there was no state yet the last time, so the search begins anew
  std::string Shown;        // what its caller showed then, as bytes; empty once it goes on

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Count, self.BeforeState, self.Shown);
  }
};

std::string WriteCheckpoint(
  const GradientState& state, const SearchKey& key, const SearchStops& stops = {});
std::string WriteCheckpoint(
  const PopulationState& state, const SearchKey& key, const SearchStops& stops = {});

/**
 * Reads what WriteCheckpoint wrote. Throws std::invalid_argument that says what is wrong with the
 * bytes: that they are no checkpoint, are of another version, truncated or damaged, or hold a value
 * that cannot be; or that they are of another search, and then whether its method, contents, target
 * or settings differ. `stops` is filled where it is not null.
 */
GradientState ReadGradientCheckpoint(
  std::string_view bytes, const SearchKey& key, SearchStops* stops = nullptr);
PopulationState ReadPopulationCheckpoint(
  std::string_view bytes, const SearchKey& key, SearchStops* stops = nullptr);
}
