// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Images/Fit/VoxelSlab.h"
#include "ruc/Images/VoxelGrid.h"

#include <cstdint>
#include <string>

class RankCommunicator;
class vtkImageData;

/** Images that serve as masks. */
namespace MaskData RUCCOMMON_EXPORT
{
/** A mask of which every rank has the planes of Slabs, with 0 for the voxels outside. */
struct Mask
{
  ruc::VoxelGrid Grid;
  ruc::VoxelSlab<std::uint8_t> Inside;
};

/**
 * Spreads the mask over the ranks, from the pieces of an image that they hold. A voxel is inside
 * where its value in `arrayName` is `label`, or, for label 0, is not 0; a value that is not a
 * number is outside. An empty name stands for the first array of one component, of the points or
 * else of the cells. A point is the centre of its voxel. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, where there is no such array, for an image
 * with turned axes or without thickness, and where voxels are in no piece.
 */
Mask SpreadMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks);
}
