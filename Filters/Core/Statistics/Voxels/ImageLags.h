// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"
#include "ruc/Statistics/Results/LagGrid.h"

#include <array>
#include <vector>

namespace ruc
{
/** The lags of the statistics of an image. Lengths are in the unit of the image. */
struct ImageLags
{
  LagGrid Lags;
  Vector3 Spacing; // the edges of a voxel
  /** How many voxels the last lag reaches along each axis; 0 where there is just one voxel. */
  std::array<int, 3> Last;

  /** The least edge of a voxel. */
  double VoxelEdge() const;

  /**
   * Vectors of about the same length are counted together, in shells: shell n has the vectors of
   * integer length squared n in units of VoxelEdge, or, where voxels are not cubes, those for which
   * that is nearest to n.
   */
  int Shells() const;
  /** The shell of the vector (x, y, z), in voxels, or -1 where it is longer than the last lag. */
  int ShellOf(int x, int y, int z) const;
  /** The mean length of the vectors of every shell; NaN where it has none. */
  std::vector<double> ShellLengths() const;
};

/**
 * Returns the lags k maximum / count, k = 0 … count, of an image. The largest maximum is half the
 * shortest edge of the image, of those that have more than one voxel. A maximum of 0 stands for as
 * many voxels as reach over a quarter of it, one at least, and a count of 0 for one lag a voxel.
 *
 * Throws std::invalid_argument for a maximum or a count that is out of range, and where lags would
 * be closer than a voxel's least edge, so that some had no voxels between them.
 */
ImageLags FindImageLags(
  const std::array<int, 3>& dimensions, const Vector3& spacing, double maximum, int count);
}
