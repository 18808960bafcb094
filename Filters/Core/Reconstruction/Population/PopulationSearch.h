// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/Population/PopulationSettings.h"
#include "ruc/Reconstruction/Population/PopulationState.h"
#include "ruc/Reconstruction/UnitCell.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <functional>

namespace ruc
{
/** What SearchByPopulation returns. */
struct PopulationResult
{
  UnitCell Best;                // the best member, freed from the last overlap
  ObjectiveRange Before, After; // F2 of the first and the last population
};

/**
 * Looks for the same cell as SearchByGradient by the paper's Algorithm 1, an augmented simulated
 * annealing. Part of the first population is random, the rest is deposited. Every generation draws
 * a mating pool by rank, alters it by genetic operators and by the mass-spring mutation, and lets
 * the children take their parents' places with an annealed probability. F2 of every member is that
 * of CellObjective. The best member, by fitness, is never replaced by a worse one, and always by a
 * better one.
 *
 * Every rank holds the whole population and returns the same bits, whatever the number of ranks and
 * threads. Members of the first population and children are made and evaluated in turn, number n by
 * rank n % ranks. All ranks share the descents of the hybrid, one after another. Collective.
 *
 * `carryOn` is asked on every rank, on the calling thread, during all that may take long: in every
 * generation, of which the first population is number 0, and again and again while members are
 * made, in descents, and while overlap is removed. When it returns false on any rank, the search
 * ends with the best cell so far: that of the last whole generation, or the best of the members of
 * the first population that are made. The overlap of that cell is removed if a few hundred steps
 * suffice.
 *
 * `save`, if any, is given the state after every whole generation. `resume` is a state to go on
 * from instead of a first population, on any number of ranks. Throws std::invalid_argument if it is
 * not a state of these contents and settings, and for settings out of range.
 */
PopulationResult SearchByPopulation(const CellContents& contents, const TwoPointProbability& target,
  const PopulationSettings& settings, Communicator& communicator,
  const std::function<bool(const SearchState&)>& carryOn, const PopulationState* resume = nullptr,
  const std::function<void(const PopulationState&)>& save = {});
}
