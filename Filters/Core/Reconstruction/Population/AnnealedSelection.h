// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/Population/GeneticOperators.h"

#include <vector>

namespace ruc
{
/**
 * Who breeds and who stays in a population that is annealed (Matous, Leps, Zeman, Sejnoha 2000, the
 * paper's reference [46]). Fitness F is to be made small.
 */

/**
 * The penalty p of equation (15): o / (o + h) of an overlap of `percent` o, so 0 without overlap,
 * 1/2 at `half` h, and nearer and nearer to 1.
 */
double OverlapPenalty(double percent, double half);

/** Equation (15): F2 over that of the worst of the first population, plus the penalty. */
double Fitness(double objective, double worst, double overlapPercent, double half);

/** The members from the best to the worst; equal ones in their order. */
std::vector<int> RankByFitness(const std::vector<double>& fitness);

/**
 * `number` different members, drawn by a roulette whose shares go by rank: from `pressure` for the
 * best linearly down to 2 - `pressure` for the worst, in units of the mean. `pressure` lies in [1,
 * 2]. A member that was drawn leaves the wheel.
 */
std::vector<int> DrawMatingPool(
  const std::vector<int>& ranking, int number, double pressure, RandomSequence& random);

/** The probability 1 / (1 + exp((child - parent) / T)) with which a child takes its parent's place,
 * T > 0. */
double AcceptanceProbability(double child, double parent, double temperature);
}
