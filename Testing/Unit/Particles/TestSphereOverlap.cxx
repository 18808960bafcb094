// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SphereOverlap.h"

#include "Oracles.h"

namespace
{
struct RadiusPair
{
  double A, B;
};
constexpr RadiusPair Radii[] = { { 1.0, 1.0 }, { 1.0, 0.6 }, { 0.6, 1.0 }, { 2.5, 0.1 },
  { 30.0, 31.0 } };

double Smaller(const RadiusPair& p)
{
  return ruc::SphereVolume(std::min(p.A, p.B));
}
}

TEST(SphereOverlap, SphereVolumeIsTheIntegralOfItsDiscs)
{
  // The rounding of a quadrature of 113 points
  EXPECT_NEAR(ruc::SphereVolume(1.7),
    oracle::Integrate(-1.7, 1.7, [](double z) { return oracle::Pi * (1.7 * 1.7 - z * z); }), 1e-12);
}

TEST(SphereOverlap, LensVolumeIsTheIntegralOfTheLesserDisc)
{
  for (const RadiusPair& p : Radii)
  {
    for (int n = 0; n <= 60; ++n)
    {
      const double t = 1.1 * (p.A + p.B) * n / 60.0;
      // Simpson's rule is exact here. Cancellation loses a few digits of the terms, which are of
      // the size (a + b)^3.
      EXPECT_NEAR(ruc::LensVolume(p.A, p.B, t), oracle::LensVolume(p.A, p.B, t),
        1e-13 * std::pow(p.A + p.B, 3))
        << t;
    }
    EXPECT_EQ(ruc::LensVolume(p.A, p.B, p.A + p.B), 0.0);
  }
}

TEST(SphereOverlap, OverlapMomentIsTheIntegralOfTheLensVolume)
{
  for (const RadiusPair& p : Radii)
  {
    const double s = p.A + p.B;
    for (int n = 0; n <= 40; ++n)
    {
      const double t = 1.05 * s * n / 40.0;
      const double expected = oracle::Integrate(std::min(t, s), s, { std::abs(p.A - p.B) },
        [&](double u) { return u * oracle::LensVolume(p.A, p.B, u); });
      // The rounding of terms of the size (a + b)^5
      EXPECT_NEAR(ruc::OverlapMoment(p.A, p.B, t), expected, 1e-13 * std::pow(s, 5)) << t;
      EXPECT_EQ(ruc::OverlapMoment(p.A, p.B, -t), ruc::OverlapMoment(p.A, p.B, t));
      EXPECT_NEAR(ruc::OverlapMomentSlope(p.A, p.B, t), -t * oracle::LensVolume(p.A, p.B, t),
        1e-13 * std::pow(s, 4));
      EXPECT_EQ(ruc::OverlapMomentSlope(p.A, p.B, -t), -ruc::OverlapMomentSlope(p.A, p.B, t));
    }
  }
}

TEST(SphereOverlap, AveragedOverlapIsTheMeanOverDirections)
{
  for (const RadiusPair& p : Radii)
  {
    const double s = p.A + p.B, q = std::abs(p.A - p.B);
    for (double d : { 0.0, 0.5 * q, q, q + 0.3 * (s - q), 0.95 * s, s, 1.3 * s, 4.0 * s })
    {
      for (double r : { 0.0, 0.2 * s, 0.5 * q, q, 0.7 * s, s, 1.2 * s, 3.5 * s, 4.9 * s })
      {
        // The quotient by 2 d r magnifies the rounding of h, 1e-16 (a + b)^5; the quadrature keeps
        // 1e-11.
        const double rounding = r * d > 0.0 ? 1e-15 * std::pow(s, 5) / (2.0 * r * d) : 0.0;
        EXPECT_NEAR(ruc::OrientationAveragedOverlap(p.A, p.B, r, d).Value,
          oracle::AveragedLens(p.A, p.B, r, d), 1e-11 * Smaller(p) + rounding)
          << "a " << p.A << " b " << p.B << " r " << r << " d " << d;
      }
    }
  }
}

TEST(SphereOverlap, AveragedOverlapTendsToItsLimits)
{
  for (const RadiusPair& p : Radii)
  {
    const double s = p.A + p.B, least = std::min(p.A, p.B);
    for (double share : { 1e-3, 1e-4, 2e-5, 5e-6, 1e-8 }) // the limits are taken below 1e-5
    {
      const double small = share * least;
      for (double other : { 0.4 * s, 0.8 * s, 0.99 * s })
      {
        // The mean over a small sphere of a function with bounded second derivatives, V'' <= 2 pi
        // (a + b), differs by the square of its radius; the quotients add a rounding of 1e-15 (a +
        // b)^5 / (small other).
        const double bound = 4.0 * oracle::Pi * s * small * small +
          1e-15 * std::pow(s, 5) / (std::max(share, 1e-5) * least * other);
        const double limit = oracle::LensVolume(p.A, p.B, other);
        EXPECT_NEAR(ruc::OrientationAveragedOverlap(p.A, p.B, small, other).Value, limit, bound)
          << share;
        EXPECT_NEAR(ruc::OrientationAveragedOverlap(p.A, p.B, other, small).Value, limit, bound)
          << share;
      }
    }
  }
}

TEST(SphereOverlap, SlopeIsTheDerivativeAfterTheDistance)
{
  for (const RadiusPair& p : Radii)
  {
    const double s = p.A + p.B, least = std::min(p.A, p.B);
    const double step = 1e-5 * least;
    for (int m = 1; m <= 23; ++m)
    {
      const double d = 0.0971 * m * s;
      for (double r : { 0.0, 0.13 * s, 0.31 * s, 0.77 * s, 1.41 * s })
      {
        const double expected = (ruc::OrientationAveragedOverlap(p.A, p.B, r, d + step).Value -
                                  ruc::OrientationAveragedOverlap(p.A, p.B, r, d - step).Value) /
          (2.0 * step);
        // The error of a central difference: the third derivative, or a jump of the second, times
        // the step, and the rounding of the values over it
        const double scale = oracle::Pi * s * s;
        const double rounding = 1e-15 * std::pow(s, 5) / (2.0 * std::max(r, 0.1 * s) * d) / step;
        EXPECT_NEAR(ruc::OrientationAveragedOverlap(p.A, p.B, r, d).Slope, expected,
          1e-5 * scale * least / s + rounding)
          << "a " << p.A << " b " << p.B << " r " << r << " d " << d;
        EXPECT_EQ(ruc::OrientationAveragedOverlap(p.A, p.B, r, -d).Slope,
          -ruc::OrientationAveragedOverlap(p.A, p.B, r, d).Slope);
        EXPECT_EQ(ruc::OrientationAveragedOverlap(p.A, p.B, r, -d).Value,
          ruc::OrientationAveragedOverlap(p.A, p.B, r, d).Value);
      }
    }
  }
}

TEST(SphereOverlap, AveragedOverlapOverAllSpaceIsTheProductOfVolumes)
{
  // Fubini: the integral of g over all d, 4 pi d^2 dd, is V_a V_b at every lag.
  for (const RadiusPair& p : Radii)
  {
    const double s = p.A + p.B, q = std::abs(p.A - p.B);
    for (double r : { 0.0, 0.4 * s, 1.7 * s })
    {
      const double integral =
        oracle::Integrate(0.0, r + s, { std::abs(r - s), std::abs(r - q), r, r + q, s, q },
          [&](double d) {
            return 4.0 * oracle::Pi * d * d * ruc::OrientationAveragedOverlap(p.A, p.B, r, d).Value;
          });
      const double product = ruc::SphereVolume(p.A) * ruc::SphereVolume(p.B);
      EXPECT_NEAR(integral, product, 1e-9 * product + 1e-12 * std::pow(s, 6)) << r;
    }
  }
}
