// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <vector>

namespace ruc
{
/**
 * Returns dS/dr at every lag, in 1 / length: central differences, and one-sided ones of second
 * order at both ends (of first order for K = 1).
 */
std::vector<double> Gradient(const std::vector<double>& values, double spacing);

/**
 * How well an estimate of S_rs meets the limits of equation (5), and where it reaches the far one.
 * All but SaturationLength are absolute probabilities.
 */
struct TwoPointCheck
{
  double Limit;            // c_r c_s
  double ErrorAtZero;      // |S_rs(0) - c_r delta_rs|, equation (7)
  double ErrorAtInfinity;  // |S_rs(r_K) - c_r c_s|, equation (8) at the last lag
  double SaturationLength; // NaN where it is not reached
};

/**
 * Returns one check for each pair, in the order of TwoPointProbability::Values. `tolerance` and
 * `length` are those of SaturationLength.
 */
std::vector<TwoPointCheck> CheckTwoPointProbability(
  const TwoPointProbability& probability, double tolerance, double length);

/**
 * Returns the least lag from which on both |S_rs - c_r c_s| and `length` x |dS_rs/dr| stay at or
 * below `tolerance`, an absolute probability. It is NaN where they do not even at the last lag.
 * `length` is the length over which a change counts: the mean diameter.
 */
double SaturationLength(
  const std::vector<double>& values, double spacing, double limit, double tolerance, double length);

/** Returns the largest saturation length of all pairs, or NaN when one of them is not reached. */
double SaturationLength(const TwoPointProbability& probability, double tolerance, double length);

/**
 * Throws std::invalid_argument, naming the place, unless what is given as S_rs can be the
 * probabilities of a medium: every value lies in [0, 1], the fractions (S_rr at lag 0) are > 0 with
 * the sum 1, and at every lag the sum of S_rs over s is c_r. Every value and sum may be off by
 * `tolerance`.
 */
void RequireProbabilities(const TwoPointProbability& probability, double tolerance);
}
