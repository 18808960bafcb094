// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Range.h"

#include <cstdint>

namespace ruc
{
/**
 * What all searches are told.
 *
 * Settings know their names and ranges. `VisitSearch(settings, visit)` calls
 * visit(name, value, range) for every number that makes it another search; `VisitEnd` for those
 * that only say when it ends, with which a search that has ended can be carried on. Checks,
 * checkpoints and what is printed of them go by these lists.
 */
struct SearchSettings
{
  std::uint32_t Seed = 1;       // of all random numbers
  double TargetObjective = 0.0; // ends the search when a cell without overlap has F2 at or below it

  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    visit("Seed", self.Seed, Range::AtLeast(0));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self& self, Visit&& visit)
  {
    visit("TargetObjective", self.TargetObjective, Range::AtLeast(0));
  }
};

/** Throws std::invalid_argument for a setting out of its range. */
template <class Settings>
void CheckRanges(const Settings& settings)
{
  const auto check = [](const char* name, double value, const Range& range)
  { range.Check(name, value); };
  Settings::VisitSearch(settings, check);
  Settings::VisitEnd(settings, check);
}
}
