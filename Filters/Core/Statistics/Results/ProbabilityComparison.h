// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <vector>

namespace ruc
{
/** The mean of two-point probabilities, of several cells, and their scatter. */
struct MeanProbability
{
  TwoPointProbability Mean;
  // Standard deviation over what was averaged (with n - 1), in the layout of Mean.Fractions and
  // Mean.Values; 0 of a single one
  std::vector<double> FractionDeviations;
  std::vector<std::vector<double>> Deviations;
};

/** All must have the same phases and lags; at least one. Fractions are those of the probabilities.
 */
MeanProbability AverageProbabilities(const std::vector<TwoPointProbability>& probabilities);

/** How far the probabilities of a cell are from those of a pack. */
struct ProbabilityComparison
{
  /** |c_i of the pack - c_i of the cell| / sum of c_i of the pack x 100 of every mode (16). */
  std::vector<double> FractionPercent;
  /** sum ||S_rs of the pack - of the cell|| / sum of (||pack|| + ||cell||) / 2 x 100 over all
   * ordered pairs of phases (17), the discrete norms over k = 1…K. */
  double Percent;
};

/**
 * Equations 16 and 17 of Lee et al., Phys. Rev. E 80, 061301 (2009); in (16) the pack stands for
 * the voxel data. Both must have the same phases and lags.
 */
ProbabilityComparison CompareProbabilities(
  const TwoPointProbability& pack, const TwoPointProbability& cell);

/** || a - b ||, the discrete norm. */
double NormOfDifference(const std::vector<double>& a, const std::vector<double>& b);
}
