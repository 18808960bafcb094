// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Images/Slabs.h"
#include "ruc/Images/VoxelGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace ruc
{
/** Voxels that belong to no phase, as they lie outside a mask. */
constexpr std::uint8_t OutsideMask = 255;

/** The phases of the voxels of a block, x running fastest; none where the block is empty. */
struct PhaseBlock
{
  VoxelBlock Block;
  std::vector<std::uint8_t> Phases;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Block, self.Phases);
  }
};

/**
 * The planes of an image that a rank holds where it is cut across one axis, y (1) or z (2). The
 * rank has its range of planes; in a plane x runs fastest.
 */
struct PhaseSlab
{
  int Axis;
  std::array<int, 3> Dimensions; // of the whole image
  Slabs Planes;
  int Rank;
  std::vector<std::uint8_t> Phases;

  int Begin() const { return static_cast<int>(this->Planes.Begin(this->Rank)); }
  int End() const { return static_cast<int>(this->Planes.End(this->Rank)); }
  /** The rows of a plane run along the axis of y and z that is not cut. */
  int Rows() const { return this->Dimensions[3 - this->Axis]; }
  /** The first voxel of a row of plane `plane` of the image, which this rank holds. */
  const std::uint8_t* Row(int plane, int row) const
  {
    return this->Phases.data() + this->PlaceOf(plane, row);
  }
  std::uint8_t* Row(int plane, int row) { return this->Phases.data() + this->PlaceOf(plane, row); }

private:
  std::size_t PlaceOf(int plane, int row) const
  {
    return (static_cast<std::size_t>(plane - this->Begin()) * this->Rows() + row) *
      static_cast<std::size_t>(this->Dimensions[0]);
  }
};

/**
 * Spreads an image over the ranks in slabs across an axis, from the blocks that the ranks have of
 * it, which begin at voxel 0 0 0. Blocks may overlap, as those of points do; the values in the
 * overlap are the same in both. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, where voxels are in no block.
 */
PhaseSlab SpreadPhases(
  const PhaseBlock& own, const std::array<int, 3>& dimensions, int axis, Communicator& ranks);

/** Cuts an image that is in slabs across another axis. Collective. */
PhaseSlab CutAcross(const PhaseSlab& image, int axis, Communicator& ranks);
}
