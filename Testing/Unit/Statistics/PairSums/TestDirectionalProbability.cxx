// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/DirectionalProbability.h"

#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Window/Directions.h"

#include <omp.h>

namespace
{
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;

const std::vector<Vector3> Axes = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

ruc::DirectionalProbability Along(const SpherePack& pack, const Window& window,
  const std::vector<Vector3>& directions, const ruc::LagGrid& lags)
{
  ruc::Communicator serial;
  return ruc::SumPairsAlong(ruc::SharePack(pack, window), directions, lags, serial);
}

// S_rs along a direction by the definition: every ordered pair, image by image
ruc::TwoPointProbability BruteForce(
  const SpherePack& pack, const Window& window, const Vector3& n, const ruc::LagGrid& lags)
{
  const int modes = pack.NumberOfModes();
  ruc::TwoPointProbability result(modes, lags);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    result.Fractions[pack.Mode[i] - 1] +=
      4.0 / 3.0 * oracle::Pi * std::pow(pack.Radius[i], 3) / window.Volume();
    for (int k = 0; k <= lags.Count; ++k)
    {
      result.S(pack.Mode[i] - 1, pack.Mode[i] - 1)[k] +=
        oracle::LensVolume(pack.Radius[i], pack.Radius[i], k * lags.Spacing) / window.Volume();
    }
  }
  const double cutoff = lags.Maximum() + 2.0 * pack.LargestRadius();
  oracle::ForEachPair(pack, window, cutoff,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& image, double)
    {
      const double d[3] = { pack.X[j] + image[0] * window.Size[0] - pack.X[i],
        pack.Y[j] + image[1] * window.Size[1] - pack.Y[i],
        pack.Z[j] + image[2] * window.Size[2] - pack.Z[i] };
      const double orders = pack.Mode[i] == pack.Mode[j] ? 2.0 : 1.0;
      for (int k = 0; k <= lags.Count; ++k)
      {
        for (double sign : { 1.0, -1.0 })
        {
          const double r = sign * k * lags.Spacing;
          const double t = std::hypot(d[0] - r * n[0], d[1] - r * n[1], d[2] - r * n[2]);
          result.S(pack.Mode[i] - 1, pack.Mode[j] - 1)[k] += 0.5 * orders *
            oracle::LensVolume(pack.Radius[i], pack.Radius[j], t) /
            window.SetCovariance(d[0], d[1], d[2]);
        }
      }
    });
  result.CompleteMatrix();
  return result;
}

double LargestDifference(const ruc::TwoPointProbability& a, const ruc::TwoPointProbability& b)
{
  double largest = 0.0;
  for (int pair = 0; pair < a.Pairs(); ++pair)
  {
    for (int k = 0; k <= a.Lags.Count; ++k)
    {
      largest = std::max(largest, std::abs(a.Values[pair][k] - b.Values[pair][k]));
    }
  }
  return largest;
}

const std::vector<Window> Windows = {
  oracle::PeriodicCube(10.0),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false }),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { true, false, true }),
  Window::MakeCylinder({ 3, 4, 1 }, { 0.3, 0.2, 1.0 }, 3.5, 8.0),
};

// A simple cubic lattice of 4^3 spheres of radius 1, 2.5 apart
SpherePack Lattice(double stretch)
{
  SpherePack pack;
  for (int n = 0; n < 64; ++n)
  {
    pack.X.push_back(2.5 * (n % 4));
    pack.Y.push_back(2.5 * (n / 4 % 4));
    pack.Z.push_back(2.5 * (n / 16) * stretch);
    pack.Radius.push_back(1.0);
    pack.Mode.push_back(1);
  }
  return pack;
}
}

TEST(DirectionalProbability, EqualsBruteForceOverPairs)
{
  const ruc::LagGrid lags = { 0.23, 20 };
  const double s = std::sqrt(0.5);
  const std::vector<Vector3> directions = { { 1, 0, 0 }, { 0, -1, 0 }, { 0, s, s },
    { 0.48, -0.6, 0.64 } };
  for (const Window& window : Windows)
  {
    for (bool overlapping : { false, true })
    {
      const Window cube = oracle::PeriodicCube(10.0);
      const SpherePack all = overlapping ? oracle::RandomPack({ 40, 60 }, { 0.9, 0.5 }, cube, 7)
                                         : oracle::RelaxedPack({ 40, 60 }, { 0.9, 0.5 }, cube, 7);
      const SpherePack pack = ruc::CropToWindow(all, window);
      const ruc::DirectionalProbability got = Along(pack, window, directions, lags);
      ASSERT_EQ(got.Values.size(), directions.size());
      EXPECT_EQ(got.Directions, directions);
      EXPECT_TRUE(got.Errors.empty());
      for (std::size_t d = 0; d < directions.size(); ++d)
      {
        const ruc::TwoPointProbability expected = BruteForce(pack, window, directions[d], lags);
        // A pair's overlap is rounded to 2^-35 of its greatest weight, of some 1e3 pairs a value
        EXPECT_LT(LargestDifference(got.Values[d], expected), 1e-9) << window.Describe();
        for (int p = 0; p < 3; ++p)
        {
          EXPECT_NEAR(got.Values[d].Fractions[p], expected.Fractions[p], 1e-12);
        }
      }
    }
  }
}

TEST(DirectionalProbability, PeriodicBoxSmallerThanTheLags)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 4, 5, 6 }, { true, true, true });
  const SpherePack pack = oracle::RandomPack({ 5, 4 }, { 0.7, 1.1 }, box, 3);
  const ruc::LagGrid lags = { 0.8, 20 };
  const Vector3 n = { 0.48, -0.6, 0.64 };
  EXPECT_LT(
    LargestDifference(Along(pack, box, { n }, lags).Values[0], BruteForce(pack, box, n, lags)),
    1e-9);
}

TEST(DirectionalProbability, AverageOverTheSphereIsTheIsotropicFunction)
{
  const Window box = oracle::PeriodicCube(10.0);
  const SpherePack pack = oracle::RelaxedPack({ 40, 60 }, { 0.9, 0.5 }, box, 7);
  const ruc::LagGrid lags = { 0.3, 12 };
  const ruc::TwoPointProbability expected = ruc::SumPairs(pack, box, lags);
  // The mean over ever more even directions is a quadrature that converges, at least as one over
  // the square root of their number, and its limit must be the isotropic function
  const auto mean = [&](int count)
  { return ruc::MeanOverDirections(Along(pack, box, ruc::EvenDirections(count), lags)); };
  const double coarse = LargestDifference(mean(250), expected);
  const double medium = LargestDifference(mean(1000), expected);
  const double fine = LargestDifference(mean(4000), expected);
  EXPECT_LT(medium, 0.5 * coarse);
  EXPECT_LT(fine, 0.5 * medium);
  EXPECT_LT(fine, 1e-5) << coarse << ' ' << medium;
  for (int p = 0; p < 3; ++p)
  {
    EXPECT_NEAR(mean(2).Fractions[p], expected.Fractions[p], 1e-14);
  }
}

TEST(DirectionalProbability, DeviationIsTheSampleStandardDeviation)
{
  const Window box = oracle::PeriodicCube(10.0);
  const SpherePack pack = oracle::RandomPack({ 20 }, { 0.9 }, box, 7);
  ruc::DirectionalProbability found = Along(pack, box, Axes, { 0.5, 8 });
  const auto deviation = ruc::IsotropyDeviation(found);
  ASSERT_EQ(deviation.size(), 3u);
  for (int pair = 0; pair < 3; ++pair)
  {
    for (int k = 0; k <= 8; ++k)
    {
      const double x = found.Values[0].Values[pair][k], y = found.Values[1].Values[pair][k],
                   z = found.Values[2].Values[pair][k];
      // from the differences of the pairs of directions
      const double square = ((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) / 6.0;
      EXPECT_NEAR(deviation[pair][k], std::sqrt(square), 1e-14);
    }
    EXPECT_NEAR(deviation[pair][0], 0.0, 1e-15);
  }
  EXPECT_EQ(ruc::IsotropyNoise(found)[1][3], 0.0);
  found.Errors.assign(3, std::vector<std::vector<double>>(3, std::vector<double>(9, 3.0)));
  found.Errors[1][2][5] = 6.0;
  EXPECT_DOUBLE_EQ(ruc::IsotropyNoise(found)[2][5], std::sqrt(18.0));
  EXPECT_DOUBLE_EQ(ruc::IsotropyNoise(found)[2][4], 3.0);
  EXPECT_TRUE(std::isnan(ruc::IsotropyDeviation(Along(pack, box, { Axes[0] }, { 0.5, 8 }))[0][3]));
}

TEST(DirectionalProbability, LatticesAndStretchedPacksAreAnisotropic)
{
  // Along an edge of the lattice S(2.5) = c; along a diagonal of a face the neighbours at (2.5, 0)
  // and (0, 2.5) share nothing with the displaced sphere
  const double s = std::sqrt(0.5);
  const ruc::DirectionalProbability lattice =
    Along(Lattice(1.0), oracle::PeriodicCube(10.0), { Axes[0], { s, s, 0 } }, { 0.5, 5 });
  const double c = 64 * 4.0 / 3.0 * oracle::Pi / 1000.0;
  EXPECT_NEAR(lattice.Values[0].S(0, 0)[5], c, 1e-10);
  const double t = std::hypot(2.5 - 2.5 * s, 2.5 - 2.5 * s);
  const double across = std::hypot(2.5 - 2.5 * s, 2.5 * s);
  const double diagonal = 64 *
    (oracle::LensVolume(1, 1, 2.5) + oracle::LensVolume(1, 1, t) +
      2.0 * oracle::LensVolume(1, 1, across)) /
    1000.0;
  EXPECT_NEAR(lattice.Values[1].S(0, 0)[5], diagonal, 1e-10);
  EXPECT_NEAR(
    ruc::IsotropyDeviation(lattice)[0][5], std::abs(c - diagonal) / std::sqrt(2.0), 1e-10);

  // Under a quarter turn the lattice is the same, the stretched one is not
  const Window stretched = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 13 }, { true, true, true });
  const auto even =
    ruc::IsotropyDeviation(Along(Lattice(1.0), oracle::PeriodicCube(10.0), Axes, { 0.5, 8 }));
  const auto uneven = ruc::IsotropyDeviation(Along(Lattice(1.3), stretched, Axes, { 0.5, 8 }));
  for (int k = 1; k <= 8; ++k)
  {
    EXPECT_LT(even[0][k], 1e-15);
  }
  // At 2.5 the neighbour along z is 0.75 away from the displaced sphere
  const double full = c / 1.3;
  const double less = 64 * oracle::LensVolume(1, 1, 0.75) / 1300.0;
  EXPECT_NEAR(uneven[0][5], (full - less) / std::sqrt(3.0), 1e-10);

  // A disordered pack: sigma of the stretched one is several times that of the same pack before
  const Window cube = oracle::PeriodicCube(20.0);
  const Window longBox = Window::MakeBox({ 0, 0, 0 }, { 20, 20, 26 }, { true, true, true });
  const SpherePack pack = oracle::RelaxedPack({ 4000 }, { 0.55 }, cube, 11);
  SpherePack longer = pack;
  for (double& z : longer.Z)
  {
    z *= 1.3;
  }
  const ruc::LagGrid lags = { 0.1, 30 };
  const auto before = ruc::IsotropyDeviation(Along(pack, cube, ruc::EvenDirections(30), lags));
  const auto after = ruc::IsotropyDeviation(Along(longer, longBox, ruc::EvenDirections(30), lags));
  EXPECT_GT(ruc::DiscreteNorm(after[0]), 2.0 * ruc::DiscreteNorm(before[0]));
}

TEST(DirectionalProbability, TheSameForAnyRanksAndThreads)
{
  const ruc::LagGrid lags = { 0.21, 20 };
  const std::vector<Vector3> directions = ruc::EvenDirections(5);
  const int threads = omp_get_max_threads();
  for (const Window& window : Windows)
  {
    const SpherePack pack = ruc::CropToWindow(
      oracle::RandomPack({ 60, 90 }, { 0.9, 0.5 }, oracle::PeriodicCube(10.0), 7), window);
    const ruc::DirectionalProbability expected = Along(pack, window, directions, lags);
    for (int count : { 1, 2, 3 })
    {
      omp_set_num_threads(count);
      const ruc::DirectionalProbability got = Along(pack, window, directions, lags);
      for (std::size_t d = 0; d < directions.size(); ++d)
      {
        EXPECT_TRUE(got.Values[d].Values == expected.Values[d].Values);
      }
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
            const ruc::DirectionalProbability got =
              ruc::SumPairsAlong(share, directions, lags, ranks);
            for (std::size_t d = 0; d < directions.size(); ++d)
            {
              EXPECT_TRUE(got.Values[d].Values == expected.Values[d].Values)
                << window.Describe() << " on " << size;
              EXPECT_TRUE(got.Values[d].Fractions == expected.Values[d].Fractions);
            }
          });
      }
    }
  }
}

// More numbers than are summed at a time: each direction is what it is alone
TEST(DirectionalProbability, ManyLagsAndDirections)
{
  const Window box = oracle::PeriodicCube(10.0);
  const SpherePack pack = oracle::RandomPack({ 3 }, { 0.9 }, box, 7);
  const ruc::LagGrid lags = { 1e-4, 40000 };
  const std::vector<Vector3> directions = ruc::EvenDirections(60);
  std::vector<double> told;
  ruc::Communicator serial;
  const ruc::DirectionalProbability all =
    ruc::SumPairsAlong(ruc::SharePack(pack, box), directions, lags, serial,
      [&](double done)
      {
        told.push_back(done);
        return true;
      });
  for (int d : { 0, 25, 26, 59 })
  {
    EXPECT_TRUE(all.Values[d].Values == Along(pack, box, { directions[d] }, lags).Values[0].Values);
  }
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_TRUE(told.empty() || told.back() <= 1.0);
}

TEST(DirectionalProbability, BadInputIsRefused)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false });
  const SpherePack pack = oracle::RandomPack({ 20 }, { 0.9 }, box, 7);
  EXPECT_SAYS(Along(pack, box, Axes, { 0.5, 0 }), "NumberOfLags requires 1 <= NumberOfLags");
  EXPECT_SAYS(Along(pack, box, Axes, { 1.0, 9 }), "MaximumLag requires 0 < MaximumLag <= 8.1918");
  EXPECT_SAYS(Along(pack, box, Axes, { std::nan(""), 9 }), "MaximumLag requires");
  EXPECT_SAYS(Along(pack, box, {}, { 0.5, 9 }), "NumberOfDirections requires 1 <=");
  EXPECT_SAYS(Along(pack, box, ruc::EvenDirections(200), { 8e-5, 100000 }),
    "NumberOfDirections requires 1 <= NumberOfDirections <= 166 for 1 modes and 100000 lags, got "
    "200");
  EXPECT_SAYS(Along(pack, box, { { 1, 1, 0 } }, { 0.5, 9 }), "vectors of length 1, got 1 1 0");
  EXPECT_SAYS(Along(pack, box, { { 1, std::nan(""), 0 } }, { 0.5, 9 }), "vectors of length 1");
}
