// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/VoxelSlab.h"

#include <cstdint>

namespace ruc
{
/** The basins of a map. */
struct Basins
{
  /** Of each voxel its basin, from 1 in the order of their highest voxels; 0 in the matrix. */
  VoxelSlab<std::int32_t> Number;
  std::int32_t Count = 0;
};

/**
 * Cuts what is above 0 in a map of squared distances into basins, one around each of its marked
 * maxima, as water does that falls on the map turned over (Meyer, Signal Processing 38, 1994).
 *
 * From each voxel water runs to that of its 26 neighbours to which the distance rises most steeply,
 * or among equal distances to the voxel before it, and so to a maximum. Then the basins are joined
 * in the order of the highest passes between them: two where the lower of their maxima is less than
 * `markerHeight` voxels higher than the pass. What remains are the maxima that are higher by that
 * than every pass to one that is higher still. Of two voxels that are equal in all this the first
 * counts, in the order of z, y, x.
 *
 * A rank follows the water in its own planes; where it runs on in those of another, that one knows
 * where it ends. The map has no halo, nor have the basins, which are the same for any number of
 * ranks. Besides both they take some ten bytes a voxel of the surfaces between basins. Collective.
 */
Basins FindBasins(
  VoxelSlab<std::int32_t> squaredDistances, double markerHeight, Communicator& ranks);
}
