// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/VoxelSlab.h"

#include <cstdint>

namespace ruc
{
/**
 * Returns which of the voxels that are inside, those not 0, have all their points at least `margin`
 * from every outside voxel and from the border of the image. This holds to within 1e-9 of the
 * margin, so that a box shrinks by whole voxels where the margin is a multiple of the spacing. A
 * margin of 0 keeps every voxel. Neither slab has a halo; while at work a rank holds as many planes
 * more on either side as the margin has. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for a margin that RequireMargin refuses,
 * and when no voxel is left.
 */
VoxelSlab<std::uint8_t> ErodeMask(
  VoxelSlab<std::uint8_t> inside, const Vector3& spacing, double margin, Communicator& ranks);
}
