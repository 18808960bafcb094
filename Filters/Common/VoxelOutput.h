// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Images/VoxelGrid.h"

#include "vtkDataSetAttributes.h"
#include "vtkNew.h"

#include <string>

class RankCommunicator;
class vtkImageData;
class vtkInformation;

/** The images that this plugin makes: in pieces, with a value for each voxel on cells or points. */
namespace VoxelOutput RUCCOMMON_EXPORT
{
/**
 * Tells the pipeline of the extent of an image and, where the grid has voxels with edges, of its
 * place and spacing, which else only the run knows.
 */
void Announce(const ruc::VoxelGrid& grid, bool onPoints, vtkInformation* info);

/** Returns the voxels that ParaView expects of this rank. */
ruc::VoxelBlock FindPiece(const ruc::VoxelGrid& grid, bool onPoints, const RankCommunicator& ranks);

/**
 * Gives an image their extent. Since VTK 9.4 it then takes memory for the coordinates along its
 * edges.
 */
void SetPiece(
  vtkImageData* image, const ruc::VoxelGrid& grid, bool onPoints, const RankCommunicator& ranks);

/** The attributes of an image that belong to its voxels. */
vtkDataSetAttributes* VoxelsOf(vtkImageData* image, bool onPoints);

/**
 * Adds an array with a value for each of `count` voxels, not yet set, and returns its values. The
 * first array becomes the active scalars.
 */
template <class Array>
auto Add(vtkDataSetAttributes* voxels, vtkIdType count, const std::string& name)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(count);
  voxels->AddArray(array); // the image keeps it
  if (!voxels->GetScalars())
  {
    voxels->SetActiveScalars(name.c_str());
  }
  return array->GetPointer(0);
}
}
