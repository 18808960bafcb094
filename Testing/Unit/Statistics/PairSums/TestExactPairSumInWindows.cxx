// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include "Oracles.h"
#include "PairSumComparison.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Results/LagLimit.h"

using ruc::LagGrid;
using ruc::SpherePack;
using ruc::TwoPointProbability;
using ruc::Window;

namespace
{
// Means and standard errors over random windows of a periodic pack, against the periodic pack
// itself. The windowed estimator is exactly unbiased under a uniform random shift, since every pair
// is met with probability gamma / V.
void ExpectUnbiased(const Window& window, std::uint64_t seed, bool distinct)
{
  const double edge = 16.0;
  const Window box = oracle::PeriodicCube(edge);
  SpherePack pack = oracle::RelaxedPack({ 110, 420 }, { 1.0, 0.65 }, box, 5);
  if (distinct)
  {
    pack = WithDistinctRadii(pack);
  }
  const LagGrid lags = { 0.5, 12 };
  const TwoPointProbability exact = ruc::SumPairs(pack, box, lags);
  constexpr int cuts = 40;
  oracle::Uniform random(seed);
  std::vector<TwoPointProbability> measured;
  for (int n = 0; n < cuts; ++n)
  {
    SpherePack moved = pack;
    const ruc::Vector3 shift = { random(0, edge), random(0, edge), random(0, edge) };
    for (std::size_t i = 0; i < moved.Size(); ++i)
    {
      moved.X[i] += shift[0];
      moved.Y[i] += shift[1];
      moved.Z[i] += shift[2];
    }
    ruc::WrapIntoBox(moved, box);
    moved = ruc::CropToWindow(moved, window);
    ruc::SortCanonically(moved);
    measured.push_back(ruc::SumPairs(moved, window, lags));
  }
  for (int r = 0; r < 2; ++r)
  {
    for (int s = r; s < 2; ++s)
    {
      for (int k = 0; k <= lags.Count; k += 2)
      {
        double mean = 0.0, square = 0.0;
        for (const TwoPointProbability& cut : measured)
        {
          mean += cut.S(r, s)[k] / cuts;
        }
        for (const TwoPointProbability& cut : measured)
        {
          square += std::pow(cut.S(r, s)[k] - mean, 2);
        }
        const double error =
          std::sqrt(square / (cuts * (cuts - 1.0))) + 1e-9; // of the mean; S_12(0) has none
        // 42 correlated comparisons with 39 degrees of freedom: with 3 standard errors one in five
        // fails by chance
        EXPECT_NEAR(mean, exact.S(r, s)[k], 4.0 * error) << r << " " << s << " lag " << k;
        // The test can see enough: a window that forgot gamma would be off by 1 - gamma / V, a
        // third and more
        EXPECT_LT(error, 0.05 * exact.Fractions[r] + 1e-8);
      }
    }
  }
}
}

TEST(ExactPairSum, BlockWindowIsUnbiased)
{
  ExpectUnbiased(
    Window::MakeBox({ 0.5, 1.0, 0.0 }, { 10.0, 12.0, 14.0 }, { false, false, false }), 100, false);
}

TEST(ExactPairSum, BlockWindowIsUnbiasedWithManyRadii)
{
  ExpectUnbiased(
    Window::MakeBox({ 0.5, 1.0, 0.0 }, { 12.0, 14.0, 15.0 }, { false, false, false }), 101, true);
}

TEST(ExactPairSum, PartlyPeriodicWindowIsUnbiased)
{
  ExpectUnbiased(
    Window::MakeBox({ 0.0, 0.0, 2.0 }, { 16.0, 16.0, 10.0 }, { true, true, false }), 102, false);
}

TEST(ExactPairSum, CylinderWindowIsUnbiased)
{
  ExpectUnbiased(Window::MakeCylinder({ 8.0, 8.0, 1.0 }, { 0, 0, 1 }, 7.0, 13.0), 103, false);
}

TEST(ExactPairSum, TiltedCylinderWindowIsUnbiased)
{
  const double t = std::sqrt(1.0 / 3.0);
  ExpectUnbiased(
    Window::MakeCylinder({ 8 - 5 * t, 8 - 5 * t, 8 - 5 * t }, { 1, 1, 1 }, 5.0, 10.0), 104, false);
}

TEST(ExactPairSum, WindowAgreesWithTheSumOverItsPairs)
{
  const Window window = Window::MakeCylinder({ 1, 1, 1 }, { 1, 2, 2 }, 4.0, 8.5);
  SpherePack pack = oracle::RelaxedPack({ 250, 900 }, { 0.6, 0.35 }, oracle::PeriodicCube(12.0), 6);
  pack = ruc::CropToWindow(pack, window);
  const LagGrid lags = { 0.3, 14 };
  const TwoPointProbability probability = ruc::SumPairs(pack, window, lags);
  std::vector<std::vector<double>> expected(4, std::vector<double>(lags.Count + 1, 0.0));
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (std::size_t j = 0; j < pack.Size(); ++j)
    {
      const double dx = pack.X[j] - pack.X[i], dy = pack.Y[j] - pack.Y[i],
                   dz = pack.Z[j] - pack.Z[i];
      const double d = std::sqrt(dx * dx + dy * dy + dz * dz);
      for (int k = 0; k <= lags.Count; ++k)
      {
        const double lag = k * lags.Spacing, a = pack.Radius[i], b = pack.Radius[j];
        if (std::abs(d - lag) < a + b)
        {
          expected[2 * pack.Mode[i] + pack.Mode[j] - 3][k] +=
            ruc::OrientationAveragedOverlap(a, b, lag, d).Value / window.SetCovariance(dx, dy, dz);
        }
      }
    }
  }
  ExpectNear(probability.S(0, 0), expected[0], TableError * probability.Fractions[0]);
  ExpectNear(probability.S(0, 1), expected[1],
    TableError * std::min(probability.Fractions[0], probability.Fractions[1]));
  ExpectNear(probability.S(0, 1), expected[2],
    TableError * std::min(probability.Fractions[0], probability.Fractions[1]));
  ExpectNear(probability.S(1, 1), expected[3], TableError * probability.Fractions[1]);
}

TEST(ExactPairSum, ManyRadiiInAWindowAgreeWithTheSumOverPairs)
{
  // Every sphere, large or small, has a radius of its own, so that the closed form is summed in the
  // fixed point of the largest volume
  const Window window = Window::MakeBox({ 0, 0, 0 }, { 14, 15, 16 }, { false, false, false });
  SpherePack pack = oracle::RandomPack({ 1000, 100 }, { 0.3, 1.2 }, window, 9);
  oracle::Uniform random(3);
  for (double& radius : pack.Radius)
  {
    radius *= random(0.8, 1.2);
  }
  ruc::SortCanonically(pack);
  const LagGrid lags = { 1.2, 6 };
  const TwoPointProbability probability = ruc::SumPairs(pack, window, lags);
  std::vector<std::vector<double>> expected(3, std::vector<double>(lags.Count + 1, 0.0));
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (std::size_t j = i; j < pack.Size(); ++j)
    {
      const double dx = pack.X[j] - pack.X[i], dy = pack.Y[j] - pack.Y[i],
                   dz = pack.Z[j] - pack.Z[i];
      const double d = std::sqrt(dx * dx + dy * dy + dz * dz), a = pack.Radius[i],
                   b = pack.Radius[j];
      const double orders = i != j && pack.Mode[i] == pack.Mode[j] ? 2.0 : 1.0;
      for (int k = 0; k <= lags.Count; ++k)
      {
        if (std::abs(d - k * lags.Spacing) < a + b)
        {
          expected[pack.Mode[i] + pack.Mode[j] - 2][k] += orders *
            ruc::OrientationAveragedOverlap(a, b, k * lags.Spacing, d).Value /
            window.SetCovariance(dx, dy, dz);
        }
      }
    }
  }
  for (int pair = 0; pair < 3; ++pair)
  {
    const std::vector<double>& values = probability.S(pair / 2, (pair + 1) / 2);
    for (int k = 1; k <= lags.Count; ++k)
    {
      EXPECT_NEAR(values[k], expected[pair][k], TableError * expected[pair][k])
        << pair << " lag " << k; // as documented
    }
  }
}

TEST(ExactPairSum, LargestLagIsStillExact)
{
  // Up to the largest lag the window allows, where displacements come near its edge and V / gamma
  // grows
  SpherePack pack = oracle::RelaxedPack({ 150 }, { 0.5 }, oracle::PeriodicCube(6.0), 6);
  const Window windows[] = { Window::MakeBox({ 0, 0, 0 }, { 6, 6, 6 }, { false, false, false }),
    Window::MakeCylinder({ 3, 3, 0 }, { 0, 0, 1 }, 3.0, 6.0) };
  for (const Window& window : windows)
  {
    const SpherePack inside = ruc::CropToWindow(pack, window);
    for (double share : { 0.9, 0.99, 1.0 })
    {
      const LagGrid lags = {
        share * ruc::LagLimit::ForPairSum(window, inside.LargestRadius()).Largest / 10.0, 10
      };
      std::vector<double> expected(11, 0.0);
      for (std::size_t i = 0; i < inside.Size(); ++i)
      {
        for (std::size_t j = 0; j < inside.Size(); ++j)
        {
          const double dx = inside.X[j] - inside.X[i], dy = inside.Y[j] - inside.Y[i],
                       dz = inside.Z[j] - inside.Z[i];
          const double d = std::sqrt(dx * dx + dy * dy + dz * dz);
          for (int k = 0; k <= 10; ++k)
          {
            if (std::abs(d - k * lags.Spacing) < 1.0)
            {
              expected[k] += ruc::OrientationAveragedOverlap(0.5, 0.5, k * lags.Spacing, d).Value /
                window.SetCovariance(dx, dy, dz);
            }
          }
        }
      }
      const TwoPointProbability probability = ruc::SumPairs(inside, window, lags);
      SCOPED_TRACE(window.Describe() + ", share " + std::to_string(share));
      // Ten times the error of the tables, as a few pairs of large weight do not average it out
      ExpectNear(probability.S(0, 0), expected, 10.0 * TableError * probability.Fractions[0]);
    }
  }
}
