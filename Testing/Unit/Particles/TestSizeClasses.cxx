// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SizeClasses.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Particles/CellList.h"

#include <map>
#include <tuple>

namespace
{
using Pair = std::tuple<std::size_t, std::size_t, std::array<int, 3>>;

ruc::SizeClasses Classes(const std::vector<double>& radii, double distance, double factor)
{
  ruc::Communicator serial;
  return ruc::SizeClasses(radii, distance, factor, serial);
}

// Every pair closer than distance + a + b, with its image
std::map<Pair, int> TouchingPairs(
  const ruc::SpherePack& pack, const ruc::Window& box, double distance)
{
  std::map<Pair, int> pairs;
  oracle::ForEachPair(pack, box, distance + 2.0 * pack.LargestRadius(),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& image, double d)
    {
      if (d < distance + pack.Radius[i] + pack.Radius[j])
      {
        ++pairs[{ i, j, image }];
      }
    });
  return pairs;
}

std::map<Pair, int> PairsOfCells(const ruc::SpherePack& pack, const ruc::Window& box,
  const ruc::SizeClasses& classes, double distance)
{
  std::map<Pair, int> pairs;
  ruc::CellList(pack, box, classes)
    .ForEachPair(
      [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d2)
      {
        if (std::sqrt(d2) >= distance + pack.Radius[i] + pack.Radius[j])
        {
          return;
        }
        const double d[3] = { dx, dy, dz };
        std::array<int, 3> image;
        for (int q = 0; q < 3; ++q)
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
}

TEST(SizeClasses, SimilarSizesAreOneClass)
{
  EXPECT_EQ(Classes({ 1.0, 0.8, 0.6, 0.55 }, 3.0, 1.0).Count(), 1);
  // Two octaves, but lags that reach so far that they matter as much for both
  EXPECT_EQ(Classes(std::vector<double>{ 1.0, 0.3, 0.3, 0.3, 0.3 }, 100.0, 1.0).Count(), 1);
  EXPECT_EQ(Classes({}, 3.0, 1.0).Count(), 1);
}

TEST(SizeClasses, OneLargeSphereIsAClassOfItsOwn)
{
  std::vector<double> radii(1000, 0.1);
  radii.push_back(10.0);
  const ruc::SizeClasses classes = Classes(radii, 5.0, 1.0);
  ASSERT_EQ(classes.Count(), 2);
  EXPECT_EQ(classes.ClassOf(10.0), 0);
  EXPECT_EQ(classes.ClassOf(0.1), 1);
  EXPECT_EQ(classes.LargestReach(), 25.0);
  // A class reaches to the top of its octave, 10 / 2^6 here
  EXPECT_LE(classes.Reach(1, 1), 5.0 + 2.0 * 10.0 / 64);
  EXPECT_GE(classes.Reach(1, 1), 5.2);
}

TEST(SizeClasses, EveryPairIsWithinTheReachOfItsClasses)
{
  std::mt19937_64 random(5);
  std::vector<double> radii;
  for (int i = 0; i < 3000; ++i)
  {
    radii.push_back(std::exp(-10.0 * std::uniform_real_distribution<double>()(random)));
  }
  for (double factor : { 1.0, 1.01 })
  {
    const ruc::SizeClasses classes = Classes(radii, 0.01, factor);
    EXPECT_GT(classes.Count(), 2);
    for (std::size_t i = 1; i < radii.size(); ++i)
    {
      const double a = radii[i - 1], b = radii[i];
      EXPECT_GE(classes.Reach(classes.ClassOf(a), classes.ClassOf(b)) * (1.0 + 1e-15),
        0.01 + factor * (a + b));
    }
  }
}

TEST(SizeClasses, AreTheSameOnEveryNumberOfRanks)
{
  std::vector<double> radii;
  for (int i = 0; i < 900; ++i)
  {
    radii.push_back(std::ldexp(1.0 + 0.001 * i, -(i % 9)));
  }
  const ruc::SizeClasses alone = Classes(radii, 0.1, 1.0);
  for (int ranks : { 2, 3 })
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        std::vector<double> own;
        for (std::size_t i = communicator.Rank(); i < radii.size(); i += ranks)
        {
          own.push_back(radii[i]);
        }
        const ruc::SizeClasses classes(own, 0.1, 1.0, communicator);
        ASSERT_EQ(classes.Count(), alone.Count());
        for (double radius : radii)
        {
          ASSERT_EQ(classes.ClassOf(radius), alone.ClassOf(radius));
        }
        EXPECT_EQ(classes.Reach(0, classes.Count() - 1), alone.Reach(0, alone.Count() - 1));
      });
  }
}

TEST(SizeClasses, CellListsFindEveryPairOnce)
{
  for (const std::array<bool, 3>& periodic : { std::array<bool, 3>{ false, false, false },
         { true, true, true }, { true, false, true }, { false, true, false } })
  {
    const ruc::Window box = ruc::Window::MakeBox({ -3.0, 10.0, 0.25 }, { 4.0, 5.0, 3.0 }, periodic);
    const ruc::SpherePack pack =
      oracle::RandomPack({ 2, 9, 60, 150 }, { 1.2, 0.3, 0.05, 0.002 }, box, 21);
    for (double distance : { 0.0, 0.05, 0.4, 3.7 })
    {
      const ruc::SizeClasses classes = Classes(pack.Radius, distance, 1.0);
      EXPECT_TRUE(distance > 0.1 || classes.Count() > 2) << classes.Count();
      EXPECT_EQ(PairsOfCells(pack, box, classes, distance), TouchingPairs(pack, box, distance))
        << "distance " << distance;
    }
  }
}

TEST(SizeClasses, MostNeighboursIsABound)
{
  const ruc::Window box =
    ruc::Window::MakeBox({ 0, 0, 0 }, { 4.0, 5.0, 3.0 }, { true, true, true });
  const ruc::SpherePack pack = oracle::RandomPack({ 2, 200 }, { 1.2, 0.01 }, box, 3);
  const ruc::CellList cells(pack, box, Classes(pack.Radius, 0.1, 1.0));
  std::vector<std::int64_t> neighbours(pack.Size(), 0);
  for (const auto& [pair, number] : TouchingPairs(pack, box, 0.1))
  {
    neighbours[std::get<0>(pair)] += number;
    neighbours[std::get<1>(pair)] += number;
  }
  EXPECT_GE(cells.MostNeighbours(), *std::max_element(neighbours.begin(), neighbours.end()));
  // The bound is not a wild one
  EXPECT_LE(cells.MostNeighbours(), 64 * static_cast<std::int64_t>(pack.Size()));
}
