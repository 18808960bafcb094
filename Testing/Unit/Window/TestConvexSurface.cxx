// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/ConvexSurface.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
// An octahedron with corners at distance 1 from the origin: volume 4 / 3
ruc::ConvexSurface Octahedron()
{
  return { { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } } };
}

// The volume by the divergence theorem, negative where faces are seen clockwise from outside
double Volume(const ruc::ConvexSurface& surface)
{
  double volume = 0.0;
  for (const std::vector<int>& face : surface.Faces)
  {
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      const ruc::Vector3& a = surface.Points[face[0]];
      const ruc::Vector3& b = surface.Points[face[k]];
      const ruc::Vector3& c = surface.Points[face[k + 1]];
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6.0;
    }
  }
  return volume;
}

// Expects every edge once in each direction, so that the faces close and agree on the outside
void ExpectClosed(const ruc::ConvexSurface& surface)
{
  std::set<std::pair<int, int>> edges;
  for (const std::vector<int>& face : surface.Faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      EXPECT_TRUE(edges.insert({ face[k], face[(k + 1) % face.size()] }).second);
    }
  }
  for (const auto& [a, b] : edges)
  {
    EXPECT_EQ(edges.count({ b, a }), 1u);
  }
}

std::set<ruc::Vector3> Corners(const ruc::ConvexSurface& surface, const std::vector<int>& face)
{
  std::set<ruc::Vector3> corners;
  for (int i : face)
  {
    corners.insert(surface.Points[i]);
  }
  return corners;
}
}

TEST(ConvexSurface, IsCutBetweenItsPoints)
{
  for (int axis : { 0, 1, 2 })
  {
    ruc::ConvexSurface above = Octahedron();
    ruc::ConvexSurface below = Octahedron();
    above.Cut(axis, 0.5, 1, 1e-9);
    below.Cut(axis, 0.5, -1, 1e-9);
    ExpectClosed(above);
    ExpectClosed(below);
    // The tip is the half pyramid of volume 2 / 3 at half the size
    EXPECT_NEAR(Volume(above), 2.0 / 3.0 / 8.0, 1e-15);
    EXPECT_NEAR(Volume(below), 4.0 / 3.0 - 2.0 / 3.0 / 8.0, 1e-15);
    EXPECT_EQ(Corners(above, above.Faces.back()), Corners(below, below.Faces.back()));
    EXPECT_EQ(above.Faces.back().size(), 4u);
  }
}

TEST(ConvexSurface, IsCutThroughItsPoints)
{
  for (double level : { 0.0, 1e-12, -1e-12 })
  {
    ruc::ConvexSurface half = Octahedron();
    half.Cut(2, level, 1, 1e-9);
    ExpectClosed(half);
    EXPECT_EQ(half.Points.size(), 5u);
    EXPECT_EQ(half.Faces.back().size(), 4u);
    EXPECT_NEAR(Volume(half), 2.0 / 3.0, 1e-11);
    half.Cut(0, 0.0, -1, 1e-9);
    half.Cut(1, 0.0, 1, 1e-9);
    ExpectClosed(half);
    EXPECT_NEAR(Volume(half), 1.0 / 6.0, 1e-11);
  }
}

TEST(ConvexSurface, IsWholeOrGoneBesideThePlane)
{
  for (double level : { 1.0, 1.5 })
  {
    ruc::ConvexSurface surface = Octahedron();
    surface.Cut(1, level, -1, 1e-9);
    EXPECT_EQ(surface.Faces, Octahedron().Faces);
    surface.Cut(1, level, 1, 1e-9);
    EXPECT_TRUE(surface.Points.empty());
    EXPECT_TRUE(surface.Faces.empty());
  }
}
