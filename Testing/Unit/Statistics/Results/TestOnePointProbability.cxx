// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/OnePointProbability.h"

#include "Oracles.h"

TEST(OnePointProbability, IsTheShareOfRandomPoints)
{
  const ruc::Window box = oracle::PeriodicCube(6.0);
  const ruc::SpherePack pack = oracle::RelaxedPack({ 12, 30 }, { 0.9, 0.6 }, box, 2);
  const std::vector<double> fractions = ruc::OnePointProbability(ruc::SharePack(pack, box));
  ASSERT_EQ(fractions.size(), 3u);
  oracle::Uniform random(9);
  constexpr int samples = 200000;
  int hits[3] = {};
  for (int n = 0; n < samples; ++n)
  {
    const double p[3] = { random(0, 6), random(0, 6), random(0, 6) };
    int phase = 2;
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      double distance2 = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        const double d = std::remainder(p[q] - pack.Centre(i)[q], 6.0);
        distance2 += d * d;
      }
      if (distance2 < pack.Radius[i] * pack.Radius[i])
      {
        phase = pack.Mode[i] - 1;
      }
    }
    ++hits[phase];
  }
  for (int m = 0; m < 3; ++m)
  {
    // The standard error is binomial; 4.5 of them
    EXPECT_NEAR(double(hits[m]) / samples, fractions[m],
      4.5 * std::sqrt(fractions[m] * (1 - fractions[m]) / samples))
      << m;
  }
}

TEST(OnePointProbability, CylinderWindow)
{
  ruc::SpherePack pack;
  pack.X = pack.Y = pack.Z = { 0.5, 0.1 };
  pack.Radius = { 0.2, 0.1 };
  pack.Mode = { 2, 1 };
  const std::vector<double> fractions = ruc::OnePointProbability(
    ruc::SharePack(pack, ruc::Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 2.0, 3.0)));
  const double volume = oracle::Pi * 12.0;
  EXPECT_DOUBLE_EQ(fractions[0], 4.0 / 3.0 * oracle::Pi * 0.001 / volume);
  EXPECT_DOUBLE_EQ(fractions[1], 4.0 / 3.0 * oracle::Pi * 0.008 / volume);
  EXPECT_DOUBLE_EQ(fractions[2], 1.0 - 4.0 / 3.0 * oracle::Pi * 0.009 / volume);
}
