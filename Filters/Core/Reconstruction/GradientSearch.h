// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/ContactMultipliers.h"
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
/** Settings of SearchByGradient. */
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
/**
 * After this many iterations a copy of the cell is freed from overlap and kept if it is the best so
 * far, for a search that is stopped or whose last cell cannot be freed.
 */
constexpr int IterationsBetweenKept = 100;

/**
 * The weight of the overlap penalty in a descent (CellObjective). The contacts are the stiffest
 * part of the objective. The less they weigh, the quicker a descent goes, but the more overlap is
 * left to be removed from a cell that is kept. Weights from 0.01 to 0.03 both go well.
 */
constexpr double DescentPenaltyWeight = 0.02;

/**
 * The length of the first step of a descent, over all centres together: a fortieth of the mean
 * spacing of the centres.
 */
double FirstStepOf(const CellContents& contents);

/**
 * The whole state of a search between two iterations, from which it resumes to the same end, bit by
 * bit.
 */
struct GradientState
{
  DescentState Descent;
  std::vector<double> Best; // the centres of the best cell so far
  double StartObjective = 0.0;
  double Kept = 0.0;  // F2 at the last multiple of IterationsBetweenKept
  double Tried = 0.0; // F2 when a cell was last freed from overlap
  bool Converged = false;
  std::vector<SearchState> Convergence;
  // Of a dense cell
  ContactState Contacts;
  double Edge = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Descent, self.Best, self.StartObjective, self.Kept, self.Tried,
      self.Converged, self.Convergence, self.Contacts, self.Edge);
  }
};

/**
 * Above this share of MaximumRandomFraction cells are dense: their spheres touch so often that a
 * search from random centres would jam, with overlap.
 */
constexpr double DenseShare = 0.94;

/**
 * Looks for the periodic cell with the given contents whose two-point probability is nearest to the
 * target (13), without overlap (14). It begins with random centres, pushes their overlap out, runs
 * L-BFGS on F2 with an overlap penalty, and removes the last overlap exactly.
 *
 * A dense cell begins with a pack by events (MakeDensePack). L-BFGS descends first with soft
 * contacts, then with multipliers (ContactMultipliers), and every cell that is kept is freed by
 * RemoveOverlapByEvents, so that there is one without overlap at any moment. Where the spheres jam
 * before they fill the cell as they should, the cell is larger: UnitCell::Box tells.
 *
 * Every rank returns the same bits, whatever the number of ranks and threads. `carryOn` is asked on
 * every rank before every evaluation of F2 and every few steps in which overlap is removed; when it
 * returns false on any rank, the search ends with the best cell so far. `save`, if given, receives
 * the state after every iteration of L-BFGS. `resume` is a state to go on from, on any number of
 * ranks. Collective.
 *
 * Throws std::invalid_argument for settings out of range, for a fraction that is more than 0.015
 * above MaximumRandomFraction, and if `resume` is not a state of such
 * contents.
 */
UnitCell SearchByGradient(const CellContents& contents, const TwoPointProbability& target,
  const GradientSearchSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn, const GradientState* resume = nullptr,
  const std::function<void(const GradientState&)>& save = {});

/**
 * What SearchByGradient takes if it runs to its last iteration, with the pack by events with which
 * a cell begins that is known to be dense. Throws std::invalid_argument where SearchByGradient does
 * for its fraction.
 */
Estimate EstimateGradientSearch(const CellFigures& cell, const LagGrid& lags, int iterations);
}
