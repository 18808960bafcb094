// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ImagePiece.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "VoxelPiece.h"
#include "ruc/Base/Text.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace
{
using ruc::Text;

// What a rank has, as the others must know it
struct Slab
{
  VoxelPiece Voxels;
  int DataType = 0;
  std::string Name;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Voxels, self.DataType, self.Name);
  }
};

// An array of any number of components, for the message about them
vtkDataArray* FindArray(vtkDataSetAttributes* data, const std::string& name)
{
  if (!name.empty())
  {
    return data->GetArray(name.c_str());
  }
  vtkDataArray* found = data->GetArray("Phase");
  for (int a = 0; !found && a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    found = array && array->GetName() && array->GetNumberOfComponents() == 1 ? array : nullptr;
  }
  return found;
}

void CheckImage(vtkImageData* image)
{
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument(
      "Input requires an image with axes along x, y and z, got one with turned axes.");
  }
  for (int q = 0; q < 3; ++q)
  {
    const double h = image->GetSpacing()[q], origin = image->GetOrigin()[q];
    if (!(h > 0.0 && std::isfinite(h) && std::isfinite(origin)))
    {
      throw std::invalid_argument(
        Text("Input requires an image with a finite origin and spacings > 0, got ", origin, " and ",
          h, "."));
    }
  }
}

vtkDataArray* ReadSlab(vtkImageData* image, const std::string& name, Slab& slab)
{
  CheckImage(image);
  vtkDataArray* array = FindArray(image->GetCellData(), name);
  VoxelPiece& voxels = slab.Voxels;
  voxels.OfPoints = !array;
  array = array ? array : FindArray(image->GetPointData(), name);
  if (!array)
  {
    throw std::invalid_argument(Text("ImageArray requires an array of one component",
      name.empty() ? std::string() : " '" + name + "'", ", got on cells ",
      PackData::ListArrays(image->GetCellData()), " and on points ",
      PackData::ListArrays(image->GetPointData()), "."));
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(Text("Array '", array->GetName(), "' requires one component, got ",
      array->GetNumberOfComponents(), "."));
  }
  const int* extent = image->GetExtent();
  for (int q = 0; q < 3; ++q)
  {
    voxels.Block.First[q] = extent[2 * q];
    voxels.Block.Count[q] =
      std::max(extent[2 * q + 1] - extent[2 * q] + (voxels.OfPoints ? 1 : 0), 0);
    voxels.Origin[q] = image->GetOrigin()[q];
    voxels.Spacing[q] = image->GetSpacing()[q];
  }
  if (static_cast<std::size_t>(array->GetNumberOfTuples()) < voxels.Block.Voxels())
  {
    throw std::invalid_argument(Text("Array '", array->GetName(), "' requires a value for each of ",
      voxels.Block.Voxels(), " voxels, got ", array->GetNumberOfTuples(), "."));
  }
  slab.DataType = array->GetDataType();
  slab.Name = array->GetName();
  return voxels.Block.Voxels() > 0 ? array : nullptr;
}

bool AreOfOneImage(const Slab& a, const Slab& b)
{
  return std::tie(a.Voxels.Origin, a.Voxels.Spacing, a.Voxels.OfPoints, a.DataType, a.Name) ==
    std::tie(b.Voxels.Origin, b.Voxels.Spacing, b.Voxels.OfPoints, b.DataType, b.Name);
}
}

ImagePiece ImagePiece::Find(
  vtkImageData* image, const std::string& arrayName, RankCommunicator& ranks)
{
  ImagePiece piece;
  Slab own;
  ranks.Agree(
    [&]()
    {
      if (image && image->GetNumberOfPoints() > 0)
      {
        piece.Array = ReadSlab(image, arrayName, own);
      }
    });
  const std::vector<Slab> slabs = ranks.AllGather(own);
  const Slab* first = nullptr; // that has voxels
  std::vector<VoxelPiece> pieces;
  double voxels = 0.0;
  for (const Slab& slab : slabs)
  {
    pieces.push_back(slab.Voxels);
    if (slab.Voxels.Block.Voxels() == 0)
    {
      continue;
    }
    first = first ? first : &slab;
    voxels += static_cast<double>(slab.Voxels.Block.Voxels());
    if (!AreOfOneImage(slab, *first))
    {
      throw std::invalid_argument(Text("Input requires pieces of one image, got arrays '",
        first->Name, "' and '", slab.Name, "' or other types, origins or spacings."));
    }
  }
  if (!first)
  {
    throw std::invalid_argument("Input requires an image with voxels, got none.");
  }
  piece.Grid = VoxelInput::FindGrid(pieces);
  if (voxels < piece.Grid.Voxels()) // pieces of points share planes
  {
    throw std::invalid_argument(Text("Input requires all ", piece.Grid.Voxels(),
      " voxels of the image on the ranks together, got ", voxels, "."));
  }
  piece.Block = pieces[static_cast<std::size_t>(ranks.Rank())].Block;
  piece.Name = first->Name;
  piece.DataType = first->DataType;
  return piece;
}
