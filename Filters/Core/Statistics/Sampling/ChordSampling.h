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
 * Returns S_rs of spheres, overlapping or not, by lines through a region. A line meets phases in
 * intervals, and every pair of its points at any lag counts, exactly. A batch of lines is a square
 * grid of parallel lines with an isotropic direction and a random shift
 * (SamplingRegion::ParallelLines), which covers the region evenly. Batches are independent of each
 * other, and the standard errors come from their scatter. About `Samples` lines are drawn. A point
 * in several spheres belongs to the lowest mode, a point in none to the matrix.
 *
 * `own` are the spheres of this rank, with modes 1 to `modes`. They may be any share of the pack,
 * or none, wrapped along periodic axes of the region (WrapIntoBox), whose edges must be longer than
 * the diameters. Spheres outside the region that reach into it must be among them, and the pack
 * must be valid (ValidatePack). All other arguments are the same on all ranks. The result is equal,
 * bit by bit, on every rank, for any number of ranks and threads and for any shares. Collective.
 *
 * `lags.Count` = 0 asks for the fractions alone. `chordLengths`, unless null, is filled in from the
 * same lines.
 *
 * Throws std::invalid_argument, on all ranks, for settings and lags out of range (see CheckSampling
 * and TakeSamples), for `chordLengths` without lags, and for a region too long for its width.
 */
SampledTwoPoint SampleChords(const SpherePack& own, int modes, const SamplingRegion& region,
  const LagGrid& lags, const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress = {}, ChordLengths* chordLengths = nullptr);

/**
 * The same for lines of given directions (of length 1), with one result each, from `Samples` lines
 * each or as many as the TargetError takes. S_rs(r, n) = (C_rs + C_sr) / (2 D) is the mean over n
 * and -n, so that half a sphere of directions is all that there is; Asymmetry tells n from -n.
 */
std::vector<SampledTwoPoint> SampleChordsAlong(const std::vector<Vector3>& directions,
  const SpherePack& own, int modes, const SamplingRegion& region, const LagGrid& lags,
  const SamplingSettings& settings, Communicator& communicator,
  const SamplingProgress& progress = {});

/** What SampleChords takes for this number of lines. */
Estimate EstimateChords(const PackFigures& pack, const LagGrid& lags, double lines);
}
