// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/VoxelSlab.h"
#include "ruc/Images/VoxelGrid.h"
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
 * A region of any shape, made of the inside voxels of an image with axis-aligned voxels, of which
 * it takes a bit each. Lengths are in the unit of the pack.
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
    const std::vector<std::uint8_t>& inside);

  /**
   * Makes the same mask on every rank, from planes of the image that are the ranks' own. Throws as
   * the constructor, on every rank. Collective.
   */
  static VoxelMask Gather(
    const VoxelGrid& grid, const VoxelSlab<std::uint8_t>& inside, Communicator& ranks);

  const std::array<int, 3>& GetDimensions() const { return this->Dimensions; }
  const Vector3& GetLower() const { return this->Lower; }
  const Vector3& GetSpacing() const { return this->Spacing; }
  /** Returns the places of the inside voxels, x running fastest, in rising order. */
  std::vector<std::size_t> InsideVoxels() const;

  bool Contains(const Vector3& point) const;

  /** The volume of all inside voxels. */
  double Volume() const;

  /** The smallest box that holds the inside voxels, not periodic. */
  const Window& GetBounds() const { return this->Bounds; }

  /** Returns the mask of the voxels that ErodeMask keeps. Throws as that does. */
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

  VoxelMask() = default;
  /** Sets the number and the bounds of the inside voxels; throws where there are none. */
  void Enclose();

  /** Calls use(voxel, whether it is inside) for all voxels, x running fastest. */
  template <class Use>
  void ForEachVoxel(Use&& use) const;

  bool IsInside(int x, int y, int z) const
  {
    const std::size_t row = y + static_cast<std::size_t>(this->Dimensions[1]) * z;
    const std::size_t bytes = (static_cast<std::size_t>(this->Dimensions[0]) + 7) / 8;
    return (this->Bits[row * bytes + x / 8] >> x % 8 & 1) != 0;
  }

  std::array<int, 3> Dimensions{};
  Vector3 Lower{}, Spacing{};
  std::vector<std::uint8_t> Bits; // of rows along x, each of which begins with a byte
  Window Bounds;
  std::size_t NumberInside = 0;
};
}
