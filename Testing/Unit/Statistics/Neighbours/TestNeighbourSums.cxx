// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/NeighbourSums.h"

#include "Oracles.h"
#include "HardPack.h"
#include "ThreadRanks.h"

namespace
{
using ruc::HingeSums;
using ruc::NeighbourSums;

NeighbourSums Measure(const ruc::SpherePack& pack, const ruc::Window& window)
{
  ruc::Communicator alone;
  return ruc::MeasureNeighbourSums(ruc::SharePack(pack, window, false, alone), alone);
}

struct Pair
{
  std::size_t I;
  double Gap, Width, Weight;
};

// All ordered pairs with a gap below the largest, by brute force over the images
std::vector<Pair> PairsOf(const ruc::SpherePack& pack, const ruc::Window& box)
{
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (std::size_t j = 0; j < pack.Size(); ++j)
    {
      for (int n = 0; n < 27 && i != j; ++n)
      {
        const int edges[] = { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 };
        ruc::Vector3 d;
        double covariance = 1.0;
        bool image = true;
        for (int q = 0; q < 3; ++q)
        {
          image = image && (edges[q] == 0 || box.Periodic[q]);
          d[q] = pack.Centre(j)[q] + edges[q] * box.Size[q] - pack.Centre(i)[q];
          covariance *= box.Periodic[q] ? 1.0 : 1.0 - std::abs(d[q]) / box.Size[q];
        }
        const double contact = pack.Radius[i] + pack.Radius[j];
        const double gap = ruc::Length(d) / contact - 1.0;
        if (image && gap < ruc::LargestNeighbourGap)
        {
          pairs.push_back({ i, gap, ruc::Length(d) - contact, 1.0 / covariance });
        }
      }
    }
  }
  return pairs;
}

TEST(NeighbourSums, GapsAreThoseOfAllPairs)
{
  for (bool periodic : { true, false })
  {
    const HardPack made(180, 520, 0.5, periodic);
    const ruc::Window& box = made.Box;
    const ruc::SpherePack& pack = made.Pack;
    const NeighbourSums sums = Measure(pack, box);
    ASSERT_GT(sums.Gaps.Size(), 15u);
    const std::vector<Pair> pairs = PairsOf(pack, box);
    for (std::size_t k = 0; k < sums.Gaps.Size(); ++k)
    {
      double sum = 0.0;
      for (const Pair& pair : pairs)
      {
        const double hinge = sums.Gaps.Threshold[k] - std::max(pair.Gap, 1e-4);
        sum += pair.Weight * std::max(hinge, 0.0) / pack.Size();
      }
      // A value is off by half a bin at most, for some 8 neighbours
      EXPECT_NEAR(sums.Gaps.Value[k], sum, 8.0 * 0.5 * 0.15 / 8192);
      EXPECT_GT(sums.Gaps.Error[k], 0.0);
    }
  }
}

TEST(NeighbourSums, NearestAreTheLeastGapsOfInnerSpheres)
{
  for (bool periodic : { true, false })
  {
    const HardPack made(180, 520, 0.5, periodic);
    const ruc::Window& box = made.Box;
    const ruc::SpherePack& pack = made.Pack;
    const NeighbourSums sums = Measure(pack, box);
    ASSERT_GT(sums.Nearest.Size(), 10u);
    std::vector<double> least(pack.Size(), 1e300);
    for (const Pair& pair : PairsOf(pack, box))
    {
      least[pair.I] = std::min(least[pair.I], pair.Width);
    }
    double spheres = 0.0;
    std::vector<double> expected(sums.Nearest.Size(), 0.0);
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      bool inside = true;
      for (int q = 0; q < 3 && !periodic; ++q)
      {
        const double place = pack.Centre(i)[q] - box.Origin[q];
        inside = inside && place >= 2.3 && place <= box.Size[q] - 2.3;
      }
      spheres += inside;
      for (std::size_t k = 0; k < expected.size() && inside; ++k)
      {
        expected[k] += std::max(sums.Nearest.Threshold[k] - std::max(least[i], 1e-6), 0.0);
      }
    }
    for (std::size_t k = 0; k < expected.size(); ++k)
    {
      EXPECT_NEAR(sums.Nearest.Value[k], expected[k] / spheres, 0.3 / 8192 + 1e-6);
    }
  }
}

// Against random points, within four of their standard errors and that of the lattice
TEST(NeighbourSums, PoresAreThoseOfRandomPoints)
{
  const HardPack made(180, 520, 0.5);
  const ruc::Window& box = made.Box;
  const ruc::SpherePack& pack = made.Pack;
  const NeighbourSums sums = Measure(pack, box);
  ASSERT_EQ(sums.Pores.Size(), 21u);
  oracle::Uniform random(9);
  constexpr int points = 30000;
  std::vector<double> distances;
  for (int n = 0; n < points; ++n)
  {
    const ruc::Vector3 point = { random(0.0, box.Size[0]), random(0.0, box.Size[1]),
      random(0.0, box.Size[2]) };
    double least = sums.LargestPore;
    for (std::size_t s = 0; s < pack.Size(); ++s)
    {
      ruc::Vector3 d;
      for (int q = 0; q < 3; ++q)
      {
        d[q] = pack.Centre(s)[q] - point[q];
        d[q] -= box.Size[q] * std::nearbyint(d[q] / box.Size[q]);
      }
      least = std::min(least, ruc::Length(d) - pack.Radius[s]);
    }
    if (least > 0.0)
    {
      distances.push_back(least);
    }
  }
  for (std::size_t k = 0; k < sums.Pores.Size(); ++k)
  {
    double mean = 0.0, squares = 0.0;
    for (double distance : distances)
    {
      const double hinge = std::max(distance - sums.Pores.Threshold[k], 0.0);
      mean += hinge / distances.size();
      squares += hinge * hinge / distances.size();
    }
    const double error = std::sqrt((squares - mean * mean) / distances.size());
    EXPECT_NEAR(sums.Pores.Value[k], mean, 5.0 * error) << sums.Pores.Threshold[k];
  }
}

TEST(NeighbourSums, AreTheSameOnAnyRanks)
{
  for (bool periodic : { true, false })
  {
    const HardPack made(180, 520, 0.5, periodic);
    const ruc::Window& box = made.Box;
    const ruc::SpherePack& pack = made.Pack;
    const NeighbourSums whole = Measure(pack, box);
    for (int ranks = 2; ranks <= 4; ++ranks)
    {
      oracle::ThreadRanks::Run(ranks,
        [&](ruc::Communicator& communicator)
        {
          const ruc::SpherePack piece =
            oracle::PieceOf(pack, communicator.Rank(), ranks, ranks == 3);
          const NeighbourSums sums = ruc::MeasureNeighbourSums(
            ruc::SharePack(piece, box, false, communicator), communicator);
          for (auto part : { &NeighbourSums::Gaps, &NeighbourSums::Nearest, &NeighbourSums::Pores })
          {
            EXPECT_FALSE((whole.*part).Empty());
            EXPECT_TRUE(HingeSums::Fields(sums.*part) == HingeSums::Fields(whole.*part));
          }
        });
    }
  }
}

TEST(NeighbourSums, OfTooFewSpheresAreEmpty)
{
  const ruc::Window cube = oracle::PeriodicCube(8.0);
  EXPECT_TRUE(Measure(oracle::RelaxedPack({ 99 }, { 0.5 }, cube, 1), cube).Empty());
  // A window that leaves no sphere inside still has its gaps
  const ruc::Window thin = ruc::Window::MakeBox({ 0, 0, 0 }, { 30, 30, 1.7 }, {});
  const ruc::SpherePack pack = oracle::RelaxedPack({ 600 }, { 0.5 }, thin, 1);
  const NeighbourSums sums = Measure(pack, thin);
  EXPECT_FALSE(sums.Gaps.Empty());
  EXPECT_TRUE(sums.Nearest.Empty());
  EXPECT_TRUE(sums.Pores.Empty());
  // One without room for a pair has none
  const ruc::Window narrow = ruc::Window::MakeBox({ 0, 0, 0 }, { 300, 300, 1.1 }, {});
  EXPECT_TRUE(Measure(oracle::RelaxedPack({ 600 }, { 0.5 }, narrow, 1), narrow).Empty());
}

// As many points as in any other window, not as many as a spacing for its volume would give
TEST(NeighbourSums, OfAFlatWindowAreMeasuredAtFewPoints)
{
  const ruc::Window flat = ruc::Window::MakeBox({ 0, 0, 0 }, { 1e12, 1e12, 40.0 }, {});
  ruc::SpherePack pack;
  oracle::Uniform random(5);
  for (int n = 0; n < 180; ++n)
  {
    // Twenty in a row in each of the nine columns
    const int column = n % 9;
    pack.X.push_back(1e12 * (column % 3 + 0.5) / 3.0 + 3.0 * (n / 9));
    pack.Y.push_back(1e12 * (column / 3 + 0.5) / 3.0);
    pack.Z.push_back(random(19.9, 20.1));
    pack.Radius.push_back(random(1.35, 1.49));
  }
  EXPECT_FALSE(Measure(pack, flat).Gaps.Empty());
}
}
