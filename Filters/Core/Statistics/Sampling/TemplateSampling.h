// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/SpherePack.h"
#include "ruc/Statistics/Sampling/SampledSums.h"
#include "ruc/Tracing/SamplingRegion.h"

namespace ruc
{
/** The number of rays of a template, spaced evenly around a great circle. */
constexpr int NumberOfRays = 20;

/**
 * Returns S_rs by the paper's sampling template (Fig. 4). A throw puts its centre at a random point
 * of the region and turns its plane at random. On each of the rays from the centre lie points at
 * r_k, k = 1…K, and the phase of every point is looked up. Pairs with a point outside the region do
 * not count. This is a plain reference for SampleChords, which is far cheaper for the same error
 * and has the same contract and arguments.
 */
SampledTwoPoint SampleTemplate(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress = {});

/** What SampleTemplate takes for this number of throws. */
Estimate EstimateTemplate(const PackFigures& pack, const LagGrid& lags, double throws);
}
