// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/BlurredBalls.h"
#include "ruc/Images/Fit/VoxelSlab.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Returns the maxima of a map of squared distances as balls, those of all ranks on every rank, the
 * largest first and then in the order of voxels. A maximum is not below any of its 26 neighbours,
 * and of equal neighbours the first counts, with the mean place of them. The radius is the distance
 * and 0.4 voxels, which it lacks on average; it is `leastRadius` or more. The map has no halo.
 * Collective.
 */
std::vector<Ball> FindMaxima(
  VoxelSlab<std::int32_t> distances, double leastRadius, const Vector3& edges, Communicator& ranks);

/**
 * Keeps the first ball of those that are taken for one particle: two are where their centres are
 * nearer than the larger radius, or than 0.6 of the sum of both.
 */
std::vector<Ball> KeepFirstOfEach(const std::vector<Ball>& balls);

/**
 * Returns which balls are to be dropped for the depth by which they overlap another one, R_i + R_j
 * - d_ij, being more than `tolerance` times their own diameter. The largest balls are kept, and the
 * others measured against those that are.
 */
std::vector<bool> FindDeepOverlaps(const std::vector<Ball>& balls, double tolerance);

/** Returns for each ball the greatest depth by which it overlaps another one; 0 where it does not.
 */
std::vector<double> FindOverlapDepths(const std::vector<Ball>& balls);
}
