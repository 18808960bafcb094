// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <vector>

namespace ruc
{
/** dS/dr at every lag: central differences, one-sided of second order at both ends (of first order
 * for K = 1). */
std::vector<double> Gradient(const std::vector<double>& values, double spacing);

/** How well an estimate of S_rs keeps the limits of equation (5), and where it reaches the far one.
 */
struct TwoPointCheck
{
  double Limit;           // c_r c_s
  double ErrorAtZero;     // |S_rs(0) - c_r delta_rs|, equation (7)
  double ErrorAtInfinity; // |S_rs(r_K) - c_r c_s|, equation (8) at the last lag
  double SaturationLength; // not a number where it is not reached
};

/** One check a pair, in the order of TwoPointProbability::Values. See SaturationLength for
 * `tolerance`. */
std::vector<TwoPointCheck> CheckTwoPointProbability(
  const TwoPointProbability& probability, double tolerance, double length);

/**
 * The least lag from which on |S_rs - c_r c_s| and `length` x |dS_rs/dr| stay at or below
 * `tolerance`, an absolute probability; not a number where even the last lag does not. `length` is
 * the unit in which a change counts: the mean diameter.
 */
double SaturationLength(
  const std::vector<double>& values, double spacing, double limit, double tolerance, double length);

/** The largest saturation length of all pairs; not a number when one of them is not reached. */
double SaturationLength(const TwoPointProbability& probability, double tolerance, double length);

/**
 * Throws std::invalid_argument unless what is given as S_rs can be the probabilities of a medium:
 * every value in [0, 1], the fractions (S_rr at lag 0) > 0 with the sum 1, and at every lag the sum
 * over s of S_rs equal to c_r, to `tolerance` in every value and sum. The message names the place.
 */
void RequireProbabilities(const TwoPointProbability& probability, double tolerance);
}
