// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <vector>

namespace ruc
{
/** The mean of the two-point probabilities of several cells, and their scatter. */
struct MeanProbability
{
  TwoPointProbability Mean;
  // Standard deviations over the cells (with n - 1), in the layout of Mean.Fractions and
  // Mean.Values; 0 for a single cell
  std::vector<double> FractionDeviations;
  std::vector<std::vector<double>> Deviations;
};

/**
 * Averages probabilities, of which there is at least one. All must have the same phases and lags.
 */
MeanProbability AverageProbabilities(const std::vector<TwoPointProbability>& probabilities);

/** How far the probabilities of a cell are from those of a pack. */
struct ProbabilityComparison
{
  /** For every mode |c_i of the pack - c_i of the cell| / sum of c_i of the pack x 100 (16). */
  std::vector<double> FractionPercent;
  /**
   * The sum of ||S_rs of the pack - S_rs of the cell|| / the sum of (||S_rs of the pack|| + ||S_rs
   * of the cell||) / 2 x 100, over all ordered pairs of phases (17), with the discrete norms over k
   * = 1…K.
   */
  double Percent;
};

/**
 * Returns equations 16 and 17 of Lee et al., Phys. Rev. E 80, 061301 (2009); in (16) the pack takes
 * the place of the voxel data. Both must have the same phases and lags.
 */
ProbabilityComparison CompareProbabilities(
  const TwoPointProbability& pack, const TwoPointProbability& cell);

/** Returns || a - b ||, where the norm is DiscreteNorm. */
double NormOfDifference(const std::vector<double>& a, const std::vector<double>& b);
}
