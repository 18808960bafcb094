// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Slabs.h"
#include "ruc/Images/VoxelGrid.h"

#include <array>
#include <cstddef>

namespace ruc
{
/**
 * The periodic cell whose properties are solved for: the voxels of a grid, or, where `Mirrored`,
 * these and their mirror images in x, y and z, which are periodic whatever lies in the grid. A
 * mirrored cell has twice as many voxels along each axis.
 */
struct CellGrid
{
  VoxelGrid Source;
  bool Mirrored = false;

  std::array<int, 3> Dimensions() const
  {
    const int times = this->Mirrored ? 2 : 1;
    const std::array<int, 3>& n = this->Source.Dimensions;
    return { times * n[0], times * n[1], times * n[2] };
  }
  /** The voxel of the grid that voxel i of the cell is, or is the image of, along an axis. */
  int SourceOf(int axis, int i) const
  {
    const int n = this->Source.Dimensions[axis];
    return i < n ? i : 2 * n - 1 - i;
  }
  bool IsImage(int axis, int i) const { return i >= this->Source.Dimensions[axis]; }
};

/**
 * The planes z of a cell that a rank works on. Unknowns are at the lower corners of voxels, those
 * of the planes Begin to End - 1 belong to the rank. The equations of these corners take the voxels
 * of the planes Begin - 1 to End - 1, one plane more, which are counted from 0 here.
 */
struct CellSlab : CellGrid
{
  CellSlab(const CellGrid& cell, int rank, int ranks)
    : CellGrid(cell)
    , Planes{ cell.Dimensions()[2], ranks }
    , Begin(static_cast<int>(this->Planes.Begin(rank)))
    , End(static_cast<int>(this->Planes.End(rank)))
  {
  }
  Slabs Planes;
  int Begin, End;

  int OwnPlanes() const { return this->End - this->Begin; }
  int VoxelPlanes() const { return this->OwnPlanes() > 0 ? this->OwnPlanes() + 1 : 0; }
  /** The plane of the cell that is voxel plane n of this rank. */
  int PlaneOf(int n) const
  {
    const int count = static_cast<int>(this->Planes.Count);
    return (this->Begin - 1 + n + count) % count;
  }
  std::size_t PlaneSize() const
  {
    return std::size_t(this->Dimensions()[0]) * this->Dimensions()[1];
  }
};
}
