// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/CellStart.h"
#include "ruc/Reconstruction/GradientState.h"
#include "ruc/Reconstruction/SearchObjective.h"
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
  /** The near neighbours, pores, spectrum and third order of the pack; without a pack they are
   * empty. */
  NeighbourTarget Neighbours;
  /** By which the pack's third order is measured. */
  NeighbourhoodSettings ThirdOrder = { {}, 8, 3, 32, "ThirdOrderWeight", "ThirdOrder", 100, true };

  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    SearchSettings::VisitSearch(self, visit);
    visit("ContactWeight", self.Neighbours.ContactWeight, Range::AtLeast(0));
    visit("PoreWeight", self.Neighbours.PoreWeight, Range::AtLeast(0));
    visit("SpectrumWeight", self.Neighbours.SpectrumWeight, Range::AtLeast(0));
    visit("ThirdOrderWeight", self.Neighbours.ThirdOrderWeight, Range::AtLeast(0));
  }
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
 * After this many iterations the lattice of the pores moves. A descent fits the points of one
 * lattice in a hundred iterations, which then tell nothing of the pores between them.
 */
constexpr int IterationsOfLattice = 20;

/** The most iterations of the stages of a search. */
struct StageLengths
{
  /**
   * `maximum` is GradientSearchSettings::MaximumIterations. Without further terms it is all there
   * is; otherwise 0.6 of it come before them, and 0.9 of it with them.
   */
  StageLengths(int maximum, bool withNeighbours);

  int First;
  int WithNeighbours = 0;

  double All() const { return double(this->First) + this->WithNeighbours; }
};

/**
 * The length of the first step of a descent, over all centres together: a fortieth of the mean
 * spacing of the centres.
 */
double FirstStepOf(const CellContents& contents);

/**
 * Looks for the periodic cell with the given contents whose two-point probability is nearest to the
 * target (13), without overlap (14). It begins with random centres, pushes their overlap out, runs
 * L-BFGS on F2 with an overlap penalty, and removes the last overlap exactly.
 *
 * With GradientSearchSettings::Neighbours the search then goes on with F2 and these terms
 * together (SearchObjective), with another lattice of the pores every IterationsOfLattice; the best
 * cell is that with the least sum. F0 is half of F2 as the first descent left it. The first descent
 * ends at 0.8 of the target objective, and the search at the target once all misfits are at most 1
 * as well.
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
 * What SearchByGradient takes if it runs to its last iteration, with terms that weigh > 0, and with
 * the pack by events with which a cell begins that is known to be dense. Throws
 * std::invalid_argument where SearchByGradient does for its fraction.
 */
Estimate EstimateGradientSearch(
  const CellFigures& cell, const LagGrid& lags, const GradientSearchSettings& settings);
}
