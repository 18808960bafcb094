// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/PairSums/SumRounds.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

namespace ruc
{
/**
 * Returns the exact S_rs of a pack of spheres, as a sum over pairs of the orientation-averaged
 * overlap (SphereOverlap.h):
 *
 *     S_rs(r) = delta_rs / V sum_i V_ii(r)
 *               + sum over i in r, j in s, i != j of g(r; d_ij) / gamma(d_ij)
 *
 * V is the volume of the window of the centres and gamma its set covariance. The sum runs over all
 * images along periodic axes. It is unbiased for a stationary pack, without clipping spheres at the
 * border of the window. Where spheres overlap, the shared volume is counted twice.
 *
 * A few types of spheres (mode and radius) share tables over the distance, with an error below 1e-6
 * c_r (1e-5 where lags are much finer than the spheres). For many types the closed form is used for
 * every pair.
 *
 * The result is equal, bit by bit, on every rank and for any number of ranks and threads.
 * Throws where `progress` says to stop. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for a number of lags out of range
 * (CheckNumberOfLags) and for lags that LagLimit::ForPairSum refuses.
 */
TwoPointProbability SumPairs(const PackShare& share, const LagGrid& lags, Communicator& ranks,
  const SumProgress& progress = {});

/** The same for one rank that holds the whole pack, in any order. */
TwoPointProbability SumPairs(const SpherePack& pack, const Window& window, const LagGrid& lags);

/** What SumPairs takes. */
Estimate EstimatePairSum(const PackFigures& pack, const LagGrid& lags);
}
