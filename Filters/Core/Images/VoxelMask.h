// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/VoxelSlab.h"
#include "ruc/Images/VoxelGrid.h"
#include "ruc/Window/Window.h"

#include <algorithm>
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
 * A region of any shape, made of the inside voxels of an image with axis-aligned voxels. It keeps
 * no voxels, but where runs of inside voxels along x begin and end: 8 bytes a run and 8 a row,
 * which grows with the surface of the region. Lengths are in the unit of the pack.
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
  /** Takes the ends of all runs, and how many each row has. Throws where there are none. */
  void Take(std::vector<std::int32_t> ends, const std::vector<std::int32_t>& endsOfRow);
  /** Sets the number and the bounds of the inside voxels; throws where there are none. */
  void Enclose();

  /** Calls use(row, begin, end) for all runs of inside voxels begin to end - 1, rows along x in
   * turn. */
  template <class Use>
  void ForEachRun(Use&& use) const;

  bool IsInside(int x, int y, int z) const
  {
    const std::size_t row = y + static_cast<std::size_t>(this->Dimensions[1]) * z;
    const auto begin = this->Ends.begin() + this->FirstEnd[row],
               end = this->Ends.begin() + this->FirstEnd[row + 1];
    return (std::upper_bound(begin, end, x) - begin) % 2 != 0;
  }

  std::array<int, 3> Dimensions{};
  Vector3 Lower{}, Spacing{};
  // Of rows along x: the first inside voxel of a run, the first one after it, and so on
  std::vector<std::int32_t> Ends;
  std::vector<std::int64_t> FirstEnd; // of each row, and the number of all
  Window Bounds;
  std::size_t NumberInside = 0;
};
}
