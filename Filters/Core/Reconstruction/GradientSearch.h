// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Base/Descent.h"
#include "ruc/Reconstruction/SearchSettings.h"
#include "ruc/Reconstruction/UnitCell.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace ruc
{
struct GradientSearchSettings : SearchSettings
{
  int MaximumIterations = 1000; // 0 gives the start with its overlap removed

  template <class Self, class Visit>
  static void VisitEnd(Self& self, Visit&& visit)
  {
    SearchSettings::VisitEnd(self, visit);
    visit("MaximumIterations", self.MaximumIterations, Range::AtLeast(0));
  }
};

/** A descent has converged when F2 fell by less than this share in IterationsBetweenKept. */
constexpr double LeastProgress = 1e-3;
/** A cell without overlap is kept this often, for a search that is stopped or cannot be freed of
 * overlap at its end. */
constexpr int IterationsBetweenKept = 100;

/**
 * Weight of the overlap penalty in a descent (CellObjective). The contacts are the stiffest part of
 * the objective, so a descent is the quicker the less they weigh, and the more overlap is left to
 * be removed from a cell that is kept; from 0.01 to 0.03 both go well.
 */
constexpr double DescentPenaltyWeight = 0.02;

/** The first step of a descent, a fortieth of the mean spacing of the centres in all. */
double FirstStepOf(const CellContents& contents);

/** All of a search between two iterations: it resumes from it to the same end, bit by bit. */
struct GradientState
{
  DescentState Descent;
  std::vector<double> Best; // centres of the best cell so far
  double StartObjective = 0.0;
  double Kept = 0.0;  // F2 when IterationsBetweenKept were last over
  double Tried = 0.0; // F2 at which a cell was last freed from overlap
  bool Converged = false;
  std::vector<SearchState> Convergence;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Descent, self.Best, self.StartObjective, self.Kept, self.Tried,
      self.Converged, self.Convergence);
  }
};

/**
 * Looks for the periodic cell with the given contents whose two-point probability is nearest to the
 * target (equation 13), without overlap (14): random centres, overlap pushed out, L-BFGS on F2 with
 * an overlap penalty, and the last overlap removed exactly.
 *
 * Collective; every rank returns the same bits, whatever the number of ranks and threads. `carryOn`
 * is asked on every rank before every evaluation of F2 and every few steps in which overlap is
 * removed; when it returns false on any, the search ends with the best cell so far. `save`, if any,
 * is given the state after every iteration of L-BFGS. `resume` is a state to go on from, on any
 * number of ranks; throws std::invalid_argument if it is not one of these contents, and for
 * settings out of range.
 */
UnitCell SearchByGradient(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn, const GradientState* resume = nullptr,
  const std::function<void(const GradientState&)>& save = {});

/** What SearchByGradient takes to its last iteration. */
Estimate EstimateGradientSearch(const CellFigures& cell, const LagGrid& lags, int iterations);
}
