// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelOutput.h"

#include "ImageSlab.h"
#include "RankCommunicator.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>

namespace VoxelOutput
{
namespace
{
std::array<int, 6> ExtentOf(const std::array<int, 3>& dimensions, bool onPoints)
{
  std::array<int, 6> extent;
  for (int q = 0; q < 3; ++q)
  {
    extent[2 * q] = 0;
    extent[2 * q + 1] = std::max(dimensions[q], 1) - (onPoints ? 1 : 0);
  }
  return extent;
}

ruc::Vector3 OriginOf(const ruc::VoxelGrid& grid, bool onPoints)
{
  return onPoints ? grid.CentreOf(0, 0, 0) : grid.Lower;
}
}

void Announce(const ruc::VoxelGrid& grid, bool onPoints, vtkInformation* info)
{
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(),
    ExtentOf(grid.Dimensions, onPoints).data(), 6);
  info->Remove(vtkDataObject::ORIGIN());
  info->Remove(vtkDataObject::SPACING());
  if (grid.Spacing[0] > 0.0)
  {
    const ruc::Vector3 origin = OriginOf(grid, onPoints);
    info->Set(vtkDataObject::ORIGIN(), origin.data(), 3);
    info->Set(vtkDataObject::SPACING(), grid.Spacing.data(), 3);
  }
}

ruc::VoxelBlock FindPiece(const ruc::VoxelGrid& grid, bool onPoints, const RankCommunicator& ranks)
{
  const std::array<int, 6> extent = ImageSlab::PieceOf(ExtentOf(grid.Dimensions, onPoints), ranks);
  ruc::VoxelBlock block;
  for (int q = 0; q < 3; ++q)
  {
    block.First[q] = extent[2 * q];
    block.Count[q] = std::max(extent[2 * q + 1] - extent[2 * q] + (onPoints ? 1 : 0), 0);
  }
  return block;
}

void SetPiece(
  vtkImageData* image, const ruc::VoxelGrid& grid, bool onPoints, const RankCommunicator& ranks)
{
  std::array<int, 6> extent = ImageSlab::PieceOf(ExtentOf(grid.Dimensions, onPoints), ranks);
  image->SetExtent(extent.data());
  image->SetSpacing(grid.Spacing.data());
  image->SetOrigin(OriginOf(grid, onPoints).data());
}

vtkDataSetAttributes* VoxelsOf(vtkImageData* image, bool onPoints)
{
  return image->GetAttributes(onPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
}
}
