// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Range.h"

#include <cstdint>

namespace ruc
{
/**
 * The settings that all searches have.
 *
 * Settings know their names and ranges. `VisitSearch(settings, visit)` calls visit(name, value,
 * range) for every setting that makes it another search; `VisitEnd` does so for those that only say
 * when it ends, with which a search that has ended can be carried on. Checks, checkpoints and
 * printed settings go by these lists.
 */
struct SearchSettings
{
  /** The seed of all random numbers. */
  std::uint32_t Seed = 1;
  /** The search ends when a cell without overlap has F2 at or below this. */
  double TargetObjective = 0.0;

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
