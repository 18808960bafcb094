// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/NeighbourMisfits.h"

#include <cstdint>
#include <tuple>

namespace ruc
{
/** What a search is doing. Checkpoints hold these numbers, so new ones are added at the end. */
enum class SearchPhase : std::uint8_t
{
  RemovingOverlap,
  MinimisingObjective,
  AnnealingPopulation,
  FittingNeighbours
};
constexpr int CountOf(SearchPhase)
{
  return 4;
}

/**
 * Why a search ended. The reasons from Stopped on come from outside. A search itself knows only
 * that it was Stopped; its caller knows why.
 */
enum class EndReason : std::uint8_t
{
  None, // it goes on
  TargetObjective,
  MaximumIterations,
  Converged,
  Stopped,
  TimeLimit,
  StopFile,
  Abort,
  StopButton
};
constexpr int CountOf(EndReason)
{
  return 9;
}

/** Returns the name that users see, such as "minimising F2". */
const char* NameOf(SearchPhase phase);

/** Returns the name that users see, such as "Time limit"; it is empty for None. */
const char* NameOf(EndReason reason);

/** Returns whether a search was ended by its caller, rather than by what it found. */
inline bool IsFromOutside(EndReason reason)
{
  return reason >= EndReason::Stopped;
}

/** Where a search stands. Its caller is told in every iteration. */
struct SearchState
{
  SearchPhase Phase = SearchPhase::RemovingOverlap;
  int Iteration = 0;      // or generation
  double Objective = 0.0; // F2
  double OverlapPercent = 0.0;
  /** Of the contacts of a dense cell (ContactMultipliers); 0 for others and before there are any.
   */
  double SumOfMultipliers = 0.0;
  NeighbourMisfits Misfits; // 0 where they were not looked at

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Phase, self.Iteration, self.Objective, self.OverlapPercent,
      self.SumOfMultipliers, self.Misfits);
  }
};
}
