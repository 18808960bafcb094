// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The standard errors of pair sums against the closed form for centres without correlation, the
// integral range, and the scatter of blocks cut from a pack of hard spheres.

#include "ruc/Statistics/PairSums/PairSumErrors.h"

#include "HardPack.h"
#include "ThreadRanks.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using ruc::Vector3;
using ruc::Window;

constexpr double Radius = 1.0;

// Centres anywhere in the window, with a mean number of them
ruc::SpherePack Scattered(const Window& window, double number, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const Window bounds = window.GetBounds();
  std::poisson_distribution<int> count(number * bounds.Volume() / window.Volume());
  ruc::SpherePack pack;
  for (int left = count(random); left > 0; --left)
  {
    Vector3 centre;
    for (int q = 0; q < 3; ++q)
    {
      centre[q] = bounds.Origin[q] + share(random) * bounds.Size[q];
    }
    if (window.Contains(centre))
    {
      pack.X.push_back(centre[0]);
      pack.Y.push_back(centre[1]);
      pack.Z.push_back(centre[2]);
      pack.Radius.push_back(Radius);
      pack.Mode.push_back(1);
    }
  }
  return pack;
}

ruc::TwoPointErrors FindErrors(const ruc::SpherePack& pack, const Window& window,
  const ruc::LagGrid& lags, int blocks, ruc::Communicator& ranks)
{
  const ruc::PackShare share = ruc::SharePack(pack, window, true, ranks);
  return ruc::FindPairSumErrors(share, ruc::SumPairs(share, lags, ranks), blocks, ranks);
}

ruc::TwoPointErrors FindErrors(
  const ruc::SpherePack& pack, const Window& window, const ruc::LagGrid& lags, int blocks = 64)
{
  ruc::Communicator alone;
  return FindErrors(pack, window, lags, blocks, alone);
}

Window Cube(double edge, bool periodic)
{
  return Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { periodic, periodic, periodic });
}

// The mean of squared errors over packs, of c_1 and of S_1_1 at each lag
std::vector<double> MeanVariances(
  const Window& window, double number, const ruc::LagGrid& lags, int packs)
{
  std::vector<double> means(lags.Count + 2, 0.0);
  for (int n = 0; n < packs; ++n)
  {
    const ruc::TwoPointErrors errors = FindErrors(Scattered(window, number, n), window, lags);
    means[0] += errors.Fractions[0] * errors.Fractions[0] / packs;
    for (int k = 0; k <= lags.Count; ++k)
    {
      means[k + 1] += errors.Values[0][k] * errors.Values[0][k] / packs;
    }
  }
  return means;
}
}

// For a Poisson process of density rho in a periodic box Campbell's theorem gives the variance of
// the sum over pairs: V times rho h^2 + 2 rho^2 int g^2 dx, with h = V_aa(r) + 2 rho v^2. The
// second term is that of two places at once, of which blocks see half where they are apart.
TEST(PairSumErrors, CentresWithoutCorrelation)
{
  const Window box = Cube(24.0, true);
  const double number = 600.0, rho = number / box.Volume(), v = ruc::SphereVolume(Radius);
  const ruc::LagGrid lags = { 0.5, 16 };
  constexpr int packs = 24;
  const std::vector<double> variances = MeanVariances(box, number, lags, packs);
  // Each estimate of a variance from some 60 blocks has a relative error of about sqrt(2 / 40)
  const double bound = 4.0 * std::sqrt(2.0 / 40.0 / packs);
  EXPECT_NEAR(variances[0] / (rho * v * v / box.Volume()), 1.0, bound);
  for (int k = 0; k <= lags.Count; ++k)
  {
    const double r = k * lags.Spacing, step = 0.01;
    double squares = 0.0;
    for (double d = 0.5 * step; d < r + 2.0 * Radius; d += step)
    {
      const double g = ruc::OrientationAveragedOverlap(Radius, Radius, r, d).Value;
      squares += 4.0 * ruc::Pi * d * d * g * g * step;
    }
    const double h = ruc::LensVolume(Radius, Radius, r) + 2.0 * rho * v * v;
    const double one = rho * h * h / box.Volume();
    const double two = 2.0 * rho * rho * squares / box.Volume();
    EXPECT_GT(variances[k + 1], (one + 0.3 * two) * (1.0 - bound)) << "lag " << k;
    EXPECT_LT(variances[k + 1], (one + two) * (1.0 + bound)) << "lag " << k;
  }
}

TEST(PairSumErrors, WindowsOfAnyShape)
{
  constexpr int packs = 24;
  const double v = ruc::SphereVolume(Radius), bound = 4.0 * std::sqrt(2.0 / 40.0 / packs);
  for (const Window& window :
    { Cube(24.0, false), Window::MakeBox({ -3, 2, 1 }, { 20, 24, 30 }, { true, false, false }),
      Window::MakeCylinder({ 1, 2, 3 }, { 1, -2, 2 }, 12.0, 30.0) })
  {
    const std::vector<double> variances = MeanVariances(window, 500.0, { 1.0, 2 }, packs);
    EXPECT_NEAR(variances[0] / (500.0 * v * v) * window.Volume() * window.Volume(), 1.0, bound)
      << window.Describe();
  }
}

// Var c = (1 / V) int (S_11 - c^2) dx, where the integral ends behind the last correlation
TEST(PairSumErrors, IntegralRange)
{
  const HardPack made(2000, 2000, 0.45);
  const ruc::LagGrid lags = { 0.05, 160 };
  const ruc::TwoPointProbability sums = ruc::SumPairs(made.Pack, made.Box, lags);
  const ruc::TwoPointErrors errors = FindErrors(made.Pack, made.Box, lags);
  for (int r = 0; r < 2; ++r)
  {
    double range = 0.0;
    for (int k = 1; k <= lags.Count; ++k)
    {
      const double lag = k * lags.Spacing, c = sums.Fractions[r];
      // Ends smoothly, over lags from 4 to 8, as the sum to a sharp end rings
      const double end = std::clamp(2.0 - lag / 4.0, 0.0, 1.0);
      range += 4.0 * ruc::Pi * lag * lag * lags.Spacing * end * (sums.S(r, r)[k] - c * c);
    }
    const double variance = errors.Fractions[r] * errors.Fractions[r];
    // Either has a relative error of about a quarter
    EXPECT_GT(variance / (range / made.Box.Volume()), 0.5) << "mode " << r + 1;
    EXPECT_LT(variance / (range / made.Box.Volume()), 2.0) << "mode " << r + 1;
  }
}

// The errors that blocks of a pack tell of themselves are those of their scatter. The program
// BenchmarkErrors compares more of them.
TEST(PairSumErrors, ScatterOfBlocks)
{
  const HardPack made(2700, 2700, 0.45);
  constexpr int Edge = 3, Number = Edge * Edge * Edge;
  const double edge = made.Box.Size[0] / Edge;
  const ruc::LagGrid lags = { 0.4 * edge / 12, 12 };
  std::vector<ruc::TwoPointProbability> sums;
  std::vector<ruc::TwoPointErrors> errors;
  for (int n = 0; n < Number; ++n)
  {
    const Window window =
      Window::MakeBox({ n % Edge * edge, n / Edge % Edge * edge, n / Edge / Edge * edge },
        { edge, edge, edge }, { false, false, false });
    ruc::SpherePack part;
    for (std::size_t i = 0; i < made.Pack.Size(); ++i)
    {
      if (window.Contains(made.Pack.Centre(i)))
      {
        part.Append(made.Pack, i);
      }
    }
    sums.push_back(ruc::SumPairs(part, window, lags));
    errors.push_back(FindErrors(part, window, lags, 27));
  }
  double ratio = 0.0, within1 = 0.0, within2 = 0.0;
  int count = 0;
  for (int pair = 0; pair < sums.front().Pairs(); ++pair)
  {
    for (int k = 1; k <= lags.Count; ++k, ++count)
    {
      double mean = 0.0, squares = 0.0, variance = 0.0;
      for (int n = 0; n < Number; ++n)
      {
        mean += sums[n].Values[pair][k] / Number;
        variance += errors[n].Values[pair][k] * errors[n].Values[pair][k] / Number;
      }
      for (int n = 0; n < Number; ++n)
      {
        const double off = std::abs(sums[n].Values[pair][k] - mean);
        squares += off * off / (Number - 1);
        within1 += off < errors[n].Values[pair][k] ? 1.0 / Number : 0.0;
        within2 += off < 1.96 * errors[n].Values[pair][k] ? 1.0 / Number : 0.0;
      }
      ratio += std::sqrt(variance / squares);
    }
  }
  // 15 % besides the relative error of a scatter of 27, sqrt(1 / 52)
  EXPECT_NEAR(ratio / count, 1.0, 0.15 + std::sqrt(1.0 / 52.0));
  // Binomial bounds, three deviations for 27 blocks
  EXPECT_NEAR(within1 / count, 0.683, 3.0 * std::sqrt(0.683 * 0.317 / Number));
  EXPECT_NEAR(within2 / count, 0.95, 3.0 * std::sqrt(0.95 * 0.05 / Number));
}

TEST(PairSumErrors, TheSameOnRanksAndThreads)
{
  const HardPack made(150, 350, 0.4, false);
  const ruc::LagGrid lags = { 0.2, 20 };
  const ruc::TwoPointErrors expected = FindErrors(made.Pack, made.Box, lags, 27);
  for (int size : { 2, 3 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        ruc::SpherePack own;
        for (std::size_t i = ranks.Rank(); i < made.Pack.Size(); i += size)
        {
          own.Append(made.Pack, i);
        }
        const ruc::TwoPointErrors errors = FindErrors(own, made.Box, lags, 27, ranks);
        EXPECT_TRUE(errors.Values == expected.Values);
        EXPECT_TRUE(errors.Fractions == expected.Fractions);
        EXPECT_EQ(errors.Surface, expected.Surface);
      });
  }
  const int before = omp_get_max_threads();
  omp_set_num_threads(3);
  EXPECT_TRUE(FindErrors(made.Pack, made.Box, lags, 27).Values == expected.Values);
  omp_set_num_threads(before);
}

// Sums of errors: the surface of spheres of one size is their volume times 3 / a, and what is not
// one mode is the matrix
TEST(PairSumErrors, SurfaceAndMatrix)
{
  const Window box = Cube(24.0, false);
  const ruc::TwoPointErrors errors = FindErrors(Scattered(box, 600.0, 3), box, { 1.0, 4 });
  EXPECT_NEAR(errors.Surface, 3.0 / Radius * errors.Fractions[0], 1e-6 * errors.Surface);
  EXPECT_NEAR(errors.Fractions[0], errors.Fractions[1], 1e-9);
}

TEST(PairSumErrors, OneSphere)
{
  ruc::SpherePack pack;
  pack.X = pack.Y = pack.Z = { 5.0 };
  pack.Radius = { 1.0 };
  pack.Mode = { 1 };
  for (const auto& of : FindErrors(pack, Cube(20.0, false), { 1.0, 10 }).Values)
  {
    for (double error : of)
    {
      EXPECT_TRUE(std::isfinite(error));
    }
  }
}

TEST(PairSumErrors, NoRoomForBlocks)
{
  const HardPack made(10, 10, 0.3);
  try
  {
    FindErrors(made.Pack, made.Box, { 0.1, 4 });
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("Blocks requires a window with room for 8 blocks"),
      std::string::npos)
      << error.what();
  }
}

namespace
{
// Leaves spheres out the more, the farther they are along an axis, or from the axis z
ruc::SpherePack Thinned(ruc::SpherePack pack, const Window& window, int axis, double share)
{
  std::mt19937 random(7);
  ruc::SpherePack left;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const Vector3 at = pack.Centre(i);
    const double place = axis == 3 ? std::hypot(at[0], at[1]) / window.Radius
                                   : (at[axis] - window.Origin[axis]) / window.Size[axis];
    if (std::uniform_real_distribution<double>(0.0, 1.0)(random) > share * place)
    {
      left.Append(pack, i);
    }
  }
  return left;
}

std::string Failures(const ruc::SpherePack& pack, const Window& window)
{
  return ruc::DescribeFailures(FindErrors(pack, window, { 1.0, 4 }).Layers);
}
}

// A layer at a wall raises S_m_m at long lags above c_m squared; it counts where it is more than 3
// % and more than three standard errors
TEST(PairSumErrors, LayersAtWallsAreTold)
{
  ruc::TwoPointProbability sums(1, { 1.0, 2 });
  sums.Fractions = { 0.6, 0.4 };
  ruc::TwoPointErrors errors;
  errors.Values.assign(3, std::vector<double>(3, 0.001));
  sums.S(1, 1)[2] = 0.16 + 0.004;
  EXPECT_EQ(ruc::DescribeWalls(sums, errors), "");
  sums.S(1, 1)[2] = 0.16 + 0.008;
  EXPECT_EQ(ruc::DescribeWalls(sums, errors).find("At the last lag S_m_m is 0.168"), 0u);
  errors.Values[sums.PairOf(1, 1)][2] = 0.003;
  EXPECT_EQ(ruc::DescribeWalls(sums, errors), "");
}

TEST(OneMedium, LayersAlongOneAxis)
{
  const Window box = Cube(24.0, false);
  const ruc::SpherePack pack = Scattered(box, 2000.0, 11);
  EXPECT_EQ(Failures(pack, box), "");
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string text = Failures(Thinned(pack, box, axis, 0.5), box);
    EXPECT_EQ(text.find(std::string("Along ") + char('x' + axis)), 0u) << text;
    EXPECT_EQ(text.find("Along", 1), std::string::npos) << text;
  }
}

TEST(OneMedium, RingsOfACylinder)
{
  const Window cylinder = Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 14.0, 25.0);
  const ruc::SpherePack pack = Scattered(cylinder, 3000.0, 12);
  EXPECT_EQ(Failures(pack, cylinder), "");
  const std::string text = Failures(Thinned(pack, cylinder, 3, 0.6), cylinder);
  EXPECT_EQ(text.find("Along the radius"), 0u) << text;
}

// In a pack of one medium a test fails once in a thousand
TEST(OneMedium, FailsSeldom)
{
  const Window box = Cube(24.0, false);
  int failures = 0;
  double mean = 0.0;
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    for (const ruc::LayerTest& test :
      FindErrors(Scattered(box, 400.0, 100 + seed), box, { 1.0, 2 }).Layers)
    {
      failures += !test.Passed();
      mean += test.ChiSquared / test.Freedoms / 90.0;
    }
  }
  EXPECT_LE(failures, 2);
  // The mean of 90 ratios, of three freedoms each, of variances
  EXPECT_NEAR(mean, 1.0, 4.0 * std::sqrt(2.0 / 3.0 / 90.0) + 2.0 / 40.0);
}
