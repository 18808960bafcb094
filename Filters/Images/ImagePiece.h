// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/VoxelGrid.h"

#include <string>

class RankCommunicator;
class vtkDataArray;
class vtkImageData;

/** The part of an image that one rank has, and the grid of the whole. */
struct ImagePiece
{
  ruc::VoxelGrid Grid;   // of the whole image, whose first voxel is voxel 0
  ruc::VoxelBlock Block; // of this rank, with no voxels where it has none
  /** A number for each voxel of the block, x running fastest; null where there are no voxels. */
  vtkDataArray* Array = nullptr;
  std::string Name;
  int DataType = 0; // of VTK; the same on all ranks

  /**
   * Finds the piece with the array of that name on the cells or else the points; an empty name
   * stands for `Phase`, else the first array of one component. A point is the centre of its voxel.
   * Collective.
   *
   * Throws std::invalid_argument, the same on every rank, for an image without voxels, with turned
   * axes or with spacings that are not > 0, where there is no such array or it has other than one
   * component or too few values, where the ranks differ in that, and where they do not have all
   * voxels between them.
   */
  static ImagePiece Find(
    vtkImageData* image, const std::string& arrayName, RankCommunicator& ranks);
};
