// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/SpherePack.h"
#include "ruc/Statistics/Sampling/ChordLengths.h"
#include "ruc/Statistics/Sampling/SampledSums.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * S_rs of spheres, overlapping or not, by lines through a region: a line meets phases in intervals,
 * and every pair of its points at any lag counts, exactly. A batch of lines is a square grid of
 * parallel ones with an isotropic direction and a random shift (SamplingRegion::ParallelLines),
 * which covers the region evenly; batches are independent of each other, and the standard errors
 * are from their scatter. `Samples` lines are about so many. A point in several spheres belongs to
 * the lowest mode, one in none to the matrix.
 *
 * `own` are the spheres of this rank, modes 1 to `modes`: any share of the pack, none included,
 * with periodic axes of the region wrapped (WrapIntoBox) and longer than the diameters. Spheres
 * outside the region that reach into it must be there; the pack must be valid (ValidatePack).
 * Everything else is the same on all ranks. Collective; the result is equal, bit by bit, on every
 * rank, for any number of ranks and threads and any shares.
 *
 * `lags.Count` = 0 asks for the fractions alone. `chordLengths`, unless null, is filled in from the
 * same lines.
 * Throws std::invalid_argument, on all ranks, for settings and lags out of range: see CheckSampling
 * and TakeSamples; and for `chordLengths` without lags.
 */
SampledTwoPoint SampleChords(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress = {}, ChordLengths* chordLengths = nullptr);

/**
 * The same for lines of given directions (of length 1), one result each, from `Samples` lines each
 * or as many as the TargetError takes. S_rs(r, n) = (C_rs + C_sr) / (2 D) is the mean over n and
 * -n, so half a sphere of directions is all there are; Asymmetry tells n from -n.
 */
std::vector<SampledTwoPoint> SampleChordsAlong(const std::vector<Vector3>& directions,
  const SpherePack& own, int modes, const SamplingRegion& region, const LagGrid& lags,
  const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress = {});

/** What SampleChords takes for so many lines. */
Estimate EstimateChords(const PackFigures& pack, const LagGrid& lags, double lines);
}
