// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Random.h"
#include "ruc/Meshing/MeshImprovement.h"
#include "ruc/Meshing/MeshQuality.h"

using namespace ruc;

namespace
{
// Body-centred spheres, 0.1 radii apart
PeriodicMesh MeshOf(int rounds)
{
  SpherePack pack;
  pack.X = pack.Y = pack.Z = { 0.0, 0.5 };
  pack.Radius = { 0.412, 0.412 };
  MeshSettings settings;
  settings.ElementSize = 0.1;
  settings.ImprovementRounds = rounds;
  return MakePeriodicMesh(
    pack, Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { true, true, true }), settings);
}
}

TEST(MeshImprovement, ShapeIsTheSineOfTheWorstAngle)
{
  for (std::uint32_t n = 0; n < 200; ++n)
  {
    Vector3 corner[4];
    for (int k = 0; k < 4; ++k)
    {
      corner[k] = UniformTriple(1, RandomStream::SamplePoint, 4 * n + k);
    }
    const Vector3 &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
    double worst = 1.0;
    for (const double angle : DihedralAngles(a, b, c, d))
    {
      const double sine = std::sin(Pi / 180.0 * angle);
      worst = std::min(worst, angle < 90.0 ? 2.0 * sine : sine);
    }
    // It is positive in one order of the corners and -1 in the other
    const double both[] = { ShapeOf(a, b, c, d), ShapeOf(b, a, c, d) };
    EXPECT_NEAR(std::max(both[0], both[1]), worst, 1e-12);
    EXPECT_EQ(std::min(both[0], both[1]), -1.0);
  }
  EXPECT_EQ(ShapeOf({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }), -1.0);
}

TEST(MeshImprovement, FlatTetrahedraGoAndTheMeshStaysWhole)
{
  const PeriodicMesh before = MeshOf(0), after = MeshOf(10);
  EXPECT_EQ(FindFault(after), "");
  EXPECT_EQ(after.Cells, before.Cells);
  EXPECT_EQ(after.Particle, before.Particle);
  for (int phase = 0; phase < 2; ++phase)
  {
    const MeshQuality of = MeasureQuality(before)[phase], now = MeasureQuality(after)[phase];
    EXPECT_GT(of.LargestAngle, 175.0);
    EXPECT_LT(now.LargestAngle, 175.0);
    EXPECT_GT(1000 * of.Above170, of.Cells);
    EXPECT_LT(1000 * now.Above170, now.Cells);
    EXPECT_GT(now.LeastAngle, of.LeastAngle);
  }
}

TEST(MeshImprovement, PointsStayOnTheirSpheresAndPlanes)
{
  const PeriodicMesh before = MeshOf(0), after = MeshOf(10);
  int moved = 0;
  for (std::size_t n = 0; n < after.Points.size(); ++n)
  {
    moved += after.Points[n] != before.Points[n];
    for (int axis = 0; axis < 3; ++axis)
    {
      if (after.Boundary[n] >> (2 * axis) & 3)
      {
        EXPECT_EQ(after.Points[n][axis], before.Points[n][axis]);
      }
    }
    if (const int part = after.Surface[n]; part >= 0)
    {
      Vector3 arm = after.Points[n];
      for (int axis = 0; axis < 3; ++axis)
      {
        arm[axis] -= after.PartCentre[part][axis];
      }
      // Coordinates of the size of the box are rounded a few times
      EXPECT_NEAR(Length(arm), after.PartRadius[part], 1e-14);
    }
  }
  EXPECT_GT(moved, 0);
}
