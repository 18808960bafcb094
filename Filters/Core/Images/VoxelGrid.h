// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <array>
#include <cstddef>
#include <tuple>

namespace ruc
{
/** A grid of voxels with edges along the axes, x running fastest. Lengths are in the pack's unit.
 */
struct VoxelGrid
{
  std::array<int, 3> Dimensions{}; // the number of voxels along each axis
  Vector3 Lower{};                 // the lower corner of voxel 0, not its centre
  Vector3 Spacing{};               // the edges of a voxel

  double VoxelVolume() const { return this->Spacing[0] * this->Spacing[1] * this->Spacing[2]; }
  /** The number of voxels, which may be more than an integer holds. */
  double Voxels() const
  {
    return 1.0 * this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
  Vector3 CentreOf(int x, int y, int z) const
  {
    return { this->Lower[0] + (x + 0.5) * this->Spacing[0],
      this->Lower[1] + (y + 0.5) * this->Spacing[1],
      this->Lower[2] + (z + 0.5) * this->Spacing[2] };
  }
};

/** The voxels First to First + Count - 1 of a grid along each axis; some Count is 0 in an empty
 * one. */
struct VoxelBlock
{
  std::array<int, 3> First{};
  std::array<int, 3> Count{};

  std::size_t Voxels() const
  {
    return std::size_t(this->Count[0]) * std::size_t(this->Count[1]) * std::size_t(this->Count[2]);
  }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.First, self.Count);
  }
};

/** The part of a block between two of its planes. */
struct VoxelRange
{
  int First, Last; // voxels of the grid along z; Last is not in it
};

/**
 * Returns the grid of a window. With `dimensions` it has so many voxels between the faces of the
 * window, or of the smallest box around a cylinder. Where they are 0 0 0, voxels are cubes of the
 * edge `voxelSize`, but for a periodic axis, along which whole voxels of about that edge fill the
 * box. Along other axes the image begins at the window's lower face and has as many voxels as lie
 * in the box; one of a cylinder reaches beyond it.
 *
 * Throws std::invalid_argument for a voxelSize that is not finite and > 0, or larger than an edge
 * of the window, for dimensions that are not all >= 1 or all 0, and for more than 2^31 - 2 voxels
 * along an axis.
 */
VoxelGrid MakeVoxelGrid(
  const Window& window, double voxelSize, const std::array<int, 3>& dimensions);
}
