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
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{
using ruc::Text;

// The part of the mask that one rank has: voxels of an extent, and whether they are inside
struct Slab
{
  double First[3], Last[3];     // voxels, both included
  double Origin[3], Spacing[3]; // of the image: of voxel 0's point, or of its lower corner
  double OfPoints;              // 1, or 0 for cells
};
constexpr std::size_t SlabNumbers = sizeof(Slab) / sizeof(double);

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

// The slab, then its voxels, eight in a double; empty where the rank has no part of the image
std::vector<double> LocalSlab(vtkImageData* image, const std::string& name, int label)
{
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return {};
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw std::invalid_argument(
      "Mask requires an image with axes along x, y and z, got one with a direction matrix.");
  }
  vtkDataArray* array = FindArray(image->GetPointData(), name);
  const bool ofPoints = array != nullptr;
  array = array ? array : FindArray(image->GetCellData(), name);
  if (!array)
  {
    throw std::invalid_argument(
      Text("Mask requires an image with an array", name.empty() ? "" : " '" + name + "'",
        " of one component on its points or cells, got none."));
  }
  Slab slab;
  slab.OfPoints = ofPoints;
  const int* extent = image->GetExtent();
  std::size_t voxels = 1;
  for (int q = 0; q < 3; ++q)
  {
    slab.Origin[q] = image->GetOrigin()[q];
    slab.Spacing[q] = image->GetSpacing()[q];
    slab.First[q] = extent[2 * q];
    slab.Last[q] = ofPoints ? extent[2 * q + 1] : extent[2 * q + 1] - 1;
    if (slab.Last[q] < slab.First[q])
    {
      throw std::invalid_argument("Mask requires an image with voxels in all three directions, got "
                                  "one that is flat.");
    }
    voxels *= static_cast<std::size_t>(slab.Last[q] - slab.First[q] + 1);
  }
  std::vector<double> numbers(SlabNumbers + (voxels + 7) / 8, 0.0);
  std::memcpy(numbers.data(), &slab, sizeof(slab));
  auto* inside = reinterpret_cast<std::uint8_t*>(numbers.data() + SlabNumbers);
  for (std::size_t v = 0; v < voxels; ++v)
  {
    const double value = array->GetTuple1(static_cast<vtkIdType>(v));
    inside[v] = label == 0 ? value != 0.0 : value == label;
  }
  return numbers;
}
}

ruc::VoxelMask MaskData::GatherMask(
  vtkImageData* image, const std::string& arrayName, int label, RankCommunicator& ranks)
{
  std::vector<double> own;
  std::string error;
  try
  {
    own = LocalSlab(image, arrayName, label);
  }
  catch (const std::invalid_argument& e)
  {
    error = e.what();
  }
  ranks.ThrowIfAny(error);
  const std::vector<std::vector<double>> parts = ranks.AllGather(own);
  std::vector<Slab> slabs;
  std::vector<const std::uint8_t*> voxels;
  for (const std::vector<double>& part : parts)
  {
    if (!part.empty())
    {
      slabs.emplace_back();
      std::memcpy(&slabs.back(), part.data(), sizeof(Slab));
      voxels.push_back(reinterpret_cast<const std::uint8_t*>(part.data() + SlabNumbers));
    }
  }
  if (slabs.empty())
  {
    throw std::invalid_argument("Mask requires an image with voxels, got none.");
  }
  std::array<int, 3> first, dimensions;
  ruc::Vector3 lower, spacing;
  for (int q = 0; q < 3; ++q)
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Slab& slab : slabs)
    {
      low = std::min(low, slab.First[q]);
      high = std::max(high, slab.Last[q]);
    }
    first[q] = static_cast<int>(low);
    dimensions[q] = static_cast<int>(high - low) + 1;
    spacing[q] = slabs.front().Spacing[q];
    lower[q] = slabs.front().Origin[q] + (low - 0.5 * slabs.front().OfPoints) * spacing[q];
  }
  std::vector<std::uint8_t> inside(
    static_cast<std::size_t>(dimensions[0]) * dimensions[1] * dimensions[2], 0);
  for (std::size_t n = 0; n < slabs.size(); ++n)
  {
    const Slab& slab = slabs[n];
    const std::uint8_t* source = voxels[n];
    const int row = static_cast<int>(slab.Last[0] - slab.First[0]) + 1;
    for (int z = static_cast<int>(slab.First[2]); z <= slab.Last[2]; ++z)
    {
      for (int y = static_cast<int>(slab.First[1]); y <= slab.Last[1]; ++y, source += row)
      {
        const std::size_t place =
          (static_cast<std::size_t>(z - first[2]) * dimensions[1] + (y - first[1])) *
            dimensions[0] +
          (static_cast<int>(slab.First[0]) - first[0]);
        std::copy_n(source, row, inside.begin() + place);
      }
    }
  }
  return ruc::VoxelMask(dimensions, lower, spacing, std::move(inside));
}
