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
/** Rays around a circle. */
constexpr int MostFanDirections = 512;

struct FanSettings
{
  std::uint32_t Seed = 1;
  std::int64_t Throws = 0; // 1 to 2^31
  bool WithErrors = false; // standard errors, at the cost of three times the memory
};

/** Throws std::invalid_argument for settings, lags or directions out of range, as SampleFans does.
 */
void CheckFans(
  const SamplingRegion& region, const ThreePointGrid& grid, const FanSettings& settings);

/** Bytes that SampleFans takes on every rank for so many triples, and its result keeps: `bounded`
 * where the region has a border. */
double EstimateFanMemory(
  const ThreePointGrid& grid, std::size_t triples, bool withErrors, bool bounded);

/**
 * S_rsq by throws of the paper's template (50 000 of 20 rays and 1000 points there): a random
 * centre in the region and a random plane with M rays evenly around a circle. Points are at r_k on
 * the rays, k = 0…K; three of them outside the region do not count. What is counted is what looking
 * the phase of every point up and going through all K^2 pairs of points of every pair of rays would
 * count.
 *
 * Instead every ray is traced once into intervals of phases. A pair of intervals of two rays is a
 * rectangle of the (r1, r2) grid, four corners in its table of second differences, which is summed
 * up at the end; a throw costs some (intervals on a ray)^2 M^2 additions in place of K^2 M^2.
 *
 * `own` is this rank's share of the pack, with modes up to `modes`, wrapped into a periodic box; a
 * point in several spheres belongs to the lowest mode. Throws are traced by all ranks through their
 * own spheres and counted by one of them. Collective; every rank returns the same, equal bit by bit
 * for any number of ranks and threads. Memory does not depend on the number of throws, but for 24
 * bytes for every 1024 of them with errors.
 * Throws std::invalid_argument, on all ranks, for settings, lags or directions out of range.
 */
ThreePointProbability SampleFans(const SpherePack& own, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples, const FanSettings& settings,
  Communicator& communicator, const SamplingProgress& progress = {});

/** What SampleFans takes; its memory is that with a border. */
Estimate EstimateFans(const PackFigures& pack, const ThreePointGrid& grid, std::size_t triples,
  bool withErrors, double throws);
}
