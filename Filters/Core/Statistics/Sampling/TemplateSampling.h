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
/** Rays of a template, evenly around a great circle. */
constexpr int NumberOfRays = 20;

/**
 * S_rs by the paper's sampling template (Fig. 4): a throw puts its centre at a random point of the
 * region and turns its plane at random; on each of the rays from the centre lie points at r_k, k =
 * 1…K, and the phase of every point is looked up. Pairs with a point outside the region do not
 * count. A plain reference for SampleChords, which is far cheaper for the same error, with the same
 * contract and arguments.
 */
SampledTwoPoint SampleTemplate(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress = {});

/** What SampleTemplate takes for so many throws. */
Estimate EstimateTemplate(const PackFigures& pack, const LagGrid& lags, double throws);
}
