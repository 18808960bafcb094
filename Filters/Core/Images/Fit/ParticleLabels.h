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
 * Labels this rank's voxels by the ball to whose surface each is nearest, |x - c_i| - R_i, of those
 * with the centre within 1.5 radii and a voxel. It gets the ball's number, from 1, where the image
 * less all other balls, Contrast B_i + residual, is above the value that the model has on the
 * surface of the ball; else 0. So the voxels of a ball have its volume, also among neighbours,
 * whose blur makes what is between them brighter. The residual has no halo.
 */
VoxelSlab<std::int32_t> LabelVoxels(
  const VoxelSlab<float>& residual, const GreyModel& model, const std::vector<Ball>& balls);

/** The voxels of a label, as they are counted. */
struct ParticleShape
{
  double Volume = 0.0;  // in mean voxels
  double Surface = 0.0; // in squares of their edge
  Vector3 Centre{};     // of the volume
  int BorderFaces = 0;  // of the image that its voxels touch
  double Reach = 0.0;   // from the centre to the farthest face of a voxel, along an axis

  /** The radius of a ball of that volume. */
  double EqualVolumeRadius() const;
  /** The surface of that ball over that of the particle; NaN where it has none. */
  double Sphericity() const;
};

/**
 * Returns the shapes of the labels 1 to `count`, the same on all ranks. The surface is that of
 * Crofton's formula: from the neighbours of all 13 directions of which one has the label and the
 * other has not, with the weights of directions on the sphere. It is good to some per cent from ten
 * voxels on. The border of the image is no surface. The slab has no halo. Collective.
 */
std::vector<ParticleShape> MeasureShapes(
  VoxelSlab<std::int32_t> labels, std::int32_t count, const Vector3& edges, Communicator& ranks);
}
