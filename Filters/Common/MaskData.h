// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Images/VoxelMask.h"

#include <string>

class RankCommunicator;
class vtkImageData;

/** Images that serve as masks. */
namespace MaskData RUCCOMMON_EXPORT
{
/**
 * Returns the whole mask on every rank, from the slabs of an image that the ranks hold. A voxel is
 * inside where its value in `arrayName` is `label`, or, for label 0, is not 0; a value that is not
 * a number is outside. An empty name stands for the first array of one component, of the points or
 * else of the cells. A point is the centre of its voxel. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, where there is no such array, for an image
 * with turned axes or without thickness, and where no voxel is inside.
 */
ruc::VoxelMask GatherMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks);
}
