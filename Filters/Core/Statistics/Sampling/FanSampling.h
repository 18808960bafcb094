// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/SpherePack.h"
#include "ruc/Statistics/Sampling/SampledSums.h"
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/** The largest number of rays around a circle. */
constexpr int MostFanDirections = 512;

/** Settings of SampleFans. */
struct FanSettings
{
  std::uint32_t Seed = 1;
  std::int64_t Throws = 0; // from 1, or 2 with errors, to 2^31
  bool WithErrors = false; // standard errors, for more than twice the memory
};

/**
 * Throws std::invalid_argument for settings, lags or directions out of range, as SampleFans does.
 */
void CheckFans(
  const SamplingRegion& region, const ThreePointGrid& grid, const FanSettings& settings);

/**
 * How many bytes SampleFans takes on every rank for this number of triples, and its result keeps.
 * `bounded` says whether the region has a border.
 */
double EstimateFanMemory(
  const ThreePointGrid& grid, std::size_t triples, bool withErrors, bool bounded);

/**
 * Returns S_rsq by throws of the paper's template, which has 20 rays of 1000 points and is thrown
 * 50 000 times there. A throw is a random centre in the region and a random plane with M rays
 * spaced evenly around a circle. Points lie at r_k on the rays, k = 0…K; three points count where
 * all are in the region. The counts are those that would result from looking up the phase of every
 * point and going through all K^2 pairs of points of every pair of rays.
 *
 * Instead, every ray is traced once into intervals of phases. A pair of intervals of two rays is a
 * rectangle of the (r1, r2) grid, four corners in its table of second differences, which is summed
 * up at the end. A throw thus costs some (intervals on a ray)^2 M^2 additions in place of K^2 M^2.
 *
 * `own` is this rank's share of the pack, with modes up to `modes`, wrapped into a periodic box. A
 * point in several spheres belongs to the lowest mode. All ranks trace each throw through their own
 * spheres, and one of them counts it. Every rank returns the same, equal bit by bit for any number
 * of ranks and threads. Memory does not depend on the number of throws, but for 24 bytes for each
 * batch of up to 1024 throws and each triple r = s = q with errors. `progress` is asked whether to
 * go on. Collective.
 *
 * Throws std::invalid_argument, on all ranks, for settings, lags or directions out of range.
 */
ThreePointProbability SampleFans(const SpherePack& own, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples, const FanSettings& settings,
  Communicator& communicator, const SamplingProgress& progress = {});

/** What SampleFans takes. The memory is that of a region with a border. */
Estimate EstimateFans(const PackFigures& pack, const ThreePointGrid& grid, std::size_t triples,
  bool withErrors, double throws);
}
