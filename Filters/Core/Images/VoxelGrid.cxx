// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/VoxelGrid.h"

#include "ruc/Base/Require.h"

#include <cmath>

namespace ruc
{
namespace
{
// An image of points has an extent of so many, one of cells one more
constexpr double MostVoxels = 2147483646.0;
// An edge that is a multiple of the voxel but for rounding holds as many
constexpr double Tolerance = 1e-9;

// The number of voxels of about the size h along an edge
double CountVoxels(const Window& window, double edge, bool periodic, double h)
{
  if (periodic)
  {
    return std::round(edge / h);
  }
  return window.GetShape() == Window::Shape::Cylinder ? std::ceil(edge / h * (1.0 - Tolerance))
                                                      : std::floor(edge / h * (1.0 + Tolerance));
}
}

VoxelGrid MakeVoxelGrid(
  const Window& window, double voxelSize, const std::array<int, 3>& dimensions)
{
  const bool given = dimensions != std::array<int, 3>{ 0, 0, 0 };
  Require(given || (voxelSize > 0.0 && std::isfinite(voxelSize)), "VoxelSize",
    "a finite number > 0, or 0 for an automatic one", voxelSize);
  const Window box = window.GetBounds();
  VoxelGrid grid;
  grid.Lower = box.Origin;
  for (int q = 0; q < 3; ++q)
  {
    Require(!given || dimensions[q] >= 1, "Dimensions", "three numbers >= 1, or 0 0 0",
      Text(dimensions[0], " ", dimensions[1], " ", dimensions[2]));
    const double edge = box.Size[q];
    const double count =
      given ? dimensions[q] : CountVoxels(window, edge, box.Periodic[q], voxelSize);
    Require(count >= 1.0 && count <= MostVoxels, "VoxelSize",
      Text("1 to ", MostVoxels, " voxels along each axis of the ", window.Describe()), voxelSize);
    grid.Dimensions[q] = static_cast<int>(count);
    grid.Spacing[q] = given || box.Periodic[q] ? edge / count : voxelSize;
  }
  return grid;
}
}
