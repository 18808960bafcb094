// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Images/VoxelGrid.h"

#include <string>
#include <tuple>
#include <vector>

class vtkDataArray;
class vtkImageData;

/** The voxels of an image that comes in: its points, of which each is the centre of one, or its
 * cells. */
struct VoxelPiece
{
  /** The voxels that this rank has, by the numbers of the extent; none where it has no part. */
  ruc::VoxelBlock Block;
  ruc::Vector3 Origin{}, Spacing{}; // of the image: where voxel 0 has its point or lower corner
  bool OfPoints = false;
  /** Their values, x running fastest. They do not go to other ranks. */
  vtkDataArray* Values = nullptr;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Block, self.Origin, self.Spacing, self.OfPoints);
  }
};

namespace VoxelInput RUCCOMMON_EXPORT
{
/**
 * Returns this rank's voxels of an image with the values of an array, which is of one component, on
 * its points or else on its cells. An empty name stands for the first such array. `image` may be
 * null.
 *
 * Throws std::invalid_argument, on this rank, where there is no such array, for an image with
 * turned axes or without thickness, and for an array that is too short. `what` names the image.
 */
VoxelPiece Find(vtkImageData* image, const std::string& arrayName, const char* what);

/**
 * Returns the grid of the whole image, of which the pieces are those of all ranks, and renumbers
 * them so that it begins at voxel 0 0 0. Without voxels all its numbers are 0.
 */
ruc::VoxelGrid FindGrid(std::vector<VoxelPiece>& pieces);
}
