// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/MaximumFraction.h"

#include "Oracles.h"

namespace
{
// Spheres of the diameters 1 and `ratio`, of whose volume the large ones have `share`
double MaximumOfTwo(double ratio, double share)
{
  const int spheres = 200000;
  const double large = share / (ratio * ratio * ratio);
  std::vector<double> radii(spheres, 0.5);
  std::fill_n(radii.begin(), std::lround(spheres * large / (large + 1.0 - share)), 0.5 * ratio);
  return ruc::MaximumRandomFraction(radii);
}
}

// 0.6435 is what Farr and Groot give for equal spheres
TEST(MaximumFraction, EqualSpheres)
{
  EXPECT_NEAR(ruc::MaximumRandomFraction({ 1.0 }), 0.6435, 0.002);
  EXPECT_EQ(ruc::MaximumRandomFraction(std::vector<double>(1000, 2.0)),
    ruc::MaximumRandomFraction({ 2.0 }));
}

// A second program, with quantiles for each class by itself, gave these
TEST(MaximumFraction, TwoSizes)
{
  EXPECT_NEAR(MaximumOfTwo(2.0, 0.70), 0.682, 0.003);
  EXPECT_NEAR(MaximumOfTwo(3.0, 0.75), 0.729, 0.003);
  EXPECT_NEAR(MaximumOfTwo(5.0, 0.80), 0.787, 0.003);
  EXPECT_NEAR(MaximumOfTwo(10.0, 0.75), 0.827, 0.003);
}

// With an infinite ratio of sizes the small spheres fill the room between the large ones as if it
// were a box: phi + (1 - phi) phi
TEST(MaximumFraction, LiesBelowThatOfInfiniteRatio)
{
  const double equal = ruc::MaximumRandomFraction({ 1.0 });
  const double most = equal + (1.0 - equal) * equal;
  double before = equal;
  for (double ratio : { 2.0, 4.0, 8.0, 16.0 })
  {
    const double now = MaximumOfTwo(ratio, 0.75);
    EXPECT_GT(now, before);
    EXPECT_LT(now, most);
    before = now;
  }
}
