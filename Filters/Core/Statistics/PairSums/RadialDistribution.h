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
 * Radial distribution functions of the centres, in bins [r_k - Spacing / 2, r_k + Spacing / 2)
 * around the lags; the first bin is [0, Spacing / 2). There are no standard errors, since one pack
 * is one sample, and its pairs are not independent of each other.
 */
struct RadialDistribution
{
  LagGrid Lags;
  int Modes;
  std::vector<std::vector<double>> Values; // unordered pairs of modes: (1,1), (1,2), …, (2,2), …
  std::vector<double> Total;               // all centres, whatever their mode

  /** The place in Values of a pair of modes, counted from 0. */
  int PairOf(int r, int s) const;
};

/**
 * Returns the exact radial distribution functions
 *
 *     g_rs(r_k) = [sum over ordered pairs i in r, j in s, i != j, with d_ij in bin k,
 *                  of V / gamma(d_ij)] / (N shell_k / V).
 *
 * V is the volume of the window of the centres, gamma its set covariance, shell_k the volume of the
 * bin, and N the number of ordered pairs of centres, N_r N_s or N_r (N_r - 1). Centres placed
 * independently have g = 1. Along periodic axes all images count, those of the sphere itself too. g
 * is NaN where N is 0.
 *
 * The result is equal, bit by bit, on every rank and for any number of ranks and threads.
 * Throws where `progress` says to stop. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for a number of lags out of range
 * (CheckNumberOfLags) and for lags that LagLimit::ForDistances refuses.
 */
RadialDistribution MeasureRadialDistribution(const PackShare& share, const LagGrid& lags,
  Communicator& ranks, const SumProgress& progress = {});

/** What MeasureRadialDistribution takes. */
Estimate EstimateRadialDistribution(const PackFigures& pack, const LagGrid& lags);
}
