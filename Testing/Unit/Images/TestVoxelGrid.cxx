// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Grids of voxels in windows
#include "ruc/Images/VoxelGrid.h"

#include "Oracles.h"

#include <limits>

using Size = std::array<int, 3>;

namespace
{
const Size Automatic = { 0, 0, 0 };
}

TEST(VoxelGrid, GivenDimensionsFillTheWindow)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ -1.0, 2.0, 3.0 }, { 10.0, 20.0, 30.0 }, { true, false, false });
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(box, 7.0, { 20, 1, 7 });
  EXPECT_EQ(grid.Dimensions, (Size{ 20, 1, 7 }));
  EXPECT_EQ(grid.Lower, box.Origin);
  EXPECT_EQ(grid.Spacing, (ruc::Vector3{ 0.5, 20.0, 30.0 / 7.0 }));
  EXPECT_EQ(grid.Voxels(), 140.0);
  EXPECT_DOUBLE_EQ(grid.Voxels() * grid.VoxelVolume(), box.Volume());
  EXPECT_EQ(grid.CentreOf(2, 0, 0), (ruc::Vector3{ 0.25, 12.0, 3.0 + 15.0 / 7.0 }));
}

TEST(VoxelGrid, CubesLieInTheWindowAndFillAPeriodicEdge)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { 10.0, 10.0, 3.0 }, { true, false, false });
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(box, 0.3, Automatic);
  EXPECT_EQ(grid.Dimensions, (Size{ 33, 33, 10 }));
  EXPECT_EQ(grid.Spacing, (ruc::Vector3{ 10.0 / 33, 0.3, 0.3 }));
}

TEST(VoxelGrid, ThatOfACylinderReachesAroundIt)
{
  const ruc::Window cylinder = ruc::Window::MakeCylinder({ 1.0, 2.0, 3.0 }, { 0, 0, 1 }, 2.0, 5.0);
  const ruc::VoxelGrid grid = ruc::MakeVoxelGrid(cylinder, 0.3, Automatic);
  EXPECT_EQ(grid.Dimensions, (Size{ 14, 14, 17 }));
  EXPECT_EQ(grid.Spacing, (ruc::Vector3{ 0.3, 0.3, 0.3 }));
  for (int q = 0; q < 3; ++q)
  {
    EXPECT_DOUBLE_EQ(grid.Lower[q], cylinder.GetBounds().Origin[q]);
  }
}

TEST(VoxelGrid, RefusesWhatMakesNone)
{
  const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 1.0, 2.0, 3.0 }, {});
  EXPECT_SAYS(ruc::MakeVoxelGrid(box, 1.0, { 1, 2, 0 }), "three numbers >= 1, or 0 0 0, got 1 2 0");
  EXPECT_SAYS(ruc::MakeVoxelGrid(box, 1.0, { -1, 2, 1 }), "Dimensions requires");
  for (double size : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    EXPECT_SAYS(ruc::MakeVoxelGrid(box, size, Automatic), "VoxelSize requires a finite number > 0");
  }
  EXPECT_SAYS(ruc::MakeVoxelGrid(box, 1.1, Automatic), "VoxelSize requires 1 to ");
  EXPECT_SAYS(ruc::MakeVoxelGrid(box, 1e-300, Automatic), "got 1e-300");
}
