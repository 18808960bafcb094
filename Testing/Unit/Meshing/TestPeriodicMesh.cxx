// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Random.h"
#include "ruc/Meshing/MeshQuality.h"
#include "ruc/Meshing/PeriodicMesh.h"

#include <map>
#include <set>
#include <stdexcept>
#include <string>

using namespace ruc;

namespace
{
struct Cell
{
  SpherePack Pack;
  Window Box = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { true, true, true });
};

void AddSphere(SpherePack& pack, const Vector3& centre, double radius)
{
  pack.X.push_back(centre[0]);
  pack.Y.push_back(centre[1]);
  pack.Z.push_back(centre[2]);
  pack.Radius.push_back(radius);
}

// Cubic arrays whose neighbours are `gap` diameters apart; `kind` spheres in the cell: 1, 2 or 4
Cell Cubic(int kind, double gap)
{
  const double touching = kind == 1 ? 0.5 : kind == 2 ? std::sqrt(3.0) / 4.0 : std::sqrt(2.0) / 4.0;
  const std::vector<Vector3> places = kind == 1 ? std::vector<Vector3>{ { 0, 0, 0 } }
    : kind == 2
    ? std::vector<Vector3>{ { 0, 0, 0 }, { 0.5, 0.5, 0.5 } }
    : std::vector<Vector3>{ { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0, 0.5 }, { 0, 0.5, 0.5 } };
  Cell cell;
  for (const Vector3& place : places)
  {
    AddSphere(cell.Pack, place, touching * (1.0 - gap));
  }
  return cell;
}

// Spheres of several sizes put at random where none of them overlaps, in a box with unequal edges
Cell RandomCell(int count, std::uint32_t seed)
{
  Cell cell;
  cell.Box = Window::MakeBox({ 3, -2, 1 }, { 1.1, 0.9, 1.3 }, { true, true, true });
  for (std::uint64_t n = 0; static_cast<int>(cell.Pack.Size()) < count; ++n)
  {
    const Vector3 draw = UniformTriple(seed, RandomStream::SamplePoint, n);
    const double radius = cell.Pack.Size() % 3 == 0 ? 0.2 : 0.08;
    Vector3 centre{};
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] = cell.Box.Origin[axis] + draw[axis] * cell.Box.Size[axis];
    }
    bool fits = true;
    for (std::size_t i = 0; i < cell.Pack.Size() && fits; ++i)
    {
      Vector3 arm = cell.Pack.Centre(i);
      for (int axis = 0; axis < 3; ++axis)
      {
        arm[axis] -= centre[axis];
        arm[axis] -= cell.Box.Size[axis] * std::round(arm[axis] / cell.Box.Size[axis]);
      }
      fits = Length(arm) > radius + cell.Pack.Radius[i] + 1e-5;
    }
    if (fits)
    {
      AddSphere(cell.Pack, centre, radius);
    }
  }
  return cell;
}

std::string Refusal(const Cell& cell, const MeshSettings& settings)
{
  try
  {
    MakePeriodicMesh(cell.Pack, cell.Box, settings);
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return {};
}

void ExpectContains(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

// A triangle of a face of the box, as the places of its corners along the other two axes
using Triangle = std::set<std::pair<double, double>>;

// By other means than FindFault: all faces counted, and those of the box compared by their places
void ExpectPeriodic(const PeriodicMesh& mesh)
{
  std::map<std::set<int>, int> faces;
  double volume = 0.0;
  for (std::size_t n = 0; n < mesh.Cells.size(); ++n)
  {
    const Tetrahedron& c = mesh.Cells[n];
    volume += mesh.VolumeOf(n);
    ASSERT_GT(mesh.VolumeOf(n), 0.0);
    for (int k = 0; k < 4; ++k)
    {
      ++faces[{ c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4] }];
    }
  }
  const double box = mesh.Edge[0] * mesh.Edge[1] * mesh.Edge[2];
  EXPECT_NEAR(volume, box, 1e-12 * box);
  std::set<Triangle> sides[6];
  for (const auto& [face, count] : faces)
  {
    bool isOnBox = false;
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2;
      const double place = side % 2 ? mesh.Edge[axis] : 0.0;
      if (std::all_of(
            face.begin(), face.end(), [&](int p) { return mesh.Points[p][axis] == place; }))
      {
        isOnBox = true;
        Triangle triangle;
        for (const int p : face)
        {
          triangle.emplace(mesh.Points[p][(axis + 1) % 3], mesh.Points[p][(axis + 2) % 3]);
        }
        sides[side].insert(triangle);
      }
    }
    ASSERT_EQ(count, isOnBox ? 1 : 2);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_FALSE(sides[2 * axis].empty());
    EXPECT_TRUE(sides[2 * axis] == sides[2 * axis + 1]);
  }
}

// Corners of surfaces lie on their spheres, and no point lies inside the surface of a sphere that
// it does not belong to
void ExpectOnSpheres(const PeriodicMesh& mesh)
{
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    if (const int part = mesh.Surface[n]; part >= 0)
    {
      Vector3 arm = mesh.Points[n];
      for (int axis = 0; axis < 3; ++axis)
      {
        arm[axis] -= mesh.PartCentre[part][axis];
      }
      // Coordinates of the size of the box are rounded a few times
      ASSERT_NEAR(Length(arm), mesh.PartRadius[part], 1e-14);
    }
  }
}

double ParticleVolume(const PeriodicMesh& mesh)
{
  return MeasureQuality(mesh)[1].Volume;
}
}

TEST(PeriodicMesh, CubicArraysAtAnyGap)
{
  for (const int kind : { 1, 2, 4 })
  {
    for (const double gap : { 0.1, 1e-3, 1e-6, 1e-9 })
    {
      const Cell cell = Cubic(kind, gap);
      MeshSettings settings;
      settings.ElementSize = 0.12;
      settings.ImprovementRounds = 2;
      const PeriodicMesh mesh = MakePeriodicMesh(cell.Pack, cell.Box, settings);
      ExpectPeriodic(mesh);
      ExpectOnSpheres(mesh);
      // The gap of two surfaces is a difference of numbers of size 1
      EXPECT_NEAR(mesh.Gaps.Least, 2.0 * gap * cell.Pack.Radius[0] / (1.0 - gap), 1e-15);
      // Of each sphere with its nearest ones: gaps of 2 gap / (1 - gap) radii
      const int pairs = kind == 1 ? 3 : kind == 2 ? 8 : 24;
      EXPECT_EQ(mesh.Gaps.Narrow, gap < 0.01 / 1.01 ? pairs : 0);
    }
  }
}

TEST(PeriodicMesh, RandomCellsOfTwoSizesInBoxesOfUnequalEdges)
{
  for (std::uint32_t seed = 0; seed < 10; ++seed)
  {
    const Cell cell = RandomCell(20, seed);
    MeshSettings settings;
    settings.Seed = seed;
    settings.ElementSize = 0.06 + 0.01 * (seed % 5);
    settings.ImprovementRounds = 1;
    const PeriodicMesh mesh = MakePeriodicMesh(cell.Pack, cell.Box, settings);
    ExpectPeriodic(mesh);
    ExpectOnSpheres(mesh);
    EXPECT_EQ(std::set<int>(mesh.Particle.begin(), mesh.Particle.end()).size(), 21u);
  }
}

TEST(PeriodicMesh, VolumeOfInscribedParticlesMissesTheBallByTheSquareOfTheSize)
{
  const Cell cell = Cubic(1, 0.2);
  const double radius = 0.4, ball = 4.0 / 3.0 * Pi * radius * radius * radius;
  const auto missing = [&](double size)
  {
    MeshSettings settings;
    settings.ElementSize = size;
    return ball - ParticleVolume(MakePeriodicMesh(cell.Pack, cell.Box, settings));
  };
  // A facet of circumradius s = size / sqrt(3) lies at most s^2 / (2 R) below the sphere, so the
  // volume misses less than 4 pi R^2 s^2 / (2 R); twice that leaves room for uneven facets
  const double coarse = missing(0.1), fine = missing(0.05);
  EXPECT_GT(fine, 0.0);
  EXPECT_LT(coarse, 2.0 * 2.0 * Pi * radius * 0.1 * 0.1 / 3.0);
  EXPECT_NEAR(coarse / fine, 4.0, 1.0);
}

TEST(PeriodicMesh, SettingsDecide)
{
  const Cell cell = RandomCell(20, 4);
  const MeshSettings settings;
  const PeriodicMesh mesh = MakePeriodicMesh(cell.Pack, cell.Box, settings);
  EXPECT_EQ(mesh.Points, MakePeriodicMesh(cell.Pack, cell.Box, settings).Points);
  // Half the mean radius: 7 spheres of 0.2 and 13 of 0.08
  EXPECT_NEAR(mesh.ElementSize, 0.5 * (7 * 0.2 + 13 * 0.08) / 20, 1e-15);
  EXPECT_GT(mesh.Margin, 0.0);
  MeshSettings other = settings;
  other.Seed = 5;
  EXPECT_NE(mesh.Points, MakePeriodicMesh(cell.Pack, cell.Box, other).Points);
  other = settings;
  other.ContactRings = false;
  EXPECT_LT(MakePeriodicMesh(cell.Pack, cell.Box, other).Points.size(), mesh.Points.size());
}

TEST(PeriodicMesh, RefusesWhatHasNoMesh)
{
  Cell cell = Cubic(2, 0.01);
  MeshSettings settings;
  cell.Box = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { true, true, false });
  ExpectContains(Refusal(cell, settings), "requires a box that is periodic along three axes");
  cell = Cubic(2, -0.01);
  cell.Pack.Id = { 12, 88 };
  ExpectContains(Refusal(cell, settings), "got spheres 12 and 88, which overlap by 0.0086");
  cell = Cubic(1, 0.01);
  settings.ShiftOrigin = false;
  ExpectContains(Refusal(cell, settings), "ShiftOrigin must be on");
  settings.ShiftOrigin = true;
  settings.LeastGap = 0.02;
  ExpectContains(Refusal(cell, settings), "LeastGap requires gaps >= 0.02, got 0.01");
  settings.LeastGap = 0.0;
  for (const double size : { -1.0, 1e-4, 0.6 })
  {
    settings.ElementSize = size;
    ExpectContains(Refusal(cell, settings), "ElementSize requires");
  }
}

TEST(PeriodicMesh, FaultsAreFound)
{
  const Cell cell = RandomCell(10, 1);
  const PeriodicMesh good = MakePeriodicMesh(cell.Pack, cell.Box, {});
  EXPECT_EQ(FindFault(good), "");
  PeriodicMesh bad = good;
  bad.Cells.pop_back();
  EXPECT_NE(FindFault(bad), "");
  bad = good;
  bad.Cells.push_back(bad.Cells.front());
  ExpectContains(FindFault(bad), "has 3 tetrahedra");
  bad = good;
  std::swap(bad.Cells[0][0], bad.Cells[0][1]);
  ExpectContains(FindFault(bad), "has the volume -");
  const auto high =
    std::find(good.Boundary.begin(), good.Boundary.end(), HighY) - good.Boundary.begin();
  bad = good;
  bad.Points[high][0] = std::nextafter(bad.Points[high][0], 2.0);
  ExpectContains(FindFault(bad), "its copy");
}

TEST(MeshQuality, AnglesOfKnownTetrahedra)
{
  // acos(1 / 3) in the regular one; right angles and acos(1 / sqrt(3)) in the corner of a cube
  for (const double angle :
    DihedralAngles({ 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }))
  {
    EXPECT_NEAR(angle, 180.0 / Pi * std::acos(1.0 / 3.0), 1e-12);
  }
  std::array<double, 6> corner = DihedralAngles({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 });
  std::sort(corner.begin(), corner.end());
  for (int n = 0; n < 6; ++n)
  {
    EXPECT_NEAR(corner[n], n < 3 ? 180.0 / Pi * std::acos(1.0 / std::sqrt(3.0)) : 90.0, 1e-12);
  }
}

TEST(MeshQuality, SurfacesCloseAndPointOutwards)
{
  const Cell cell = Cubic(1, 0.2);
  MeshSettings settings;
  settings.ElementSize = 0.1;
  const PeriodicMesh mesh = MakePeriodicMesh(cell.Pack, cell.Box, settings);
  double area = 0.0, flux = 0.0;
  for (const SurfaceTriangle& triangle : FindSurfaces(mesh))
  {
    const Vector3 &a = mesh.Points[triangle.Corners[0]], &b = mesh.Points[triangle.Corners[1]],
                  &c = mesh.Points[triangle.Corners[2]];
    const Vector3 normal =
      Cross({ b[0] - a[0], b[1] - a[1], b[2] - a[2] }, { c[0] - a[0], c[1] - a[1], c[2] - a[2] });
    const Vector3& centre = mesh.PartCentre[mesh.Surface[triangle.Corners[0]]];
    area += 0.5 * Length(normal);
    flux += Dot(normal, { a[0] - centre[0], a[1] - centre[1], a[2] - centre[2] }) / 6.0;
  }
  // Cones from the centre fill the particle, whose flat faces on the box have none
  EXPECT_NEAR(flux, ParticleVolume(mesh), 1e-12);
  EXPECT_LT(area, 4.0 * Pi * 0.16);
  EXPECT_GT(area, 3.0 * flux / 0.4);
}
