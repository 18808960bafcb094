// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PeriodicReplicas.h"

#include "Oracles.h"

#include <set>

namespace
{
using Vector3 = ruc::Vector3;

ruc::SpherePack OneSphere(const Vector3& centre, double radius)
{
  ruc::SpherePack pack;
  pack.X = { centre[0] };
  pack.Y = { centre[1] };
  pack.Z = { centre[2] };
  pack.Radius = { radius };
  return pack;
}

std::size_t Spheres(const Vector3& centre, double radius)
{
  return ruc::BoundaryCopies(OneSphere(centre, radius), oracle::PeriodicCube(10.0)).size();
}
}

TEST(PeriodicReplicas, CountsOnFaceEdgeAndCorner)
{
  EXPECT_EQ(Spheres({ 5, 5, 5 }, 2.0), 1u);
  EXPECT_EQ(Spheres({ 1, 5, 5 }, 2.0), 2u); // a face
  EXPECT_EQ(Spheres({ 5, 9, 5 }, 2.0), 2u);
  EXPECT_EQ(Spheres({ 1, 5, 9 }, 2.0), 4u);     // holds a point of an edge: 1 + 1 < 4
  EXPECT_EQ(Spheres({ 1.5, 1.5, 5 }, 2.0), 3u); // two faces, but 2.25 + 2.25 > 4
  EXPECT_EQ(Spheres({ 1, 1, 1 }, 2.0), 8u);     // a corner: 3 < 4
  EXPECT_EQ(Spheres({ 1, 9, 1 }, 2.0), 8u);
  EXPECT_EQ(
    Spheres({ 1.2, 1.2, 8.8 }, 2.0), 7u);   // three edges, 2.88 < 4, but not the corner, 4.32 > 4
  EXPECT_EQ(Spheres({ 0, 0, 0 }, 2.0), 8u); // a centre on the corner itself
  EXPECT_EQ(Spheres({ 0, 5, 5 }, 2.0), 2u);
}

TEST(PeriodicReplicas, TouchingMakesNoCopy)
{
  EXPECT_EQ(Spheres({ 2, 5, 5 }, 2.0), 1u);
  EXPECT_EQ(Spheres({ 5, 5, 8 }, 2.0), 1u);
  EXPECT_EQ(Spheres({ 3, 4, 5 }, 5.0 - 1e-9),
    1u + 2u); // crosses x and y, but 3-4-5: its surface just misses the edge
  EXPECT_EQ(Spheres({ 3, 4, 6 }, 4.5),
    1u + 2u + 1u); // crosses the faces x, y and z = 10, no edge: sqrt(9 + 16) = 5
}

TEST(PeriodicReplicas, CopiesAreTheImagesThatReachIntoTheBox)
{
  // Brute force by sampling: an image reaches in exactly when some point of the box is inside it.
  // The nearest point of the box is found by clamping, for all images up to two edges away.
  const ruc::Window box =
    ruc::Window::MakeBox({ -1, 2, 3 }, { 4.0, 5.0, 6.0 }, { true, false, true });
  const ruc::SpherePack pack = oracle::RandomPack({ 300 }, { 1.3 }, box, 8);
  std::set<std::pair<std::size_t, std::array<int, 3>>> expected, found;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int nx = -2; nx <= 2; ++nx)
    {
      for (int nz = -2; nz <= 2; ++nz)
      {
        const double x = pack.X[i] + 4.0 * nx, z = pack.Z[i] + 6.0 * nz;
        if (std::hypot(x - std::clamp(x, -1.0, 3.0), z - std::clamp(z, 3.0, 9.0)) < 1.3)
        {
          expected.insert({ i, { nx, 0, nz } });
        }
      }
    }
  }
  const std::vector<ruc::Replica> replicas = ruc::BoundaryCopies(pack, box);
  for (std::size_t n = 0; n < replicas.size(); ++n)
  {
    found.insert({ replicas[n].Original, replicas[n].Image });
    if (n < pack.Size())
    {
      EXPECT_EQ(replicas[n].Original, n);
      EXPECT_EQ(replicas[n].Image, (std::array<int, 3>{ 0, 0, 0 }));
    }
  }
  EXPECT_EQ(found.size(), replicas.size()) << "a copy twice";
  EXPECT_EQ(found, expected);
}

TEST(PeriodicReplicas, TilesFillTheTiling)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ -1, 0, 2 }, { 4.0, 5.0, 6.0 }, { true, true, true });
  const ruc::SpherePack pack = oracle::RandomPack({ 7 }, { 0.3 }, box, 9);
  const std::vector<ruc::Replica> replicas = ruc::Tiling(pack, { 2, 1, 3 });
  ASSERT_EQ(replicas.size(), 7u * 6u);
  std::set<std::array<int, 3>> tiles;
  for (std::size_t n = 0; n < replicas.size(); ++n)
  {
    tiles.insert(replicas[n].Image);
    EXPECT_EQ(replicas[n].Original, n % 7);
    const Vector3 centre = ruc::CentreOf(replicas[n], pack, box);
    EXPECT_DOUBLE_EQ(centre[0], pack.X[n % 7] + 4.0 * replicas[n].Image[0]);
    EXPECT_DOUBLE_EQ(centre[1], pack.Y[n % 7] + 5.0 * replicas[n].Image[1]);
    EXPECT_DOUBLE_EQ(centre[2], pack.Z[n % 7] + 6.0 * replicas[n].Image[2]);
    EXPECT_TRUE(n >= 7 || replicas[n].Image == (std::array<int, 3>{ 0, 0, 0 }));
  }
  EXPECT_EQ(tiles,
    (std::set<std::array<int, 3>>{
      { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 0, 2 }, { 1, 0, 2 } }));
}

TEST(PeriodicReplicas, PeriodicCopiesAreFound)
{
  const ruc::Window box = ruc::Window::MakeBox({ -1, 0, 0 }, { 10, 10, 10 }, { true, true, false });
  struct Row
  {
    double X, Y, Z, Radius;
    bool Copy;
  };
  const std::vector<Row> rows = {
    { 8.5, 5, 5, 1, false }, { -1.5, 5, 5, 1, true }, // through the lower face x = -1
    { -1.0, 2, 5, 1, false }, { 9.0, 2, 5, 1, true }, // on the face itself: the box is half open
    { 0.0, 0.5, 5, 1, false },
    { 10.00003, 10.49998, 5, 1, true }, // through an edge, with the digits a text has
    { 0.0, 10.5, 5, 1, true }, { 5, 12, 3, 1, false }, // outside, but no original
    { 3, 3, 3, 1, false }, { 13, 3, 3, 1.5, false },   // another radius
    { 3, 6, 3, 1, false }, { 13.01, 6, 3, 1, false },  // another place
    { 5, 5, 1, 1, false }, { 5, 5, 11, 1, false },     // z is not periodic
    { 6, 7, 8, 1, false }, { 26, -13, 8, 1, true },    // several edges away
  };
  ruc::SpherePack pack;
  std::vector<bool> expected;
  for (const Row& row : rows)
  {
    pack.X.push_back(row.X);
    pack.Y.push_back(row.Y);
    pack.Z.push_back(row.Z);
    pack.Radius.push_back(row.Radius);
    expected.push_back(row.Copy);
  }
  EXPECT_EQ(ruc::FindPeriodicCopies(pack, box), expected);
  const ruc::Window closed =
    ruc::Window::MakeBox({ -1, 0, 0 }, { 10, 10, 10 }, { false, false, false });
  EXPECT_EQ(ruc::FindPeriodicCopies(pack, closed), std::vector<bool>(rows.size(), false));
}

// The rounding of the far centre leads no search through images of the box without end
TEST(PeriodicReplicas, ACentreFarOutHidesNoCopy)
{
  const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { true, true, false });
  ruc::SpherePack pack;
  pack.X = { 1, 11, 4 };
  pack.Y = { 5, 5, 5 };
  pack.Z = { 5, 5, 6e24 };
  pack.Radius = { 1, 1, 1 };
  EXPECT_EQ(ruc::FindPeriodicCopies(pack, box), (std::vector<bool>{ false, true, false }));
}
