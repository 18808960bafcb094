// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/FaceKinds.h"

#include "EnclosedPacks.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

namespace
{
using ruc::FaceKind;
using ruc::PackBounds;
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;

constexpr double LargestDiameter = 56.0; // of the settled pack

// 47 000 spheres of 19 sizes in a cylinder of radius 1026 on a floor at z = 0, about 900 high
const SpherePack& Settled()
{
  static const SpherePack pack = oracle::ReadTable(RUC_TEST_DATA "/settled_cylinder.csv");
  return pack;
}

ruc::PackFaces Faces(const SpherePack& pack, const std::optional<Window>& box = std::nullopt)
{
  ruc::Communicator alone;
  const PackBounds bounds(pack, box, alone);
  return ruc::FindFaces(pack, bounds, ruc::FindMantle(pack, bounds, alone), alone);
}

// How many of the faces of ten blocks of about 10 D at random places are of that kind
int FacesOfBlocks(oracle::Taken taken, FaceKind kind)
{
  std::mt19937 engine(3);
  const auto random = [&](double from, double to)
  { return from + (to - from) * (engine() / 4294967296.0); };
  int count = 0;
  for (int n = 0; n < 10; ++n)
  {
    Vector3 low, high;
    for (int q = 0; q < 3; ++q)
    {
      const double edge = LargestDiameter * random(9.0, 12.0);
      low[q] = random(q < 2 ? -600.0 : 112.0, (q < 2 ? 600.0 : 790.0) - edge);
      high[q] = low[q] + edge;
    }
    const ruc::PackFaces faces = Faces(TakeBlock(Settled(), low, high, taken));
    count += static_cast<int>(std::count(faces.Kinds.begin(), faces.Kinds.end(), kind));
  }
  return count;
}

SpherePack Turned(const SpherePack& pack, int axis)
{
  SpherePack turned = pack;
  std::vector<double>* axes[3] = { &turned.X, &turned.Y, &turned.Z };
  *axes[axis] = pack.Z;
  *axes[(axis + 1) % 3] = pack.X;
  *axes[(axis + 2) % 3] = pack.Y;
  return turned;
}
}

TEST(FaceKinds, BlocksEndAsTheyWereTaken)
{
  EXPECT_EQ(FacesOfBlocks(oracle::Taken::ByCentre, FaceKind::Cut), 60);
  // A face that only whole spheres reach looks cut now and then; one in a hundred did (WindowTable)
  EXPECT_GE(FacesOfBlocks(oracle::Taken::Whole, FaceKind::Loose), 56);
  EXPECT_GE(FacesOfBlocks(oracle::Taken::Touching, FaceKind::Loose), 59);
}

TEST(FaceKinds, AFloorIsAWallAndTheFacesBesideItAreCut)
{
  const SpherePack block =
    TakeBlock(Settled(), { -300, -280, -1 }, { 260, 310, 570 }, oracle::Taken::ByCentre);
  const ruc::PackFaces faces = Faces(block);
  for (int f = 0; f < ruc::NumberOfFaces; ++f)
  {
    EXPECT_EQ(NameOf(faces.Kinds[f]), NameOf(f == 4 ? FaceKind::Wall : FaceKind::Cut))
      << ruc::NameOfFace(f);
  }
  // Spheres of one size at their densest would cover 0.91
  EXPECT_GT(faces.Covered[4], 0.5);
  EXPECT_LT(faces.Covered[4], 0.91);
}

TEST(FaceKinds, WallsAroundPacksOfOneSizeAndOfMany)
{
  for (double deviation : { 0.0, 0.3 })
  {
    const std::vector<double> radii = oracle::LognormalRadii(2500, deviation, 4);
    const Window cube = oracle::CubeFor(radii, 0.58, {});
    const ruc::PackFaces faces = Faces(oracle::PackBetweenWalls(radii, cube, 5, 150));
    EXPECT_EQ(std::count(faces.Kinds.begin(), faces.Kinds.end(), FaceKind::Wall), 6) << deviation;
  }
}

TEST(FaceKinds, APeriodicPackInABoxThatIsNotKnownIsCut)
{
  for (double deviation : { 0.0, 0.3 })
  {
    const std::vector<double> radii = oracle::LognormalRadii(2500, deviation, 6);
    const Window cube = oracle::CubeFor(radii, 0.58, { true, true, true });
    const ruc::PackFaces faces = Faces(oracle::PackBetweenWalls(radii, cube, 7, 150));
    EXPECT_EQ(std::count(faces.Kinds.begin(), faces.Kinds.end(), FaceKind::Cut), 6) << deviation;
  }
}

TEST(FaceKinds, PeriodicAxesHaveNoFaces)
{
  const std::vector<double> radii = oracle::LognormalRadii(2500, 0.2, 8);
  const Window cube = oracle::CubeFor(radii, 0.58, { true, false, true });
  const ruc::PackFaces faces = Faces(oracle::PackBetweenWalls(radii, cube, 9, 150), cube);
  for (int f = 0; f < ruc::NumberOfFaces; ++f)
  {
    EXPECT_EQ(NameOf(faces.Kinds[f]), NameOf(f / 2 == 1 ? FaceKind::Wall : FaceKind::Periodic));
  }
}

TEST(FaceKinds, TooFewSpheresTellNothing)
{
  SpherePack pack;
  for (int n = 0; n < 27; ++n)
  {
    pack.X.push_back(n % 3);
    pack.Y.push_back(n / 3 % 3);
    pack.Z.push_back(n / 9);
    pack.Radius.push_back(0.5);
  }
  const ruc::PackFaces faces = Faces(pack);
  EXPECT_EQ(std::count(faces.Kinds.begin(), faces.Kinds.end(), FaceKind::Unknown), 6);
}

TEST(FaceKinds, CylindersAlongEachAxis)
{
  ruc::Communicator alone;
  for (int axis = 0; axis < 3; ++axis)
  {
    SpherePack pack = Turned(Settled(), axis);
    std::transform(
      pack.Y.begin(), pack.Y.end(), pack.Y.begin(), [](double y) { return y + 5000.0; });
    const PackBounds bounds(pack, std::nullopt, alone);
    const std::optional<ruc::Mantle> mantle = ruc::FindMantle(pack, bounds, alone);
    ASSERT_TRUE(mantle);
    EXPECT_EQ(mantle->Axis, axis);
    // The walls of the simulation are soft: spheres reach up to 0.1 radii into them
    EXPECT_NEAR(mantle->Radius, 1026.0, 3.0);
    EXPECT_NEAR(mantle->Centre[0], 0.0, axis == 0 ? 0.0 : 2.0);
    EXPECT_NEAR(mantle->Centre[1], axis == 1 ? 0.0 : 5000.0, 2.0);
    const ruc::PackFaces faces = ruc::FindFaces(pack, bounds, mantle, alone);
    EXPECT_EQ(faces.Kinds[2 * axis], FaceKind::Wall);
    EXPECT_EQ(faces.Kinds[2 * axis + 1], FaceKind::Loose);
  }
}

TEST(FaceKinds, SameOnAnyNumberOfRanks)
{
  const SpherePack block =
    TakeBlock(Settled(), { -300, -280, -1 }, { 260, 310, 570 }, oracle::Taken::ByCentre);
  const ruc::PackFaces alone = Faces(block);
  ruc::Communicator one;
  const PackBounds bounds(block, std::nullopt, one);
  const std::optional<ruc::Mantle> mantle = ruc::FitMantle(block, bounds, 2, one);
  oracle::ThreadRanks::Run(3,
    [&](ruc::Communicator& ranks)
    {
      SpherePack piece; // rank 1 has none
      for (std::size_t i = 0; i < block.Size(); ++i)
      {
        if (ranks.Rank() == (i % 3 == 0 ? 0 : 2))
        {
          piece.Append(block, i);
        }
      }
      const PackBounds spread(piece, std::nullopt, ranks);
      EXPECT_EQ(spread.VolumeMean, bounds.VolumeMean);
      const std::optional<ruc::Mantle> fitted = ruc::FitMantle(piece, spread, 2, ranks);
      EXPECT_EQ(fitted->Radius, mantle->Radius);
      EXPECT_EQ(fitted->Centre, mantle->Centre);
      EXPECT_EQ(fitted->Covered, mantle->Covered);
      const ruc::PackFaces faces = ruc::FindFaces(piece, spread, std::nullopt, ranks);
      EXPECT_EQ(faces.Kinds, alone.Kinds);
      EXPECT_EQ(faces.Covered, alone.Covered);
    });
}
