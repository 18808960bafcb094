// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Communicator.h"
#include "Reconstruction/CellContents.h"
#include "Reconstruction/OverlapRemoval.h"
#include "Statistics/TwoPointProbability.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ruc
{
struct GradientSearchSettings
{
  std::uint32_t Seed = 1;
  int MaximumIterations = 1000; // >= 0; 0 gives the start with its overlap removed
  double TargetObjective = 0.0; // ends the search when a cell without overlap has F2 at or below it
};

/** Where a search stands; what its caller is told every iteration. */
struct SearchState
{
  const char* Phase; // "removing overlap" or "minimising F2"
  int Iteration;
  double Objective; // F2
  double OverlapPercent;
};

struct UnitCell
{
  SpherePack Pack; // centres in [0, edge)^3
  Window Box;
  double Objective = 0.0;      // F2 of `Pack`
  double StartObjective = 0.0; // F2 of the random start, freed from overlap as far as it went
  PackOverlap Overlap;
  int Iterations = 0;
  /** "Target objective", "Maximum iterations", "Converged", or "Stopped" when the caller ended the
   * search. */
  std::string EndedBy;
  TwoPointProbability Probability;
  /** Of every iteration. 0 is the random start, 1 has its overlap removed, the last is the cell
   * returned. */
  std::vector<SearchState> Convergence;
};

/**
 * Looks for the periodic cell with the given contents whose two-point probability is nearest to the
 * target (equation 13), without overlap (14): random centres, overlap pushed out, L-BFGS on F2 with
 * an overlap penalty, and the last overlap removed exactly.
 *
 * Collective; every rank returns the same bits, whatever the number of ranks and threads. `carryOn`
 * is asked on every rank in every iteration; when it returns false on any, the search ends with the
 * best cell so far.
 */
UnitCell SearchByGradient(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn);
}
