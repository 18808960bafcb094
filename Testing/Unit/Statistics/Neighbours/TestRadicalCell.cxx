// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells and their order: lattices, the Poisson-Voronoi tessellation, and the containers of Voro++
#include "HardPack.h"
#include "NeighbourPacks.h"

#include <voro++/c_loops.hh>
#include <voro++/container.hh>

#include <gtest/gtest.h>

namespace
{
using oracle::MeasureNeighbours;
using ruc::NeighbourStatistics;

void ExpectOrder(const oracle::PackInBox& lattice, int contacts, double q4, double q6)
{
  const NeighbourStatistics found = MeasureNeighbours(lattice);
  ASSERT_EQ(found.Counted, static_cast<std::int64_t>(lattice.Pack.Size()));
  EXPECT_EQ(found.Cells, found.Counted);
  const double fraction = lattice.Pack.Size() * 4.0 / 3.0 * oracle::Pi *
    std::pow(lattice.Pack.Radius[0], 3) / lattice.Box.Volume();
  for (const NeighbourStatistics::Sphere& sphere : found.Spheres)
  {
    EXPECT_EQ(sphere.Contacts, contacts);
    EXPECT_FALSE(sphere.Rattler);
    EXPECT_NEAR(sphere.NearestGap, 0.0, 1e-12 * lattice.Pack.Radius[0]);
    EXPECT_NEAR(sphere.LocalFraction, fraction, 1e-9);
    EXPECT_NEAR(sphere.Q4, q4, 1e-7);
    EXPECT_NEAR(sphere.Q6, q6, 1e-7);
  }
  EXPECT_EQ(found.Contacts.size(), lattice.Pack.Size() * contacts / 2);
}

// By spherical harmonics: faces with the given directions, some images of each other, and areas
double OrderOf(int l, const std::vector<std::pair<ruc::Vector3, double>>& faces)
{
  double sum = 0.0, area = 0.0;
  for (const auto& face : faces)
  {
    area += face.second;
  }
  for (int m = -l; m <= l; ++m)
  {
    double real = 0.0, imaginary = 0.0;
    for (const auto& [n, weight] : faces)
    {
      const double y = std::sph_legendre(l, std::abs(m), std::acos(n[2] / ruc::Length(n)));
      real += weight / area * y * std::cos(m * std::atan2(n[1], n[0]));
      imaginary += weight / area * y * std::sin(m * std::atan2(n[1], n[0]));
    }
    sum += real * real + imaginary * imaginary;
  }
  return std::sqrt(4.0 * oracle::Pi / (2 * l + 1) * sum);
}

// The literature has 0.1909, 0.5745 and 0.0972, 0.4848, for faces that are all equal
TEST(RadicalCell, OfClosePackings)
{
  const double r = std::sqrt(0.5);
  std::vector<std::pair<ruc::Vector3, double>> cubic;
  for (int n = 0; n < 12; ++n)
  {
    const double a = n % 2 ? r : -r, b = n / 2 % 2 ? r : -r;
    cubic.push_back({ n < 4 ? ruc::Vector3{ a, b, 0 }
        : n < 8             ? ruc::Vector3{ a, 0, b }
                            : ruc::Vector3{ 0, a, b },
      1.0 });
  }
  EXPECT_NEAR(OrderOf(4, cubic), 0.1909, 5e-5);
  EXPECT_NEAR(OrderOf(6, cubic), 0.5745, 5e-5);
  ExpectOrder(oracle::FaceCentred(3), 12, OrderOf(4, cubic), OrderOf(6, cubic));
  // In metres, too
  ExpectOrder(oracle::FaceCentred(3, 2e-5), 12, OrderOf(4, cubic), OrderOf(6, cubic));

  std::vector<std::pair<ruc::Vector3, double>> hexagonal;
  for (int n = 0; n < 12; ++n)
  {
    const double angle = n < 6 ? n * oracle::Pi / 3.0 : (n % 3 * 2 + 0.5) * oracle::Pi / 3.0;
    const double across = n < 6 ? 1.0 : std::sqrt(1.0 / 3.0);
    hexagonal.push_back({ { across * std::cos(angle), across * std::sin(angle),
                            n < 6 ? 0.0 : (n < 9 ? 1.0 : -1.0) * std::sqrt(2.0 / 3.0) },
      1.0 });
  }
  EXPECT_NEAR(OrderOf(4, hexagonal), 0.0972, 5e-5);
  EXPECT_NEAR(OrderOf(6, hexagonal), 0.4848, 5e-5);
  ExpectOrder(oracle::HexagonalClose(3), 12, OrderOf(4, hexagonal), OrderOf(6, hexagonal));
}

// The truncated octahedron: hexagons towards the eight that touch, squares towards the next six
TEST(RadicalCell, OfTheBodyCentredLattice)
{
  std::vector<std::pair<ruc::Vector3, double>> faces;
  for (int n = 0; n < 8; ++n)
  {
    faces.push_back({ { n % 2 - 0.5, n / 2 % 2 - 0.5, n / 4 - 0.5 }, 1.5 * std::sqrt(3.0) });
  }
  for (int q = 0; q < 3; ++q)
  {
    for (double sign : { -1.0, 1.0 })
    {
      ruc::Vector3 n{};
      n[q] = sign;
      faces.push_back({ n, 1.0 });
    }
  }
  const oracle::PackInBox lattice = oracle::BodyCentred(3);
  ExpectOrder(lattice, 8, OrderOf(4, faces), OrderOf(6, faces));
  for (const NeighbourStatistics::Sphere& sphere : MeasureNeighbours(lattice).Spheres)
  {
    EXPECT_EQ(sphere.Faces, 14);
  }
}

// J. L. Meijering, Philips Res. Rep. 8, 270 (1953): 2 + 48 pi^2 / 35 faces
TEST(RadicalCell, OfRandomPointsHasTheFacesOfMeijering)
{
  const ruc::Window box = oracle::PeriodicCube(10.0);
  const ruc::SpherePack pack = oracle::RandomPack({ 6000 }, { 1e-3 }, box, 4);
  ruc::NeighbourSettings settings;
  settings.MaximumGap = 1.0;
  settings.Blocks = 64;
  const NeighbourStatistics found = MeasureNeighbours({ pack, box }, settings);
  const ruc::ValueWithError faces = found.OfModes.back().Faces;
  EXPECT_NEAR(faces.Value, 2.0 + 48.0 * oracle::Pi * oracle::Pi / 35.0, 4.0 * faces.Error);
  EXPECT_LT(faces.Error, 0.1);
  double volume = 0.0;
  for (const NeighbourStatistics::Sphere& sphere : found.Spheres)
  {
    volume += 4.0 / 3.0 * oracle::Pi * 1e-9 / sphere.LocalFraction;
  }
  EXPECT_NEAR(volume, box.Volume(), 1e-8 * box.Volume());
}

// Voro++ finds neighbours by blocks of its own
TEST(RadicalCell, IsThatOfTheContainersOfVoro)
{
  const HardPack made(150, 450, 0.5);
  ruc::SpherePack pack = made.Pack;
  ruc::SortCanonically(pack);
  const ruc::Vector3& size = made.Box.Size;
  voro::container_poly container(0, size[0], 0, size[1], 0, size[2], 5, 5, 5, true, true, true, 8);
  ruc::WrapIntoBox(pack, made.Box);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    container.put(static_cast<int>(i), pack.X[i] - made.Box.Origin[0],
      pack.Y[i] - made.Box.Origin[1], pack.Z[i] - made.Box.Origin[2], pack.Radius[i]);
  }
  const NeighbourStatistics found = MeasureNeighbours({ pack, made.Box });
  ruc::SortCanonically(pack);
  voro::c_loop_all loop(container);
  voro::voronoicell_neighbor cell;
  std::size_t cells = 0;
  for (bool more = loop.start(); more; more = loop.inc(), ++cells)
  {
    ASSERT_TRUE(container.compute_cell(cell, loop));
    const std::size_t i = loop.pid();
    EXPECT_NEAR(found.Spheres[i].LocalFraction,
      4.0 / 3.0 * oracle::Pi * std::pow(pack.Radius[i], 3) / cell.volume(), 1e-9);
    EXPECT_EQ(found.Spheres[i].Faces, cell.number_of_faces());
  }
  EXPECT_EQ(cells, pack.Size());
}
}
