// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace ruc
{
/**
 * Exact S_rs of a pack of spheres, as a sum over pairs of the orientation-averaged overlap
 * (Geometry/SphereOverlap.h):
 *
 *     S_rs(r) = delta_rs / V sum_i V_ii(r)
 *               + sum over i in r, j in s, i != j of g(r; d_ij) / gamma(d_ij)
 *
 * with V the volume of the window of the centres and gamma its set covariance; over all images
 * along periodic axes. It is unbiased for a stationary pack, without clipping spheres at the border
 * of the window. Spheres that overlap are counted twice where they do.
 *
 * The pack may be spread over ranks (PackShare): every rank works on its share and the surroundings
 * within r_K + a + b that it asks the others for. The work is a number of chunks; a chunk
 * adds integers to an array of SumsSize(), so the chunks may be shared out in any way and the
 * arrays of different threads and ranks added up. Few sphere types (mode and radius) share tables
 * over the distance, with an error below 1e-6 c_r (1e-5 where lags are much finer than the
 * spheres); many use the closed form for every pair.
 */
class ExactPairSum
{
public:
  /**
   * Collective. Throws std::invalid_argument, the same on every rank, for lags out of range: see
   * LagLimit::ForPairSum.
   */
  ExactPairSum(const PackShare& share, const LagGrid& lags, Communicator& ranks);
  /** For one rank that holds all of a pack, in any order. */
  ExactPairSum(const SpherePack& pack, const Window& window, const LagGrid& lags);
  ~ExactPairSum();

  /** Of this rank. */
  std::size_t NumberOfChunks() const;
  /** The same on every rank. */
  std::size_t SumsSize() const;

  /**
   * Adds the chunks first, first + stride, …, on all threads of OpenMP, to `sums`. `progress` is
   * told the share that is done, on the calling thread.
   */
  void AddChunks(std::size_t first, std::size_t stride, std::int64_t* sums,
    const std::function<void(double)>& progress = {}) const;

  /** From the sums over all chunks of all ranks. */
  TwoPointProbability Result(const std::vector<std::int64_t>& sums) const;

private:
  class Method;
  class Tabulated;
  class Direct;
  std::unique_ptr<Method> Sum;
};
}
