// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Random.h"
#include "ruc/Meshing/Delaunay.h"

#include <set>
#include <stdexcept>

using namespace ruc;

namespace
{
std::vector<Vector3> RandomPoints(int count, std::uint32_t seed)
{
  std::vector<Vector3> points;
  for (int n = 0; n < count; ++n)
  {
    points.push_back(UniformTriple(seed, RandomStream::SamplePoint, n));
  }
  return points;
}

std::vector<GridPoint> OnGrid(const std::vector<Vector3>& points)
{
  return RoundToGrid(points, { 0, 0, 0 }, { 1, 1, 1 });
}

// Whole numbers of a lattice of (n + 1)^3 points, of which nearly all lie on common spheres and
// planes
std::vector<GridPoint> Lattice(int n)
{
  std::vector<GridPoint> points;
  for (int k = 0; k < (n + 1) * (n + 1) * (n + 1); ++k)
  {
    points.push_back(
      { 1.0 * (k % (n + 1)), 1.0 * (k / (n + 1) % (n + 1)), 1.0 * (k / (n + 1) / (n + 1)) });
  }
  return points;
}

double Volume(const std::vector<GridPoint>& points, const Tetrahedron& cell)
{
  Vector3 edge[3];
  for (int k = 0; k < 3; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      edge[k][axis] = points[cell[k + 1]][axis] - points[cell[0]][axis];
    }
  }
  return Dot(Cross(edge[0], edge[1]), edge[2]) / 6.0;
}

// No point lies inside the sphere of any tetrahedron, no tetrahedron is flat, each face belongs to
// at most two, and the faces of the hull have every point on their one side: with this they fill
// the convex hull once, whatever the method that made them
void ExpectDelaunay(const std::vector<GridPoint>& points)
{
  const std::vector<Tetrahedron> cells = DelaunayTetrahedra(points);
  std::map<std::array<int, 3>, std::vector<Tetrahedron>> faces;
  std::set<int> used;
  for (const Tetrahedron& cell : cells)
  {
    const auto& [a, b, c, d] = cell;
    ASSERT_EQ(Orientation(points[a], points[b], points[c], points[d]), 1);
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      ASSERT_LE(InSphere(points[a], points[b], points[c], points[d], points[n]), 0);
    }
    for (int k = 0; k < 4; ++k)
    {
      used.insert(cell[k]);
      std::array<int, 3> face{ cell[(k + 1) % 4], cell[(k + 2) % 4], cell[(k + 3) % 4] };
      std::sort(face.begin(), face.end());
      faces[face].push_back({ face[0], face[1], face[2], cell[k] });
    }
  }
  EXPECT_EQ(used.size(), points.size());
  const auto side = [&](const Tetrahedron& of, int n)
  { return Orientation(points[of[0]], points[of[1]], points[of[2]], points[n]); };
  for (const auto& [face, on] : faces)
  {
    ASSERT_LE(on.size(), 2u);
    const int inner = side(on[0], on[0][3]);
    if (on.size() == 2)
    {
      ASSERT_EQ(side(on[1], on[1][3]), -inner);
      continue;
    }
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      ASSERT_NE(side(on[0], static_cast<int>(n)), -inner);
    }
  }
}
}

TEST(GridPredicates, SignsAreExactWhereDoublesRound)
{
  // A plane through far points, and one grid cell above and below it
  const double n = 2199023255551.0;
  const GridPoint a{ 0, 0, 0 }, b{ n, 1, 0 }, c{ 0, n, 1 };
  // (b x c) . d with d = (1, -n, n^2) / scale has no common grid point but 0, so take sums of b and
  // c
  const GridPoint in{ n, n + 1, 1 };
  EXPECT_EQ(Orientation(a, b, c, in), 0);
  EXPECT_EQ(Orientation(a, b, c, { n, n + 1, 2 }), 1);
  EXPECT_EQ(Orientation(a, b, c, { n, n + 1, 0 }), -1);
}

TEST(GridPredicates, ASphereIsExactToOneCellOfTheGrid)
{
  // The corners of a box with odd edges lie on one sphere
  const double x = 2199023255551.0, y = 1999023255557.0, z = 1799023255553.0;
  const GridPoint a{ 0, 0, 0 }, b{ x, 0, 0 }, c{ 0, y, 0 }, d{ 0, 0, z };
  ASSERT_EQ(Orientation(a, b, c, d), 1);
  EXPECT_EQ(InSphere(a, b, c, d, { x, y, z }), 0);
  EXPECT_EQ(InSphere(a, b, c, d, { x, y, z - 1 }), 1);
  EXPECT_EQ(InSphere(a, b, c, d, { x, y, z + 1 }), -1);
  EXPECT_EQ(InSphere(a, b, c, d, { x - 1, y, z }), 1);
  EXPECT_EQ(InSphere(a, b, c, d, { x + 1, y, z }), -1);
}

TEST(Delaunay, RandomPointsHaveEmptySpheres)
{
  for (std::uint32_t seed = 0; seed < 20; ++seed)
  {
    ExpectDelaunay(OnGrid(RandomPoints(5 + 4 * static_cast<int>(seed), seed)));
  }
}

TEST(Delaunay, LatticesWithAllPointsOnCommonSpheres)
{
  for (int n = 1; n <= 4; ++n)
  {
    ExpectDelaunay(Lattice(n));
  }
}

TEST(Delaunay, PointsOnASphereAndInPlanes)
{
  // Half on a sphere up to rounding, half in the faces of the cube around it
  std::vector<Vector3> points = RandomPoints(120, 7);
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    Vector3& point = points[n];
    if (n % 2 == 0)
    {
      point[n / 2 % 3] = n / 6 % 2 == 0 ? 0.0 : 1.0;
      continue;
    }
    const Vector3 arm{ point[0] - 0.5, point[1] - 0.5, point[2] - 0.5 };
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = 0.5 + 0.4 * arm[axis] / Length(arm);
    }
  }
  ExpectDelaunay(OnGrid(points));
}

TEST(Delaunay, ManyPointsFillTheCube)
{
  std::vector<Vector3> points = RandomPoints(20000, 3);
  for (int corner = 0; corner < 8; ++corner)
  {
    points.push_back({ corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0 });
  }
  const std::vector<GridPoint> grid = OnGrid(points);
  double volume = 0.0;
  for (const Tetrahedron& cell : DelaunayTetrahedra(grid))
  {
    volume += Volume(grid, cell);
  }
  const double edge = 2199023255552.0;
  EXPECT_NEAR(volume / (edge * edge * edge), 1.0, 1e-12); // 130 000 terms of rounding 1e-16
}

TEST(Delaunay, PlanesHaveNoneAndEqualPointsAreRefused)
{
  EXPECT_TRUE(DelaunayTetrahedra({}).empty());
  EXPECT_TRUE(
    DelaunayTetrahedra({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 }, { 5, 5, 0 } })
      .empty());
  std::vector<GridPoint> points = OnGrid(RandomPoints(50, 1));
  points.push_back(points[17]);
  EXPECT_THROW(DelaunayTetrahedra(points), std::invalid_argument);
}
