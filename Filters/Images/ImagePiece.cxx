// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ImagePiece.h"

#include "PackData.h"
#include "RankCommunicator.h"
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
  ruc::VoxelBlock Block;
  ruc::Vector3 Origin{}, Spacing{};
  bool OfPoints = false;
  int DataType = 0;
  std::string Name;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Block, self.Origin, self.Spacing, self.OfPoints, self.DataType, self.Name);
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
  slab.OfPoints = !array;
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
    slab.Block.First[q] = extent[2 * q];
    slab.Block.Count[q] = std::max(extent[2 * q + 1] - extent[2 * q] + (slab.OfPoints ? 1 : 0), 0);
    slab.Origin[q] = image->GetOrigin()[q];
    slab.Spacing[q] = image->GetSpacing()[q];
  }
  if (static_cast<std::size_t>(array->GetNumberOfTuples()) < slab.Block.Voxels())
  {
    throw std::invalid_argument(Text("Array '", array->GetName(), "' requires a value for each of ",
      slab.Block.Voxels(), " voxels, got ", array->GetNumberOfTuples(), "."));
  }
  slab.DataType = array->GetDataType();
  slab.Name = array->GetName();
  return slab.Block.Voxels() > 0 ? array : nullptr;
}

bool AreOfOneImage(const Slab& a, const Slab& b)
{
  return std::tie(a.Origin, a.Spacing, a.OfPoints, a.DataType, a.Name) ==
    std::tie(b.Origin, b.Spacing, b.OfPoints, b.DataType, b.Name);
}

// Returns the voxels of all slabs together, and the place of the first
ruc::VoxelBlock FindWhole(const std::vector<Slab>& slabs)
{
  ruc::VoxelBlock whole = slabs.front().Block;
  double voxels = 0.0;
  for (const Slab& slab : slabs)
  {
    for (int q = 0; q < 3; ++q)
    {
      const int end =
        std::max(whole.First[q] + whole.Count[q], slab.Block.First[q] + slab.Block.Count[q]);
      whole.First[q] = std::min(whole.First[q], slab.Block.First[q]);
      whole.Count[q] = end - whole.First[q];
    }
    voxels += static_cast<double>(slab.Block.Voxels());
  }
  // Pieces of points share planes
  const double all = 1.0 * whole.Count[0] * whole.Count[1] * whole.Count[2];
  if (voxels < all)
  {
    throw std::invalid_argument(Text(
      "Input requires all ", all, " voxels of the image on the ranks together, got ", voxels, "."));
  }
  return whole;
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
  std::vector<Slab> slabs = ranks.AllGather(own);
  slabs.erase(std::remove_if(slabs.begin(), slabs.end(),
                [](const Slab& slab) { return slab.Block.Voxels() == 0; }),
    slabs.end());
  if (slabs.empty())
  {
    throw std::invalid_argument("Input requires an image with voxels, got none.");
  }
  const Slab& first = slabs.front();
  for (const Slab& slab : slabs)
  {
    if (!AreOfOneImage(slab, first))
    {
      throw std::invalid_argument(Text("Input requires pieces of one image, got arrays '",
        first.Name, "' and '", slab.Name, "' or other types, origins or spacings."));
    }
  }
  const ruc::VoxelBlock whole = FindWhole(slabs);
  piece.Block = own.Block;
  piece.Grid.Dimensions = whole.Count;
  piece.Grid.Spacing = first.Spacing;
  for (int q = 0; q < 3; ++q)
  {
    piece.Block.First[q] -= piece.Array ? whole.First[q] : 0;
    piece.Grid.Lower[q] =
      first.Origin[q] + (whole.First[q] - (first.OfPoints ? 0.5 : 0.0)) * first.Spacing[q];
  }
  piece.Name = first.Name;
  piece.DataType = first.DataType;
  return piece;
}
