// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/RadialDistribution.h"

#include "Oracles.h"
#include "ThreadRanks.h"

#include <omp.h>

namespace
{
using ruc::SpherePack;
using ruc::Window;

ruc::RadialDistribution Measure(
  const SpherePack& pack, const Window& window, const ruc::LagGrid& lags)
{
  ruc::Communicator serial;
  return ruc::MeasureRadialDistribution(ruc::SharePack(pack, window), lags, serial);
}

double Shell(const ruc::LagGrid& lags, int k)
{
  const double low = k > 0 ? (k - 0.5) * lags.Spacing : 0.0, high = (k + 0.5) * lags.Spacing;
  return 4.0 / 3.0 * oracle::Pi * (high * high * high - low * low * low);
}

// The functions of two modes: (1,1), (1,2), (2,2) and, last, the total
std::array<std::vector<double>, 4> BruteForce(
  const SpherePack& pack, const Window& window, const ruc::LagGrid& lags)
{
  std::array<std::vector<double>, 4> g;
  g.fill(std::vector<double>(lags.Count + 1, 0.0));
  double count[2] = { 0.0, 0.0 };
  for (int mode : pack.Mode)
  {
    ++count[mode - 1];
  }
  const double all = count[0] + count[1];
  // The numbers of ordered pairs that there are
  const double number[4] = { count[0] * (count[0] - 1.0), count[0] * count[1],
    count[1] * (count[1] - 1.0), all * (all - 1.0) };
  oracle::ForEachPair(pack, window, (lags.Count + 0.5) * lags.Spacing,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>& image, double d)
    {
      const double weight = window.Volume() /
        window.SetCovariance(pack.X[j] + image[0] * window.Size[0] - pack.X[i],
          pack.Y[j] + image[1] * window.Size[1] - pack.Y[i],
          pack.Z[j] + image[2] * window.Size[2] - pack.Z[i]);
      int k = 0;
      while (d >= (k + 0.5) * lags.Spacing)
      {
        ++k;
      }
      g[pack.Mode[i] + pack.Mode[j] - 2][k] += pack.Mode[i] == pack.Mode[j] ? 2.0 * weight : weight;
      g[3][k] += 2.0 * weight;
    });
  for (int f = 0; f < 4; ++f)
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      g[f][k] *= window.Volume() / number[f] / Shell(lags, k);
    }
  }
  return g;
}

const std::vector<Window> DistributionWindows = {
  oracle::PeriodicCube(10.0),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false }),
  Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { true, false, true }),
  Window::MakeCylinder({ 3, 4, 1 }, { 0.3, 0.2, 1.0 }, 3.5, 8.0),
};

SpherePack PackIn(const Window& window)
{
  return ruc::CropToWindow(
    oracle::RandomPack({ 150, 250 }, { 0.2, 0.1 }, oracle::PeriodicCube(10.0), 9), window);
}
}

TEST(RadialDistribution, EqualsBruteForceOverPairs)
{
  for (const Window& window : DistributionWindows)
  {
    const SpherePack pack = PackIn(window);
    for (const ruc::LagGrid& lags : { ruc::LagGrid{ 0.31, 20 }, ruc::LagGrid{ 3.0, 1 } })
    {
      const ruc::RadialDistribution got = Measure(pack, window, lags);
      const auto expected = BruteForce(pack, window, lags);
      ASSERT_EQ(got.Values.size(), 3u);
      for (int f = 0; f < 4; ++f)
      {
        const std::vector<double>& values = f < 3 ? got.Values[f] : got.Total;
        ASSERT_EQ(values.size(), expected[f].size());
        for (int k = 0; k <= lags.Count; ++k)
        {
          // Weights are rounded to 2^-35 of the greatest, 1e2 to 1e3 near the corner of a window
          EXPECT_NEAR(values[k], expected[f][k], 1e-6 * (1.0 + expected[f][k]))
            << window.Describe() << ' ' << f << ' ' << k;
        }
      }
    }
  }
}

TEST(RadialDistribution, IndependentCentresHaveOne)
{
  for (const Window& window : DistributionWindows)
  {
    // Averaged over packs, with the error that their scatter shows: pairs share centres and have
    // weights, so that counting them would not do
    constexpr int packs = 20;
    const ruc::LagGrid lags = { 0.7, 8 };
    std::vector<double> sum(lags.Count + 1, 0.0), square(lags.Count + 1, 0.0);
    for (int n = 0; n < packs; ++n)
    {
      const SpherePack pack = ruc::CropToWindow(
        oracle::RandomPack({ 200, 400 }, { 0.01, 0.01 }, oracle::PeriodicCube(10.0), 100 + n),
        window);
      const ruc::RadialDistribution g = Measure(pack, window, lags);
      for (int k = 1; k <= lags.Count; ++k)
      {
        const double value = g.Values[g.PairOf(1, 0)][k];
        sum[k] += value / packs;
        square[k] += value * value / packs;
      }
    }
    for (int k = 1; k <= lags.Count; ++k)
    {
      const double error = std::sqrt((square[k] - sum[k] * sum[k]) / (packs - 1.0));
      EXPECT_LT(error, 0.05);
      EXPECT_NEAR(sum[k], 1.0, 4.0 * error) << window.Describe() << ' ' << k;
    }
  }
  // One periodic pack against the Poisson error of the count of pairs, which do not depend on each
  // other there
  const SpherePack pack = oracle::RandomPack({ 2000 }, { 0.01 }, oracle::PeriodicCube(10.0), 3);
  const ruc::LagGrid lags = { 0.2, 20 };
  const ruc::RadialDistribution g = Measure(pack, oracle::PeriodicCube(10.0), lags);
  for (int k = 0; k <= lags.Count; ++k)
  {
    const double pairs = 0.5 * 2000 * 1999 * Shell(lags, k) / 1000.0;
    EXPECT_NEAR(g.Total[k], 1.0, 4.0 / std::sqrt(pairs)) << k;
    EXPECT_EQ(g.Total[k], g.Values[0][k]);
  }
}

TEST(RadialDistribution, LatticeByCounting)
{
  SpherePack pack;
  for (int n = 0; n < 125; ++n)
  {
    pack.X.push_back(2.0 * (n % 5));
    pack.Y.push_back(2.0 * (n / 5 % 5));
    pack.Z.push_back(2.0 * (n / 25));
    pack.Radius.push_back(0.5);
    pack.Mode.push_back(1);
  }
  // Neighbours of a simple cubic lattice at 2 sqrt(1, 2, 3, 4, 5, 6): 6, 12, 8, 6, 24, 24; in bins
  // of 0.1 at 20, 28, 35, 40, 45, 49
  const ruc::LagGrid lags = { 0.1, 50 };
  const ruc::RadialDistribution g = Measure(pack, oracle::PeriodicCube(10.0), lags);
  std::vector<double> neighbours(lags.Count + 1, 0.0);
  neighbours[20] = 6;
  neighbours[28] = 12;
  neighbours[35] = 8;
  neighbours[40] = 6;
  neighbours[45] = 24;
  neighbours[49] = 24;
  for (int k = 0; k <= lags.Count; ++k)
  {
    EXPECT_NEAR(g.Total[k], neighbours[k] / (124.0 * Shell(lags, k) / 1000.0), 1e-8) << k;
  }
}

TEST(RadialDistribution, OneSphereOfAModeHasNoPairs)
{
  const Window box = oracle::PeriodicCube(10.0);
  const ruc::RadialDistribution g =
    Measure(oracle::RandomPack({ 1, 2 }, { 0.5, 0.5 }, box, 3), box, { 1.0, 4 });
  EXPECT_TRUE(std::isnan(g.Values[0][2]));
  EXPECT_TRUE(std::isfinite(g.Values[1][2]));
  EXPECT_TRUE(std::isfinite(g.Values[2][2]));
  EXPECT_TRUE(std::isfinite(g.Total[2]));
  const ruc::RadialDistribution one =
    Measure(oracle::RandomPack({ 1 }, { 0.5 }, box, 3), box, { 1.0, 4 });
  EXPECT_TRUE(std::isnan(one.Total[4]));
}

TEST(RadialDistribution, TheSameForAnyRanksAndThreads)
{
  const ruc::LagGrid lags = { 0.31, 20 };
  const int threads = omp_get_max_threads();
  for (const Window& window : DistributionWindows)
  {
    const SpherePack pack = PackIn(window);
    const ruc::RadialDistribution expected = Measure(pack, window, lags);
    for (int count : { 1, 2, 3 })
    {
      omp_set_num_threads(count);
      EXPECT_TRUE(Measure(pack, window, lags).Values == expected.Values);
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
            const ruc::RadialDistribution got = ruc::MeasureRadialDistribution(share, lags, ranks);
            EXPECT_TRUE(got.Values == expected.Values) << window.Describe() << " on " << size;
            EXPECT_TRUE(got.Total == expected.Total);
          });
      }
    }
  }
}

TEST(RadialDistribution, BadInputIsRefused)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false });
  const SpherePack pack = oracle::RandomPack({ 20 }, { 0.9 }, box, 7);
  EXPECT_SAYS(Measure(pack, box, { 0.5, 0 }), "NumberOfLags requires 1 <= NumberOfLags");
  EXPECT_SAYS(Measure(pack, box, { 0.5, 20 }), "MaximumLag requires 0 < MaximumLag <= 9.746");
  EXPECT_SAYS(Measure(pack, box, { 0.0, 20 }), "MaximumLag requires");
  EXPECT_SAYS(Measure(pack, box, { std::nan(""), 20 }), "MaximumLag requires");
  EXPECT_NO_THROW(Measure(pack, box, { 9.74 / 20, 20 }));
}
