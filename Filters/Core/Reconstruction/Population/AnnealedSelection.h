// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/Population/GeneticOperators.h"

#include <vector>

namespace ruc
{
/**
 * @file
 * Who breeds and who stays in a population that is annealed (Matous, Leps, Zeman, Sejnoha 2000, the
 * paper's reference [46]). The smaller the fitness F, the better.
 */

/**
 * The penalty p of equation (15), o / (o + h) for an overlap `percent` o. It is 0 without overlap,
 * 1/2 at the overlap `half` h, and approaches 1 for more.
 */
double OverlapPenalty(double percent, double half);

/**
 * The fitness of equation (15): F2 over the F2 of the worst of the first population, plus the
 * penalty.
 */
double Fitness(double objective, double worst, double overlapPercent, double half);

/** Returns the members from the best to the worst; equal ones stay in their order. */
std::vector<int> RankByFitness(const std::vector<double>& fitness);

/**
 * Draws `number` different members by a roulette whose shares fall linearly with rank, from
 * `pressure` for the best to 2 - `pressure` for the worst, in units of the mean. `pressure` lies in
 * [1, 2]. A member that was drawn leaves the wheel.
 */
std::vector<int> DrawMatingPool(
  const std::vector<int>& ranking, int number, double pressure, RandomSequence& random);

/**
 * The probability 1 / (1 + exp((child - parent) / T)) with which a child takes its parent's place,
 * where T > 0 is the temperature.
 */
double AcceptanceProbability(double child, double parent, double temperature);
}
