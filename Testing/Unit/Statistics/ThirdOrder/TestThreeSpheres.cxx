// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Oracles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The volumes of three equal spheres that the tests of S_rsq compare with
namespace
{
using oracle::Pi;
}

TEST(ThreeSpheres, UnionHasItsClosedForms)
{
  constexpr double a = 0.8, sphere = 4.0 / 3.0 * Pi * a * a * a;
  const auto lens = [&](double d) { return oracle::LensVolume(a, a, d); };
  for (double theta : { 0.0, 0.4, 1.0, Pi / 2.0, 2.5, Pi })
  {
    // All three or two coincide
    EXPECT_NEAR(oracle::UnionOfThree(a, 0.0, 0.0, theta), sphere, 1e-14);
    EXPECT_NEAR(oracle::CommonToThree(a, 0.0, 0.0, theta), sphere, 1e-14);
    for (double d : { 0.01, 0.5, 1.3, 1.6, 3.0 })
    {
      EXPECT_NEAR(oracle::UnionOfThree(a, d, 0.0, theta), 2.0 * sphere - lens(d), 1e-14);
      EXPECT_NEAR(oracle::UnionOfThree(a, 0.0, d, theta), 2.0 * sphere - lens(d), 1e-14);
      // The same where they nearly coincide: a volume changes by no more than the surface times the
      // displacement
      EXPECT_NEAR(oracle::UnionOfThree(a, d, 1e-9, theta), 2.0 * sphere - lens(d), 1e-8);
    }
  }
  for (double d : { 0.2, 0.9, 1.5, 2.0 })
  {
    EXPECT_NEAR(oracle::UnionOfThree(a, d, d, 0.0), 2.0 * sphere - lens(d), 1e-13);
    // In a line; the middle one holds what the outer ones share
    EXPECT_NEAR(
      oracle::UnionOfThree(a, d, 1.2 * d, Pi), 3.0 * sphere - lens(d) - lens(1.2 * d), 1e-13);
    EXPECT_NEAR(
      oracle::UnionOfThree(a, d, 2.2 * d, 0.0), 3.0 * sphere - lens(d) - lens(1.2 * d), 1e-13);
    EXPECT_NEAR(oracle::CommonToThree(a, d, 2.2 * d, 0.0), lens(2.2 * d), 1e-13);
  }
  // Far apart: all, or one from the two others
  EXPECT_NEAR(oracle::UnionOfThree(a, 2.0, 3.0, 1.5), 3.0 * sphere, 1e-14);
  EXPECT_NEAR(oracle::UnionOfThree(a, 1.0, 5.0, 1.5), 3.0 * sphere - lens(1.0), 1e-14);
  // Three lenses that have nothing in common
  const double third = 2.0 * 1.5 * std::sin(Pi / 6.0);
  EXPECT_NEAR(oracle::UnionOfThree(a, 1.5, 1.5, Pi / 3.0), 3.0 * sphere - 3.0 * lens(third), 1e-13);
}

TEST(ThreeSpheres, UnionAgreesWithQuadrature)
{
  // The height of the union over the points of the plane, 2 sqrt(a^2 - distance^2) to the nearest
  // corner, cut at every kink of the integrand along y. Along x kinks are at the ends of the discs,
  // where two circles cross, and at the circumcentre.
  constexpr double a = 1.0;
  oracle::Uniform random(5);
  for (int n = 0; n < 8; ++n)
  {
    const double r1 = random(0.05, 2.3), r2 = random(0.05, 2.3), theta = random(0.02, Pi - 0.02);
    const double corners[3][2] = { { 0.0, 0.0 }, { r1, 0.0 },
      { r2 * std::cos(theta), r2 * std::sin(theta) } };
    std::vector<double> kinks;
    for (int i = 0; i < 3; ++i)
    {
      kinks.push_back(corners[i][0] - a);
      kinks.push_back(corners[i][0] + a);
      const double *p = corners[i], *o = corners[(i + 1) % 3];
      const double x = o[0] - p[0], y = o[1] - p[1], d = std::hypot(x, y);
      const double half = std::sqrt(std::max(a * a - 0.25 * d * d, 0.0));
      kinks.push_back(p[0] + 0.5 * x - half * y / d);
      kinks.push_back(p[0] + 0.5 * x + half * y / d);
    }
    const double middleY = (0.5 * r2 - 0.5 * r1 * std::cos(theta)) / std::sin(theta);
    kinks.push_back(0.5 * r1);
    const auto [low, high] = std::minmax_element(kinks.begin(), kinks.end());
    const double from = *low, to = *high;
    const double volume = oracle::Integrate(from, to, kinks,
      [&](double x)
      {
        std::vector<double> ends = { middleY };
        for (int i = 0; i < 3; ++i)
        {
          const double *p = corners[i], *o = corners[(i + 1) % 3];
          const double half = std::sqrt(std::max(a * a - (x - p[0]) * (x - p[0]), 0.0));
          ends.push_back(p[1] - half);
          ends.push_back(p[1] + half);
          // The bisector of two corners
          const double dx = o[0] - p[0], dy = o[1] - p[1];
          if (std::abs(dy) > 1e-9)
          {
            ends.push_back(0.5 * (p[1] + o[1]) - dx / dy * (x - 0.5 * (p[0] + o[0])));
          }
        }
        return oracle::Integrate(-4.0, 4.0, ends,
          [&](double y)
          {
            double height2 = 0.0;
            for (const double* p : corners)
            {
              height2 =
                std::max(height2, a * a - (x - p[0]) * (x - p[0]) - (y - p[1]) * (y - p[1]));
            }
            return 2.0 * std::sqrt(height2);
          });
      });
    // Both agree to rounding, through sums of cancelling terms of the order of 10
    EXPECT_NEAR(oracle::UnionOfThree(a, r1, r2, theta), volume, 1e-12)
      << r1 << " " << r2 << " " << theta;
  }
}
