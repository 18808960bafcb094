// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/SurfaceDistances.h"

#include "Oracles.h"

#include <omp.h>

namespace
{
// The least distance to a surface by all spheres and images
double Nearest(const ruc::SpherePack& pack, const ruc::Window& box, const ruc::Vector3& point)
{
  double least = 1e300;
  for (std::size_t s = 0; s < pack.Size(); ++s)
  {
    for (int n = 0; n < 27; ++n)
    {
      const int edges[] = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
      ruc::Vector3 d;
      bool image = true;
      for (int q = 0; q < 3; ++q)
      {
        image = image && (edges[q] == 0 || box.Periodic[q]);
        d[q] = pack.Centre(s)[q] + edges[q] * box.Size[q] - point[q];
      }
      least = image ? std::min(least, ruc::Length(d) - pack.Radius[s]) : least;
    }
  }
  return least;
}

TEST(SurfaceDistances, AreThoseOfAllSpheresAndImages)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ -1.0, 2.0, 0.0 }, { 6.0, 5.0, 7.0 }, { true, false, true });
  oracle::Uniform random(7);
  ruc::SpherePack pack;
  for (int n = 0; n < 25; ++n)
  {
    pack.X.push_back(random(-1.0, 5.0));
    pack.Y.push_back(random(2.0, 7.0));
    pack.Z.push_back(random(0.0, 7.0));
    pack.Radius.push_back(random(0.1, 0.9));
  }
  const ruc::PointLattice lattice = { { -0.8, 2.1, 0.3 }, { 6.0 / 11, 0.4, 7.0 / 13 },
    { 11, 12, 13 }, box.Periodic };
  constexpr double most = 0.8;
  const ruc::SurfaceDistances found = ruc::FindSurfaceDistances(pack, lattice, most, 2, 9);
  ASSERT_EQ(found.Distance.size(), 7u * 12u * 13u);
  std::size_t n = 0, inside = 0, far = 0;
  for (int i = 2; i < 9; ++i)
  {
    for (int j = 0; j < 12; ++j)
    {
      for (int k = 0; k < 13; ++k, ++n)
      {
        const double expected = Nearest(pack, box, lattice.PointAt(i, j, k));
        EXPECT_NEAR(found.Distance[n], std::min(expected, most), 1e-6);
        EXPECT_EQ(found.Sphere[n]<0, expected> most);
        inside += expected < 0.0;
        far += expected > most;
      }
    }
  }
  EXPECT_GT(inside, 50u);
  EXPECT_GT(far, 50u);
}

TEST(SurfaceDistances, AreTheSameInPartsAndOnAnyThreads)
{
  const ruc::Window box = oracle::PeriodicCube(9.0);
  const ruc::SpherePack pack = oracle::RelaxedPack({ 40, 60 }, { 1.0, 0.5 }, box, 3);
  const ruc::PointLattice lattice = { { 0.1, 0.2, 0.3 }, { 0.45, 0.45, 0.45 }, { 20, 20, 20 },
    { true, true, true } };
  const ruc::SurfaceDistances whole = ruc::FindSurfaceDistances(pack, lattice, 0.7, 0, 20);
  const int before = omp_get_max_threads();
  omp_set_num_threads(3);
  std::vector<float> distance;
  std::vector<std::int32_t> sphere;
  for (int first = 0; first < 20; first += 7)
  {
    const ruc::SurfaceDistances part =
      ruc::FindSurfaceDistances(pack, lattice, 0.7, first, std::min(first + 7, 20));
    distance.insert(distance.end(), part.Distance.begin(), part.Distance.end());
    sphere.insert(sphere.end(), part.Sphere.begin(), part.Sphere.end());
  }
  omp_set_num_threads(before);
  EXPECT_TRUE(distance == whole.Distance);
  EXPECT_TRUE(sphere == whole.Sphere);
}
}
