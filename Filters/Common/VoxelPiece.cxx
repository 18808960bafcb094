// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelPiece.h"

#include "ruc/Base/Text.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace
{
using ruc::Text;

vtkDataArray* FindArray(vtkDataSetAttributes* data, const std::string& name)
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    if (array && array->GetNumberOfComponents() == 1 &&
      (name.empty() || (array->GetName() && name == array->GetName())))
    {
      return array;
    }
  }
  return nullptr;
}
}

VoxelPiece VoxelInput::Find(vtkImageData* image, const std::string& arrayName, const char* what)
{
  VoxelPiece piece;
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return piece;
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument(Text(
      what, " requires an image with axes along x, y and z, got one with a direction matrix."));
  }
  vtkDataArray* array = FindArray(image->GetPointData(), arrayName);
  piece.OfPoints = array != nullptr;
  array = array ? array : FindArray(image->GetCellData(), arrayName);
  if (!array)
  {
    throw std::invalid_argument(Text(what, " requires an image with an array",
      arrayName.empty() ? "" : " '" + arrayName + "'",
      " of one component on its points or cells, got none."));
  }
  const int* extent = image->GetExtent();
  for (int q = 0; q < 3; ++q)
  {
    piece.Origin[q] = image->GetOrigin()[q];
    piece.Spacing[q] = image->GetSpacing()[q];
    piece.Block.First[q] = extent[2 * q];
    piece.Block.Count[q] = extent[2 * q + 1] - extent[2 * q] + (piece.OfPoints ? 1 : 0);
    if (piece.Block.Count[q] < 1)
    {
      throw std::invalid_argument(Text(
        what, " requires an image with voxels in all three directions, got one that is flat."));
    }
  }
  if (static_cast<std::size_t>(array->GetNumberOfTuples()) < piece.Block.Voxels())
  {
    throw std::invalid_argument(Text(what, " requires an array with a value for each of ",
      piece.Block.Voxels(), " voxels, got ", array->GetNumberOfTuples(), "."));
  }
  piece.Values = array;
  return piece;
}

ruc::VoxelGrid VoxelInput::FindGrid(std::vector<VoxelPiece>& pieces)
{
  ruc::VoxelGrid grid;
  std::array<int, 3> first, end;
  first.fill(std::numeric_limits<int>::max());
  end.fill(std::numeric_limits<int>::min());
  const VoxelPiece* any = nullptr;
  for (const VoxelPiece& piece : pieces)
  {
    for (int q = 0; q < 3 && piece.Block.Voxels() > 0; ++q)
    {
      any = any ? any : &piece;
      first[q] = std::min(first[q], piece.Block.First[q]);
      end[q] = std::max(end[q], piece.Block.First[q] + piece.Block.Count[q]);
    }
  }
  if (!any)
  {
    return grid;
  }
  for (int q = 0; q < 3; ++q)
  {
    grid.Dimensions[q] = end[q] - first[q];
    grid.Spacing[q] = any->Spacing[q];
    grid.Lower[q] = any->Origin[q] + (first[q] - 0.5 * any->OfPoints) * any->Spacing[q];
  }
  for (VoxelPiece& piece : pieces)
  {
    for (int q = 0; q < 3; ++q)
    {
      piece.Block.First[q] -= piece.Block.Voxels() > 0 ? first[q] : 0;
    }
  }
  return grid;
}
