// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/PairSums/SumRounds.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <vector>

namespace ruc
{
/**
 * S_rs(r_k n) along single directions n. Values are the mean over n and -n, so that S_rs = S_sr,
 * and directions over half a sphere are all that there are.
 */
struct DirectionalProbability
{
  std::vector<Vector3> Directions;         // of length 1
  std::vector<TwoPointProbability> Values; // one for every direction
  /**
   * Standard errors for every direction, as absolute probabilities in the layout of
   * TwoPointProbability::Values. Empty for an exact method.
   */
  std::vector<std::vector<std::vector<double>>> Errors;
};

/**
 * Returns the exact S_rs of a pack of spheres along directions, as a sum over pairs of the lens
 * volume V_ij (SphereOverlap.h):
 *
 *     S_rs(r n) = delta_rs / V sum_i V_ii(r)
 *                 + sum over i in r, j in s, i != j of V_ij(|d_ij - r n|) / gamma(d_ij)
 *
 * V is the volume of the window of the centres and gamma its set covariance. The sum is symmetrised
 * over n and -n. Weights, images and overlap are treated as in SumPairs, whose S_rs is the average
 * of this one over all directions. No tables are used, so that the error is that of rounding (2^-34
 * of the largest sphere's volume for a pair).
 *
 * The result is equal, bit by bit, on every rank and for any number of ranks and threads.
 * Throws where `progress` says to stop. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for lags that SumPairs would refuse, for no
 * directions or some that are not of length 1, and for more than 5e7 numbers (directions x pairs of
 * phases x lags).
 */
DirectionalProbability SumPairsAlong(const PackShare& share, const std::vector<Vector3>& directions,
  const LagGrid& lags, Communicator& ranks, const SumProgress& progress = {});

/**
 * Returns the mean over the directions, each with the same weight, of the functions and of the
 * fractions.
 */
TwoPointProbability MeanOverDirections(const DirectionalProbability& probability);

/**
 * Returns the isotropy deviation sigma_Srs(r_k): the sample standard deviation (divided by M - 1)
 * of S_rs(r_k n) over the M directions, for every unordered pair of phases. It is NaN for a single
 * direction. Part of it is due to the pack being finite.
 */
std::vector<std::vector<double>> IsotropyDeviation(const DirectionalProbability& probability);

/**
 * Returns the isotropy deviation that sampling errors alone would cause: the root of the mean
 * square of Errors over the directions, 0 for an exact method.
 */
std::vector<std::vector<double>> IsotropyNoise(const DirectionalProbability& probability);

/** What SumPairsAlong takes. */
Estimate EstimatePairSumAlong(const PackFigures& pack, const LagGrid& lags, int directions);
}
