// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairKernel.h"

#include "Oracles.h"
#include "ruc/Particles/SphereOverlap.h"

namespace
{
struct Case
{
  double A, B;
  ruc::LagGrid Lags;
};
// Knots finer than the lags, coarser, and equal; radii that are equal, near and far
const Case Cases[] = { { 1.0, 1.0, { 0.05, 80 } }, { 1.0, 1.0, { 0.5, 9 } },
  { 1.0, 0.7, { 0.05, 80 } }, { 0.7, 1.0, { 0.031, 120 } }, { 0.2, 1.5, { 0.3, 12 } },
  { 0.2, 1.5, { 0.011, 200 } }, { 1.0, 0.8, { 0.1, 50 } }, { 1.0, 1.0, { 7.0, 2 } },
  { 1.0, 0.9, { 0.001, 5 } } };

double CutoffOf(const Case& c)
{
  return c.Lags.Maximum() + 2.0 * std::max(c.A, c.B);
}

// The cubic Hermite weights of a distance, written out from their definition
void AddWeights(
  const ruc::PairKernel& kernel, double d, double weight, std::vector<double>& weights)
{
  const double u = (d - kernel.First) / kernel.Spacing;
  const int m = static_cast<int>(u);
  const double t = u - m;
  ASSERT_GE(m, 0);
  ASSERT_LT(m, kernel.Intervals);
  weights[2 * m] += weight * (1 + 2 * t) * (1 - t) * (1 - t);
  weights[2 * m + 1] += weight * t * (1 - t) * (1 - t);
  weights[2 * m + 2] += weight * t * t * (3 - 2 * t);
  weights[2 * m + 3] += weight * t * t * (t - 1);
}

double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    sum += a[n] * b[n];
  }
  return sum;
}
}

TEST(PairKernel, KnotsReachFromZeroToTheCutoffAndHoldTheContact)
{
  for (const Case& c : Cases)
  {
    const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
    EXPECT_LE(kernel.First, 1e-12);
    EXPECT_GE(kernel.First + kernel.Intervals * kernel.Spacing, CutoffOf(c));
    EXPECT_LE(kernel.Spacing, 0.125 * std::min(c.A, c.B) * (1 + 1e-12));
    const double contact = (c.A + c.B - kernel.First) / kernel.Spacing;
    EXPECT_NEAR(contact, std::round(contact), 1e-9);
    const double ratio = std::max(kernel.Spacing / c.Lags.Spacing, c.Lags.Spacing / kernel.Spacing);
    EXPECT_NEAR(ratio, std::round(ratio), 1e-9);
  }
}

TEST(PairKernel, IsExactOnKnots)
{
  for (const Case& c : Cases)
  {
    const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
    const double unit = ruc::SphereVolume(std::min(c.A, c.B));
    for (int m = 0; m <= kernel.Intervals; ++m)
    {
      const double d = kernel.First + m * kernel.Spacing;
      for (int part : { 0, 1 })
      {
        std::vector<double> weights(kernel.Size(), 0.0), sums(c.Lags.Count + 1, 0.0);
        weights[2 * m + part] = 1.0;
        kernel.AddOverlap(weights.data(), sums.data());
        for (int k = 0; k <= c.Lags.Count; ++k)
        {
          const ruc::AveragedOverlap g =
            ruc::OrientationAveragedOverlap(c.A, c.B, k * c.Lags.Spacing, d);
          // 1e-10: rounding of h, divided by 2 d r
          EXPECT_NEAR(sums[k], part == 0 ? g.Value : kernel.Spacing * g.Slope, 1e-10 * unit)
            << "knot " << m << " lag " << k;
        }
      }
    }
  }
}

TEST(PairKernel, BetweenKnotsTheErrorIsThatOfHermiteInterpolation)
{
  for (const Case& c : Cases)
  {
    const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
    const double unit = ruc::SphereVolume(std::min(c.A, c.B));
    oracle::Uniform random(1);
    for (int n = 0; n < 400; ++n)
    {
      const double d = random(0.8 * (c.A + c.B), CutoffOf(c));
      std::vector<double> weights(kernel.Size(), 0.0), sums(c.Lags.Count + 1, 0.0);
      AddWeights(kernel, d, 1.0, weights);
      kernel.AddOverlap(weights.data(), sums.data());
      for (int k = 0; k <= c.Lags.Count; ++k)
      {
        const double r = k * c.Lags.Spacing;
        const double bound =
          oracle::HermiteError(c.A, c.B, r, d, kernel.Spacing) + 1e-10 * unit; // and rounding
        EXPECT_NEAR(sums[k], oracle::AveragedLens(c.A, c.B, r, d), bound)
          << "a " << c.A << " b " << c.B << " d " << d << " r " << r << " knots " << kernel.Spacing;
      }
      if (n > 20 && c.Lags.Count > 50)
      {
        break; // the quadrature is dear
      }
    }
  }
}

TEST(PairKernel, SumOverManyPairsIsGoodToOneInAMillion)
{
  // The errors of single distances change sign from knot to knot; what counts is the sum over the
  // pairs of a pack.
  for (const Case& c : Cases)
  {
    const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
    oracle::Uniform random(2);
    std::vector<double> weights(kernel.Size(), 0.0), sums(c.Lags.Count + 1, 0.0),
      expected(c.Lags.Count + 1, 0.0);
    constexpr int pairs = 20000;
    for (int n = 0; n < pairs; ++n)
    {
      const double d =
        std::cbrt(random(std::pow(c.A + c.B, 3), std::pow(CutoffOf(c), 3))); // uniform in space
      AddWeights(kernel, d, 1.0, weights);
      for (int k = 0; k <= c.Lags.Count; ++k)
      {
        expected[k] += ruc::OrientationAveragedOverlap(c.A, c.B, k * c.Lags.Spacing, d).Value;
      }
    }
    kernel.AddOverlap(weights.data(), sums.data());
    for (int k = 0; k <= c.Lags.Count; ++k)
    {
      EXPECT_NEAR(sums[k], expected[k], 1e-6 * pairs * ruc::SphereVolume(std::min(c.A, c.B))) << k;
    }
  }
}

TEST(PairKernel, PotentialIsTheTransposeOfTheOverlap)
{
  for (const Case& c : Cases)
  {
    const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
    oracle::Uniform random(3);
    std::vector<double> weights(kernel.Size()), lambda(c.Lags.Count + 1);
    std::vector<double> sums(lambda.size(), 0.0), potential(weights.size(), 0.0);
    for (double& w : weights)
    {
      w = random(); // all positive, so that the products cannot cancel
    }
    for (double& l : lambda)
    {
      l = random();
    }
    kernel.AddOverlap(weights.data(), sums.data());
    kernel.AddPotential(lambda.data(), potential.data());
    double magnitude = 0.0;
    for (std::size_t n = 0; n < weights.size(); ++n)
    {
      magnitude += weights[n] * std::abs(potential[n]);
    }
    EXPECT_GT(magnitude, 0.0);
    EXPECT_NEAR(
      Dot(lambda, sums), Dot(weights, potential), 1e-12 * magnitude); // rounding of ~1e3 terms
  }
}

TEST(PairKernel, SumsAddUp)
{
  const Case& c = Cases[2];
  const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
  std::vector<double> weights(kernel.Size(), 0.0), sums(c.Lags.Count + 1, 1.0);
  kernel.AddOverlap(weights.data(), sums.data());
  EXPECT_EQ(sums, std::vector<double>(c.Lags.Count + 1, 1.0)); // what is there stays
}

TEST(PairKernel, PenaltyIsTheSquareOfTheOverlap)
{
  for (const Case& c : Cases)
  {
    const ruc::PairKernel kernel(c.A, c.B, c.Lags, CutoffOf(c));
    std::vector<double> potential(kernel.Size(), 0.0);
    const double contact = c.A + c.B;
    kernel.AddOverlapPenalty(3.0, contact, potential.data());
    oracle::Uniform random(4);
    for (int n = 0; n < 500; ++n)
    {
      const double d = random(0.0, std::min(1.5 * contact, CutoffOf(c)));
      std::vector<double> weights(kernel.Size(), 0.0);
      AddWeights(kernel, d, 1.0, weights);
      const double overlap = std::max(contact - d, 0.0);
      EXPECT_NEAR(Dot(weights, potential), 3.0 * overlap * overlap, 1e-13 * contact * contact) << d;
      if (d > contact * (1.0 + 1e-12))
      {
        EXPECT_EQ(Dot(weights, potential), 0.0) << d;
      }
    }
  }
}
