// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/CellList.h"

#include "Oracles.h"

#include <map>
#include <tuple>

namespace
{
using Pair = std::tuple<std::size_t, std::size_t, std::array<int, 3>>;

std::map<Pair, int> PairsOfCells(const ruc::SpherePack& pack, const ruc::Window& box, double cutoff)
{
  std::map<Pair, int> pairs;
  const ruc::CellList cells(pack, box, cutoff);
  EXPECT_EQ(cells.Size(), pack.Size());
  for (std::size_t place = 0; place < cells.Size(); ++place)
  {
    EXPECT_EQ(cells.X[place], pack.X[cells.Index[place]]);
  }
  cells.ForEachPair(
    [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d2)
    {
      EXPECT_EQ(d2, dx * dx + dy * dy + dz * dz);
      EXPECT_LT(std::sqrt(d2), cutoff);
      const double d[3] = { dx, dy, dz };
      std::array<int, 3> image = { 0, 0, 0 };
      for (int q = 0; q < 3 && box.GetShape() == ruc::Window::Shape::Box; ++q)
      {
        const double shift = d[q] - (pack.Centre(j)[q] - pack.Centre(i)[q]);
        image[q] = static_cast<int>(std::lround(shift / box.Size[q]));
      }
      if (i > j || (i == j && image < std::array<int, 3>{ 0, 0, 0 }))
      {
        std::swap(i, j);
        image = { -image[0], -image[1], -image[2] };
      }
      ++pairs[{ i, j, image }];
    });
  return pairs;
}

void ExpectAllPairsOnce(const ruc::SpherePack& pack, const ruc::Window& box, double cutoff)
{
  std::map<Pair, int> expected;
  std::vector<std::int64_t> neighbours(pack.Size(), 0);
  oracle::ForEachPair(pack, box, cutoff,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& image, double)
    {
      ++expected[{ i, j, image }];
      ++neighbours[i];
      ++neighbours[j];
    });
  EXPECT_EQ(PairsOfCells(pack, box, cutoff), expected) << "cutoff " << cutoff;
  EXPECT_GE(ruc::CellList(pack, box, cutoff).MostNeighbours(),
    *std::max_element(neighbours.begin(), neighbours.end()));
}

constexpr std::array<bool, 3> Periodicities[] = { { false, false, false }, { true, true, true },
  { true, false, true }, { false, true, false }, { false, false, true } };
}

TEST(CellList, FindsEveryPairOfImagesOnce)
{
  for (const std::array<bool, 3>& periodic : Periodicities)
  {
    const ruc::Window box = ruc::Window::MakeBox({ -3.0, 10.0, 0.25 }, { 4.0, 5.0, 3.0 }, periodic);
    const ruc::SpherePack pack = oracle::RandomPack({ 40 }, { 0.1 }, box, 21);
    for (double cutoff : { 0.3, 1.1, 1.6, 2.4, 4.5, 7.0 })
    {
      ExpectAllPairsOnce(pack, box, cutoff);
    }
  }
}

TEST(CellList, FindsEveryPairOfManyCells)
{
  for (const std::array<bool, 3>& periodic : Periodicities)
  {
    const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 1.0, 1.0, 1.0 }, periodic);
    const ruc::SpherePack pack = oracle::RandomPack({ 400 }, { 0.1 }, box, 22);
    for (double cutoff : { 0.01, 0.09, 0.3 })
    {
      ExpectAllPairsOnce(pack, box, cutoff);
    }
  }
}

TEST(CellList, OneSphereMeetsItsImages)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { 1.0, 2.0, 1.5 }, { true, true, true });
  const ruc::SpherePack pack = oracle::RandomPack({ 1 }, { 0.1 }, box, 4);
  for (double cutoff : { 0.5, 1.2, 3.3, 8.1 })
  {
    ExpectAllPairsOnce(pack, box, cutoff);
  }
}

TEST(CellList, LongAndFlatBoxes)
{
  for (const ruc::Vector3& size :
    { ruc::Vector3{ 50.0, 1.0, 1.0 }, { 10.0, 0.2, 10.0 }, { 0.3, 0.3, 40.0 } })
  {
    for (const std::array<bool, 3>& periodic : Periodicities)
    {
      const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, size, periodic);
      ExpectAllPairsOnce(
        oracle::RandomPack({ 80 }, { 0.1 }, box, 23), box, 0.87); // no multiple of an edge
    }
  }
}

TEST(CellList, DegeneratePacks)
{
  for (const std::array<bool, 3>& periodic : Periodicities)
  {
    const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 4.0, 4.0, 4.0 }, periodic);
    ruc::SpherePack plane = oracle::RandomPack({ 60 }, { 0.1 }, box, 31);
    std::fill(plane.Z.begin(), plane.Z.end(), 1.25);
    ExpectAllPairsOnce(plane, box, 0.7);
    ruc::SpherePack line = plane;
    std::fill(line.X.begin(), line.X.end(), 0.0);
    ExpectAllPairsOnce(line, box, 0.7);
    ExpectAllPairsOnce(line, box, 5.0);
  }
}

TEST(CellList, CentresOnFacesAndCellBorders)
{
  // A lattice whose centres lie on the borders of the cells, with a cut-off just above and just
  // below a lattice distance
  for (const std::array<bool, 3>& periodic : Periodicities)
  {
    const ruc::Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 0.5, 0.6, 0.7 }, periodic);
    ruc::SpherePack pack;
    for (int n = 0; n < 5 * 6 * 7; ++n)
    {
      pack.X.push_back(0.1 * (n % 5));
      pack.Y.push_back(0.1 * (n / 5 % 6));
      pack.Z.push_back(0.1 * (n / 30));
      pack.Radius.push_back(0.01);
    }
    for (double distance : { 0.1, 0.1 * std::sqrt(2.0), 0.2, 0.3 })
    {
      ExpectAllPairsOnce(pack, box, distance * (1.0 + 1e-9));
      ExpectAllPairsOnce(pack, box, distance * (1.0 - 1e-9));
    }
  }
}

TEST(CellList, CylinderWindowHasNoImages)
{
  const ruc::Window cylinder = ruc::Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 2.0, 3.0);
  ruc::SpherePack pack = oracle::RandomPack(
    { 200 }, { 0.1 }, ruc::Window::MakeBox({ -2, -2, 0 }, { 4, 4, 3 }, { false, false, false }), 7);
  pack = ruc::CropToWindow(pack, cylinder);
  ExpectAllPairsOnce(pack, cylinder, 0.8);
}
