// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Base/Descent.h"
#include "ruc/Reconstruction/Population/PopulationSettings.h"
#include "ruc/Reconstruction/UnitCell.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <functional>
#include <tuple>
#include <vector>

namespace ruc
{
/** F2 over a population, as in Table I. */
struct ObjectiveRange
{
  double Minimum = 0.0, Mean = 0.0, Maximum = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Minimum, self.Mean, self.Maximum);
  }
};

/** All of a search between two generations: it resumes from it to the same end, bit by bit. */
struct PopulationState
{
  int Generation = 0;
  std::vector<std::vector<double>> Centres; // of every member, x, y, z of every sphere
  std::vector<double> Objective;            // F2
  std::vector<double> OverlapPercent;
  ObjectiveRange First; // of the first population; (15) divides by its maximum
  double Temperature = 0.0;
  int Stagnation = 0;                   // generations without a better best member
  std::vector<SearchState> Convergence; // of the best member
  // Of the hybrid: the descent of the best member
  int Descending = -1; // the member, or -1
  DescentState Descent;

  /** Equation (15). */
  std::vector<double> Fitness(double halfOverlap) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Generation, self.Centres, self.Objective, self.OverlapPercent, self.First,
      self.Temperature, self.Stagnation, self.Convergence, self.Descending, self.Descent);
  }
};

struct PopulationResult
{
  UnitCell Best;                // the best member, freed from the last overlap
  ObjectiveRange Before, After; // Table I
};

/**
 * Looks for the cell of SearchByGradient by the paper's Algorithm 1, an augmented simulated
 * annealing: a population, half of it random, half deposited, from which every generation draws a
 * mating pool by rank, alters it by genetic operators and by the mass-spring mutation, and lets the
 * children take their parents' places with an annealed probability. F2 of every member is exact
 * (CellObjective). The best member, by fitness, is never replaced by a worse one, and always by a
 * better one.
 *
 * Collective; every rank holds the whole population and returns the same bits, whatever the number
 * of ranks and threads. Member i of the first population, and child j of a generation, are made and
 * evaluated by rank i, j % ranks; the hybrid's descents are shared by all, one after another.
 *
 * `carryOn` is asked on every rank every generation, the first population being generation 0, in
 * descents every iteration, while overlap is removed for them every few steps, and after every 64
 * members or children that a rank has made. When it returns false on any rank, the search ends with
 * the best cell so far, that of the last whole generation or of the members that are made of the
 * first population. `save`, if any, is given the state after every whole generation. `resume` is a
 * state to go on from instead of a first population, on any number of ranks; throws
 * std::invalid_argument if it is not one of these contents and settings, or for settings out of
 * range.
 */
PopulationResult SearchByPopulation(const CellContents& contents, const TwoPointProbability& target,
  const PopulationSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn, const PopulationState* resume = nullptr,
  const std::function<void(const PopulationState&)>& save = {});
}
