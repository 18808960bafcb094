// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/** A part of a straight line between two positions along it. */
struct LineInterval
{
  double Begin, End;
};

/**
 * A region of any shape, made of the inside voxels of an image with axis-aligned voxels. Lengths
 * are in the unit of the pack.
 */
class VoxelMask
{
public:
  /**
   * `inside` holds one number for each voxel, x running fastest; 0 means outside. `lower` is the
   * lower corner of voxel 0, not its centre.
   *
   * Throws std::invalid_argument unless every dimension is >= 1, their product is the size of
   * `inside`, every spacing is finite and > 0, `lower` is finite, and at least one voxel is inside.
   */
  VoxelMask(const std::array<int, 3>& dimensions, const Vector3& lower, const Vector3& spacing,
    std::vector<std::uint8_t> inside);

  const std::array<int, 3>& GetDimensions() const { return this->Dimensions; }
  const Vector3& GetLower() const { return this->Lower; }
  const Vector3& GetSpacing() const { return this->Spacing; }
  const std::vector<std::uint8_t>& GetInside() const { return this->Inside; }

  bool Contains(const Vector3& point) const;

  /** The volume of all inside voxels. */
  double Volume() const;

  /** The smallest box that holds the inside voxels, not periodic. */
  const Window& GetBounds() const { return this->Bounds; }

  /**
   * Returns the mask of those inside voxels all points of which are at least `margin` from every
   * outside voxel and from the border of the image. This holds to within 1e-9 of the margin, so
   * that a box shrinks by whole voxels where the margin is a multiple of the spacing. A margin of 0
   * keeps every voxel. Throws std::invalid_argument for a margin that RequireMargin refuses, and
   * when no voxel is left.
   */
  VoxelMask Eroded(double margin) const;

  /**
   * Replaces `intervals` by the parts of the line start + t direction, 0 <= t <= length, that lie
   * inside. They ascend, and each is as long as it can be. `direction` has length 1.
   */
  void Intersect(const Vector3& start, const Vector3& direction, double length,
    std::vector<LineInterval>& intervals) const;

private:
  /** The part of such a line that lies in the image; Begin >= End where the line misses it. */
  LineInterval ClipToImage(const Vector3& start, const Vector3& direction, double length) const;

  std::size_t VoxelAt(int x, int y, int z) const
  {
    return x +
      static_cast<std::size_t>(this->Dimensions[0]) *
      (y + static_cast<std::size_t>(this->Dimensions[1]) * z);
  }

  std::array<int, 3> Dimensions;
  Vector3 Lower, Spacing;
  std::vector<std::uint8_t> Inside;
  Window Bounds;
  std::size_t NumberInside = 0;
};
}
