// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ProbabilityMap.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/PairSums/DirectionalProbability.h"

#include <omp.h>

namespace
{
using ruc::SpherePack;
using ruc::Window;

using PhasePairs = std::vector<std::array<int, 2>>;
// All pairs of phases for two modes; 2 is the matrix
const PhasePairs AllPairs = { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 } };

ruc::ProbabilityMap Map(const SpherePack& pack, const Window& window, const PhasePairs& pairs,
  double spacing, double reach)
{
  ruc::Communicator serial;
  return ruc::MapPairs(ruc::SharePack(pack, window), pairs, spacing, reach, serial);
}

// S_rs(x) of two modes by the definition, symmetrised, all pairs of modes
std::array<double, 3> BruteForce(
  const SpherePack& pack, const Window& window, double x, double y, double z)
{
  std::array<double, 3> s{};
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    s[2 * (pack.Mode[i] - 1)] +=
      oracle::LensVolume(pack.Radius[i], pack.Radius[i], std::hypot(x, y, z)) / window.Volume();
  }
  const double cutoff = std::hypot(x, y, z) + 2.0 * pack.LargestRadius();
  oracle::ForEachPair(pack, window, cutoff,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& image, double)
    {
      const double d[3] = { pack.X[j] + image[0] * window.Size[0] - pack.X[i],
        pack.Y[j] + image[1] * window.Size[1] - pack.Y[i],
        pack.Z[j] + image[2] * window.Size[2] - pack.Z[i] };
      for (double sign : { 1.0, -1.0 })
      {
        const double overlap = oracle::LensVolume(pack.Radius[i], pack.Radius[j],
          std::hypot(d[0] - sign * x, d[1] - sign * y, d[2] - sign * z));
        if (overlap > 0.0)
        {
          s[pack.Mode[i] + pack.Mode[j] - 2] += 0.5 * (pack.Mode[i] == pack.Mode[j] ? 2.0 : 1.0) *
            overlap / window.SetCovariance(d[0], d[1], d[2]);
        }
      }
    });
  return s;
}

const std::vector<Window> MapWindows = {
  oracle::PeriodicCube(10.0),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false }),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { true, false, true }),
  Window::MakeCylinder({ 3, 4, 1 }, { 0.3, 0.2, 1.0 }, 3.5, 8.0),
};

SpherePack PackIn(const Window& window, bool overlapping)
{
  const Window cube = oracle::PeriodicCube(10.0);
  return ruc::CropToWindow(overlapping ? oracle::RandomPack({ 40, 60 }, { 0.9, 0.5 }, cube, 7)
                                       : oracle::RelaxedPack({ 40, 60 }, { 0.9, 0.5 }, cube, 7),
    window);
}
}

TEST(ProbabilityMap, EqualsBruteForceOverPairs)
{
  for (const Window& window : MapWindows)
  {
    for (bool overlapping : { false, true })
    {
      const SpherePack pack = PackIn(window, overlapping);
      const double reach =
        ruc::LagLimit::ForMap(window, pack.LargestRadius(), 3.0).Automatic; // 2.6 in the cylinder
      const ruc::ProbabilityMap map = Map(pack, window, AllPairs, 0.37, reach);
      const int n = map.Half[0];
      ASSERT_EQ(n, static_cast<int>(reach / 0.37));
      ASSERT_EQ(map.Values[0].size(), std::size_t(std::pow(2 * n + 1, 3)));
      double c[2] = { 0.0, 0.0 };
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        c[pack.Mode[i] - 1] +=
          4.0 / 3.0 * oracle::Pi * std::pow(pack.Radius[i], 3) / window.Volume();
      }
      // Corners, the rows and slices of the middle and some others
      oracle::Uniform random(4);
      std::vector<std::array<int, 3>> places = { { n, n, n }, { -n, n, -n }, { n, -n, -n },
        { 0, 0, 0 }, { 1, 0, 0 }, { -2, 0, 0 }, { 0, 3, 0 }, { n, -1, 0 }, { 2, 1, 0 },
        { -n, 0, -1 } };
      for (int m = 0; m < 40; ++m)
      {
        places.push_back(
          { int(random(-n, n + 1)), int(random(-n, n + 1)), int(random(-n, n + 1)) });
      }
      for (const auto& [i, j, k] : places)
      {
        const auto s = BruteForce(pack, window, 0.37 * i, 0.37 * j, 0.37 * k);
        const double expected[6] = { s[0], s[1], s[2], c[0] - s[0] - s[1], c[1] - s[1] - s[2],
          1.0 - 2.0 * (c[0] + c[1]) + s[0] + 2.0 * s[1] + s[2] };
        for (int pair = 0; pair < 6; ++pair)
        {
          // A pair's overlap is rounded to 2^-35 of the greatest weight, which is some 1e3 near the
          // corner of a window
          EXPECT_NEAR(map.Values[pair][map.PlaceOf(i, j, k)], expected[pair], 2e-8)
            << window.Describe() << " pair " << pair << " at " << i << ' ' << j << ' ' << k;
        }
      }
    }
  }
}

TEST(ProbabilityMap, EvenAndSymmetricAndZeroLag)
{
  const Window window = MapWindows[2];
  const SpherePack pack = PackIn(window, false);
  PhasePairs swapped = AllPairs;
  for (auto& pair : swapped)
  {
    std::swap(pair[0], pair[1]);
  }
  const ruc::ProbabilityMap map = Map(pack, window, AllPairs, 0.4, 3.6);
  EXPECT_EQ(map.Half[1], 9); // 3.6 / 0.4 is a little less than 9 in double
  const ruc::ProbabilityMap other = Map(pack, window, swapped, 0.4, 3.6);
  EXPECT_TRUE(map.Values == other.Values);
  EXPECT_EQ(other.Pairs, swapped);
  for (const std::vector<double>& values : map.Values)
  {
    EXPECT_TRUE(std::equal(values.begin(), values.end(), values.rbegin()));
  }
  const ruc::PackShare share = ruc::SharePack(pack, window);
  const double c[2] = { share.Volume[0] / 1000.0, share.Volume[1] / 1000.0 };
  const double zero[6] = { c[0], 0.0, c[1], 0.0, 0.0, 1.0 - c[0] - c[1] };
  for (int pair = 0; pair < 6; ++pair)
  {
    EXPECT_NEAR(map.Values[pair][map.PlaceOf(0, 0, 0)], zero[pair], 1e-9);
  }
  // Everything adds up to 1, and every phase to its fraction, everywhere
  for (std::size_t v = 0; v < map.Voxels(); ++v)
  {
    EXPECT_NEAR(map.Values[0][v] + map.Values[1][v] + map.Values[3][v], c[0], 1e-12);
    EXPECT_NEAR(map.Values[3][v] + map.Values[4][v] + map.Values[5][v], 1.0 - c[0] - c[1], 1e-12);
  }
  // An image does not depend on the others
  EXPECT_TRUE(Map(pack, window, { { 2, 2 } }, 0.4, 3.6).Values[0] == map.Values[5]);
}

TEST(ProbabilityMap, AlongTheAxesTheDirectionalFunctions)
{
  for (const Window& window : MapWindows)
  {
    const SpherePack pack = PackIn(window, true);
    const ruc::ProbabilityMap map = Map(pack, window, AllPairs, 0.2, 2.4);
    ruc::Communicator serial;
    const ruc::DirectionalProbability along = ruc::SumPairsAlong(
      ruc::SharePack(pack, window), { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { 0.2, 12 }, serial);
    for (int pair = 0; pair < 6; ++pair)
    {
      for (int k = -12; k <= 12; ++k)
      {
        const std::size_t places[3] = { map.PlaceOf(k, 0, 0), map.PlaceOf(0, k, 0),
          map.PlaceOf(0, 0, k) };
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(map.Values[pair][places[axis]],
            along.Values[axis].S(AllPairs[pair][0], AllPairs[pair][1])[std::abs(k)], 2e-8);
        }
      }
    }
  }
}

TEST(ProbabilityMap, TheSameForAnyRanksAndThreads)
{
  const int threads = omp_get_max_threads();
  for (const Window& window : MapWindows)
  {
    const SpherePack pack = PackIn(window, true);
    const auto expected = Map(pack, window, AllPairs, 0.5, 2.5).Values;
    for (int count : { 1, 2, 3, 8 }) // 8 are more than there are slices
    {
      omp_set_num_threads(count);
      EXPECT_TRUE(Map(pack, window, AllPairs, 0.5, 2.5).Values == expected) << count;
    }
    omp_set_num_threads(threads);
    for (int size : { 2, 3, 5 })
    {
      for (bool allOnLast : { false, true })
      {
        oracle::ThreadRanks::Run(size,
          [&](ruc::Communicator& ranks)
          {
            const ruc::PackShare share = ruc::SharePack(
              oracle::PieceOf(pack, ranks.Rank(), size, allOnLast), window, true, ranks);
            EXPECT_TRUE(ruc::MapPairs(share, AllPairs, 0.5, 2.5, ranks).Values == expected)
              << window.Describe() << " on " << size;
          });
      }
    }
  }
}

// Every displacement closer than a diameter to the cube has a set covariance > 0, and little more
// than the reach would not do
TEST(ProbabilityMap, BadInputIsRefused)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false });
  const SpherePack pack = oracle::RandomPack({ 20, 20 }, { 0.9, 0.5 }, box, 7);
  EXPECT_SAYS(Map(pack, box, {}, 0.5, 2.0), "at least one pair of phases");
  EXPECT_SAYS(Map(pack, box, { { 0, 3 } }, 0.5, 2.0), "phases from 0 to 2 (the matrix), got 3");
  EXPECT_SAYS(Map(pack, box, { { -1, 0 } }, 0.5, 2.0), "got -1");
  EXPECT_SAYS(Map(pack, box, AllPairs, 0.0, 2.0), "Spacing requires a finite number > 0");
  EXPECT_SAYS(Map(pack, box, AllPairs, std::nan(""), 2.0), "Spacing requires");
  EXPECT_SAYS(
    Map(pack, box, AllPairs, 0.5, 0.0), "Spacing x Resolution requires a length > 0 and <= 8.1918");
  EXPECT_SAYS(
    Map(pack, box, AllPairs, 0.5, 8.2), "Spacing x Resolution requires a length > 0 and <= 8.1918");
  EXPECT_SAYS(Map(pack, box, AllPairs, 0.5, std::nan("")), "Spacing x Resolution requires");
  EXPECT_SAYS(Map(pack, box, { { 2, 2 } }, 0.01, 2.0),
    "Resolution requires at most 183 for 1 pairs of phases");
  EXPECT_SAYS(Map(pack, box, { { 2, 2 } }, 1e-300, 5e-299), "Spacing requires at least");
  EXPECT_SAYS(Map(pack, box, { { 2, 2 } }, 1e-300, 2.0),
    "Resolution requires at most 183 for 1 pairs of phases");
  const Window narrow = Window::MakeCylinder({ 5, 5, 0 }, { 0, 0, 1 }, 0.8, 10.0);
  EXPECT_SAYS(Map(ruc::CropToWindow(oracle::RandomPack({ 400 }, { 0.9 }, box, 7), narrow), narrow,
                { { 0, 0 } }, 0.5, 2.0),
    "edges longer than the largest sphere's diameter, 1.8");
}
