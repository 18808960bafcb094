// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanSampling.h"

#include "Oracles.h"
#include "Statistics/Sampling/FanMedia.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

namespace
{
using namespace fans;
using oracle::Pi;
}

TEST(FanSampling, BooleanModel)
{
  // N spheres at random in a periodic cube: in the mean over realisations S_mmm = (1 - V_union /
  // V)^N, which tends to exp(-rho V_union). The scatter of the realisations, each sampled anew, is
  // the standard error. Some 200 numbers: 4.5 standard errors.
  constexpr int realisations = 60, spheres = 60;
  constexpr double a = 0.7, edge = 5.0;
  const ThreePointGrid grid = { { 0.4, 5 }, 10 }; // the triangle's sides up to edge - 2 a: 3.6
  const SamplingRegion region(oracle::PeriodicCube(edge), 0.0);
  MeanFunction mean(grid.Size());
  for (int n = 1; n <= realisations; ++n)
  {
    const SpherePack pack = oracle::RandomPack({ spheres }, { a }, region.GetBounds(), 100 + n);
    const ThreePointProbability sampled =
      Fans(pack, 1, region, grid, { { 1, 1, 1 } }, { static_cast<std::uint32_t>(n), 640, false });
    std::vector<double> values;
    ForEachPlace(
      grid, [&](int k1, int k2, int t) { values.push_back(sampled.Value(0, k1, k2, t)); });
    mean.Add(values);
  }
  int compared = 0;
  ForEachPlace(grid,
    [&](int k1, int k2, int t)
    {
      const double r1 = 0.4 * k1, r2 = 0.4 * k2, theta = Pi * t / 5.0;
      if (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * std::cos(theta) > 3.6 * 3.6)
      {
        return; // the third side meets an image
      }
      const auto place = static_cast<int>(grid.PlaceOf(k1, k2, t));
      const double expected =
        std::pow(1.0 - oracle::UnionOfThree(a, r1, r2, theta) / std::pow(edge, 3), spheres);
      EXPECT_NEAR(mean.Value(place), expected, 4.5 * mean.Error(place))
        << k1 << " " << k2 << " " << t;
      EXPECT_LT(mean.Error(place), 0.02);
      ++compared;
    });
  EXPECT_GT(compared, 180);
}

TEST(FanSampling, OneSphereInAPeriodicBox)
{
  // S_111 = V_common / V and S_mmm = 1 - V_union / V while no side of the triangle reaches an image
  constexpr double a = 1.0, edge = 5.0;
  const SamplingRegion region(oracle::PeriodicCube(edge), 0.0);
  const SpherePack pack = oracle::RandomPack({ 1 }, { a }, region.GetBounds(), 2);
  const ThreePointGrid grid = { { 0.3, 8 }, 16 };
  const ThreePointProbability sampled =
    Fans(pack, 1, region, grid, { { 0, 0, 0 }, { 1, 1, 1 } }, { 3, 12800, true });
  int compared = 0;
  ForEachPlace(grid,
    [&](int k1, int k2, int t)
    {
      const double r1 = 0.3 * k1, r2 = 0.3 * k2, theta = Pi * t / 8.0;
      if (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * std::cos(theta) >= 9.0)
      {
        return;
      }
      const double volume = std::pow(edge, 3);
      // 5 standard errors, with 1200 numbers; a count of a rare event is not normally distributed,
      // of which five events of the pairs of a throw may be
      const double common = oracle::CommonToThree(a, r1, r2, theta) / volume;
      const double rare = 5.0 * grid.Directions / (12800.0 * grid.RayPairs(t));
      EXPECT_NEAR(
        sampled.Value(0, k1, k2, t), common, 5.0 * sampled.Error(0, k1, k2, t) + rare + 1e-15)
        << k1 << " " << k2 << " " << t;
      EXPECT_NEAR(sampled.Value(1, k1, k2, t),
        1.0 - oracle::UnionOfThree(a, r1, r2, theta) / volume, 5.0 * sampled.Error(1, k1, k2, t))
        << k1 << " " << k2 << " " << t;
      EXPECT_LT(sampled.Error(0, k1, k2, t), 0.002);
      EXPECT_LT(sampled.Error(1, k1, k2, t), 0.004);
      ++compared;
    });
  EXPECT_GT(compared, 500);
}

TEST(FanSampling, PointsFarApartAreIndependent)
{
  // Six radii and more apart in a random pack of many spheres. What is left of correlations is, to
  // first order, that of the three pairs of points, which the exact pair sum knows.
  constexpr double edge = 14.0, lag = 6.0;
  const Window box = oracle::PeriodicCube(edge);
  const SpherePack pack = oracle::RelaxedPack({ 100, 200 }, { 0.9, 0.7 }, box, 3);
  const ThreePointGrid grid = { { lag, 1 }, 6 };
  const std::vector<PhaseTriple> triples = ruc::ParseTriples("all", 2);
  const ThreePointProbability sampled =
    Fans(pack, 2, SamplingRegion(box, 0.0), grid, triples, { 5, 12800, true });
  const ruc::TwoPointProbability near = ruc::SumPairs(pack, box, { lag, 1 });
  const std::vector<double>& c = near.Fractions;
  for (int t = 1; t < grid.Angles(); ++t)
  {
    const double third = 2.0 * lag * std::sin(Pi * t / 6.0);
    const ruc::TwoPointProbability far = ruc::SumPairs(pack, box, { third, 1 });
    const auto correlation = [&](const ruc::TwoPointProbability& pairs, int r, int s)
    { return std::abs(pairs.S(r, s)[1] / (c[r] * c[s]) - 1.0); };
    for (std::size_t n = 0; n < triples.size(); ++n)
    {
      const auto [r, s, q] = triples[n];
      const double apart = c[r] * c[s] * c[q];
      const double left =
        correlation(near, r, s) + correlation(near, r, q) + correlation(far, s, q);
      EXPECT_LT(left, 0.2);
      EXPECT_NEAR(sampled.Value(n, 1, 1, t), apart, 4.5 * sampled.Error(n, 1, 1, t) + left * apart)
        << ruc::TripleName(triples[n], 2) << " " << t;
      EXPECT_LT(sampled.Error(n, 1, 1, t), 0.05 * std::sqrt(apart));
    }
  }
}

TEST(FanSampling, PackTurnedByARightAngle)
{
  // About the z axis through the middle of a cube; the same estimate within the errors of two runs
  const Window cube = Window::MakeBox({ 0, 0, 0 }, { 7, 7, 7 }, { false, false, false });
  SpherePack pack = oracle::RandomPack({ 25, 40 }, { 0.9, 0.6 }, cube, 9);
  SpherePack turned = pack;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    // Denser on one side, so that the turn is seen by whoever should not see it
    pack.X[i] = 7.0 * std::pow(pack.X[i] / 7.0, 1.5);
    turned.X[i] = 7.0 - pack.Y[i];
    turned.Y[i] = pack.X[i];
  }
  const SamplingRegion region(cube, 0.9);
  const ThreePointGrid grid = { { 0.5, 5 }, 8 };
  const ThreePointProbability before = Fans(pack, 2, region, grid, Triples, { 1, 6400, true });
  const ThreePointProbability after = Fans(turned, 2, region, grid, Triples, { 2, 6400, true });
  for (std::size_t n = 0; n < Triples.size(); ++n)
  {
    ForEachPlace(grid,
      [&](int k1, int k2, int t)
      {
        const double error = std::hypot(before.Error(n, k1, k2, t), after.Error(n, k1, k2, t));
        // A count of 0 or a few in one of the runs says little of the error
        EXPECT_NEAR(before.Value(n, k1, k2, t), after.Value(n, k1, k2, t), 5.0 * error + 2e-4)
          << n << " " << k1 << " " << k2 << " " << t;
        EXPECT_LT(error, 0.02);
      });
  }
}

TEST(FanSampling, StandardErrorsCover)
{
  // Of 300 independent runs 68.3 % and 95.4 % are to be within one and two standard errors (67.9
  // and 95.0 % with 64 batches): 204 and 285, with binomial standard deviations of 8.1 and 3.8. The
  // bounds are 4 of these away; 14 quantities are looked at.
  constexpr double a = 1.2, edge = 4.0;
  const SamplingRegion region(oracle::PeriodicCube(edge), 0.0);
  const SpherePack pack = oracle::RandomPack({ 1 }, { a }, region.GetBounds(), 4);
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  const int places[][3] = { { 0, 0, 0 }, { 1, 0, 2 }, { 1, 1, 0 }, { 1, 2, 1 }, { 2, 2, 1 },
    { 3, 1, 0 }, { 1, 1, 4 } };
  int within[2][7][2] = {};
  for (std::uint32_t seed = 1; seed <= 300; ++seed)
  {
    const ThreePointProbability sampled =
      Fans(pack, 1, region, grid, { { 0, 0, 0 }, { 1, 1, 1 } }, { seed, 1280, true });
    for (int n = 0; n < 7; ++n)
    {
      const auto [k1, k2, t] = places[n];
      const double r1 = 0.4 * k1, r2 = 0.4 * k2, theta = Pi * t / 4.0;
      const double expected[2] = { oracle::CommonToThree(a, r1, r2, theta) / std::pow(edge, 3),
        1.0 - oracle::UnionOfThree(a, r1, r2, theta) / std::pow(edge, 3) };
      for (int phase = 0; phase < 2; ++phase)
      {
        const double off = std::abs(sampled.Value(phase, k1, k2, t) - expected[phase]) /
          sampled.Error(phase, k1, k2, t);
        within[phase][n][0] += off < 1.0;
        within[phase][n][1] += off < 2.0;
      }
    }
  }
  for (int phase = 0; phase < 2; ++phase)
  {
    for (int n = 0; n < 7; ++n)
    {
      EXPECT_NEAR(within[phase][n][0], 204, 33) << phase << " " << n;
      EXPECT_NEAR(within[phase][n][1], 285, 16) << phase << " " << n;
    }
  }
}
