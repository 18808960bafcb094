// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MaskData.h"

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
#include <cstdint>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
using ruc::Text;

// The part of the mask that one rank has. It has no voxels where the rank has none.
struct Slab
{
  std::array<int, 3> First{}, Last{}; // voxels, both included
  ruc::Vector3 Origin{}, Spacing{};   // of the image: where voxel 0 has its point or lower corner
  bool OfPoints = false;              // whether voxels are points, not cells
  std::vector<std::uint8_t> Inside;   // 0 for voxels outside, x running fastest

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.First, self.Last, self.Origin, self.Spacing, self.OfPoints, self.Inside);
  }
};

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

Slab LocalSlab(vtkImageData* image, const std::string& name, int label)
{
  Slab slab;
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return slab;
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument(
      "Mask requires an image with axes along x, y and z, got one with a direction matrix.");
  }
  vtkDataArray* array = FindArray(image->GetPointData(), name);
  slab.OfPoints = array != nullptr;
  array = array ? array : FindArray(image->GetCellData(), name);
  if (!array)
  {
    throw std::invalid_argument(
      Text("Mask requires an image with an array", name.empty() ? "" : " '" + name + "'",
        " of one component on its points or cells, got none."));
  }
  const int* extent = image->GetExtent();
  std::size_t voxels = 1;
  for (int q = 0; q < 3; ++q)
  {
    slab.Origin[q] = image->GetOrigin()[q];
    slab.Spacing[q] = image->GetSpacing()[q];
    slab.First[q] = extent[2 * q];
    slab.Last[q] = slab.OfPoints ? extent[2 * q + 1] : extent[2 * q + 1] - 1;
    if (slab.Last[q] < slab.First[q])
    {
      throw std::invalid_argument("Mask requires an image with voxels in all three directions, got "
                                  "one that is flat.");
    }
    voxels *= static_cast<std::size_t>(slab.Last[q] - slab.First[q] + 1);
  }
  if (static_cast<std::size_t>(array->GetNumberOfTuples()) < voxels)
  {
    throw std::invalid_argument(Text("Mask requires an array with a value for each of ", voxels,
      " voxels, got ", array->GetNumberOfTuples(), "."));
  }
  slab.Inside.resize(voxels);
  for (std::size_t v = 0; v < voxels; ++v)
  {
    const double value = array->GetTuple1(static_cast<vtkIdType>(v));
    slab.Inside[v] = label == 0 ? value != 0.0 && !std::isnan(value) : value == label;
  }
  return slab;
}

// The voxels of the whole image, and where they lie
struct Grid
{
  std::array<int, 3> First, Dimensions;
  ruc::Vector3 Lower, Spacing;
};

Grid FindGrid(const std::vector<Slab>& slabs)
{
  Grid grid;
  for (int q = 0; q < 3; ++q)
  {
    int last = slabs.front().Last[q];
    grid.First[q] = slabs.front().First[q];
    for (const Slab& slab : slabs)
    {
      grid.First[q] = std::min(grid.First[q], slab.First[q]);
      last = std::max(last, slab.Last[q]);
    }
    grid.Dimensions[q] = last - grid.First[q] + 1;
    grid.Spacing[q] = slabs.front().Spacing[q];
    grid.Lower[q] =
      slabs.front().Origin[q] + (grid.First[q] - 0.5 * slabs.front().OfPoints) * grid.Spacing[q];
  }
  return grid;
}

void CopyVoxels(const Slab& slab, const Grid& grid, std::vector<std::uint8_t>& inside)
{
  const std::uint8_t* source = slab.Inside.data();
  const int row = slab.Last[0] - slab.First[0] + 1;
  for (int z = slab.First[2]; z <= slab.Last[2]; ++z)
  {
    for (int y = slab.First[1]; y <= slab.Last[1]; ++y, source += row)
    {
      const std::size_t place =
        (static_cast<std::size_t>(z - grid.First[2]) * grid.Dimensions[1] + (y - grid.First[1])) *
          grid.Dimensions[0] +
        (slab.First[0] - grid.First[0]);
      std::copy_n(source, row, inside.begin() + place);
    }
  }
}
}

ruc::VoxelMask MaskData::GatherMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks)
{
  Slab own;
  ranks.Agree([&]() { own = LocalSlab(image, arrayName, label); });
  std::vector<Slab> slabs = ranks.AllGather(std::exchange(own, {}));
  slabs.erase(std::remove_if(
                slabs.begin(), slabs.end(), [](const Slab& slab) { return slab.Inside.empty(); }),
    slabs.end());
  if (slabs.empty())
  {
    throw std::invalid_argument("Mask requires an image with voxels, got none.");
  }
  const Grid grid = FindGrid(slabs);
  std::vector<std::uint8_t> inside(
    static_cast<std::size_t>(grid.Dimensions[0]) * grid.Dimensions[1] * grid.Dimensions[2], 0);
  for (const Slab& slab : slabs)
  {
    CopyVoxels(slab, grid, inside);
  }
  return ruc::VoxelMask(grid.Dimensions, grid.Lower, grid.Spacing, std::move(inside));
}
