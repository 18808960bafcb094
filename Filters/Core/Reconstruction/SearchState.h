// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <tuple>

namespace ruc
{
/** What a search is doing. Checkpoints hold these numbers, so that new ones go to the end. */
enum class SearchPhase : std::uint8_t
{
  RemovingOverlap,
  MinimisingObjective,
  AnnealingPopulation
};
constexpr int CountOf(SearchPhase)
{
  return 3;
}

/**
 * Why a search ended. The reasons after Converged come from outside; a search itself knows only
 * that it was Stopped, and its caller knows why.
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

/** The name that users see, such as "minimising F2". */
const char* NameOf(SearchPhase phase);

/** The name that users see, such as "Time limit"; empty for None. */
const char* NameOf(EndReason reason);

/** Whether a search was ended by its caller, rather than by what it found. */
inline bool IsFromOutside(EndReason reason)
{
  return reason >= EndReason::Stopped;
}

/** Where a search stands; what its caller is told every iteration. */
struct SearchState
{
  SearchPhase Phase = SearchPhase::RemovingOverlap;
  int Iteration = 0;      // or generation
  double Objective = 0.0; // F2
  double OverlapPercent = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Phase, self.Iteration, self.Objective, self.OverlapPercent);
  }
};
}
