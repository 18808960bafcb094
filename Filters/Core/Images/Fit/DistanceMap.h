// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/VoxelSlab.h"

#include <cstdint>

namespace ruc
{
/** The squared distance of a voxel in an image in which no voxel is matrix. */
constexpr std::int32_t NoMatrix = 1 << 30;

/** Returns 1 for each voxel of this rank that is above `threshold`, and 0 for all others. */
VoxelSlab<std::uint8_t> FindAbove(const VoxelSlab<float>& image, float threshold);

/**
 * Returns for each voxel of this rank the square of the distance, in voxels, between its centre and
 * that of the nearest voxel of matrix, which is 0 in `particles`; 0 where it is such a voxel
 * itself. What is outside the image counts as particle. The slab has no halo, and the map has none.
 *
 * The map is exact, and so equal for any number of ranks: along z every column needs the nearest
 * planes of matrix on other ranks alone, and what follows along y and x stays within a plane. There
 * the distances are looked for outwards, whole rows at a time, up to the greatest that is found.
 * The grey values, which take as much as the map, need not be kept for it. Collective.
 */
VoxelSlab<std::int32_t> SquaredDistances(VoxelSlab<std::uint8_t> particles, Communicator& ranks);
}
