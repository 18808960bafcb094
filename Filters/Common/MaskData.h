// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Images/VoxelMask.h"

#include <string>

class RankCommunicator;
class vtkImageData;

/** Images as masks. */
namespace MaskData RUCCOMMON_EXPORT
{
/**
 * Collective: the whole mask on every rank, from the slabs of an image that the ranks hold. Inside
 * are the voxels whose value of `arrayName` (empty: the first array of one component, of points
 * before cells) is `label`, or, for label 0, is not 0; a value that is not a number is outside. A
 * point is the centre of its voxel.
 *
 * Throws std::invalid_argument, the same on every rank, where there is no such array, for an image
 * with turned axes, and where no voxel is inside.
 */
ruc::VoxelMask GatherMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks);
}
