// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The volume that a ball has in a box, against quadrature and identities
#include "ruc/Images/BallInBox.h"

#include "Oracles.h"

namespace
{
// The height of the ball over (x, y)
double Height(double x, double y, double radius)
{
  return std::sqrt(std::max(radius * radius - x * x - y * y, 0.0));
}

double WedgeByQuadrature(double a, double b, double radius)
{
  const double reach = std::sqrt(std::max(radius * radius - b * b, 0.0));
  return oracle::Integrate(std::min(a, reach), reach,
    [&](double x)
    {
      return oracle::Integrate(
        b, std::max(b, Height(x, 0.0, radius)), [&](double y) { return Height(x, y, radius); });
    });
}

double OctantByQuadrature(double a, double b, double c, double radius)
{
  const std::vector<double> kinks = { Height(b, 0.0, radius), Height(c, 0.0, radius),
    Height(b, c, radius) };
  return oracle::Integrate(0.0, std::min(a, radius), kinks,
    [&](double x)
    {
      const double end = std::min(b, Height(x, 0.0, radius));
      return oracle::Integrate(0.0, end, { Height(x, c, radius) },
        [&](double y) { return std::min(c, Height(x, y, radius)); });
    });
}
}

TEST(BallInBox, WedgesAreThoseOfQuadrature)
{
  const double radius = 1.7;
  EXPECT_NEAR(ruc::BallWedge(0.0, 0.0, radius), oracle::Pi * std::pow(radius, 3) / 6.0, 1e-14);
  for (double a : { 0.0, 0.01, 0.4, 1.2, 1.65, 1.7, 2.0 })
  {
    // A cap of height R - a has pi (R - a)^2 (2 R + a) / 3
    const double cap =
      a < radius ? oracle::Pi * (radius - a) * (radius - a) * (2.0 * radius + a) / 3.0 : 0.0;
    EXPECT_NEAR(ruc::BallWedge(a, 0.0, radius), 0.25 * cap, 1e-14);
    for (double b : { 0.0, 0.3, 1.1, 1.6 })
    {
      EXPECT_NEAR(ruc::BallWedge(a, b, radius), WedgeByQuadrature(a, b, radius), 1e-12)
        << a << " " << b;
      EXPECT_NEAR(ruc::BallWedge(a, b, radius), ruc::BallWedge(b, a, radius), 1e-14);
    }
  }
}

TEST(BallInBox, OctantsAreThoseOfQuadrature)
{
  oracle::Uniform random(5);
  for (int n = 0; n < 300; ++n)
  {
    // From corners inside to boxes that hold the octant
    const double radius = 1.0, most = n % 2 == 0 ? 1.1 : 0.8;
    const double a = random(0.0, most), b = random(0.0, most), c = random(0.0, most);
    EXPECT_NEAR(ruc::BallInOctant(a, b, c, radius), OctantByQuadrature(a, b, c, radius), 2e-12)
      << a << " " << b << " " << c;
  }
}

TEST(BallInBox, CornersInFacesOfTheOctantHoldNothing)
{
  for (double b : { 0.0, 0.3, 0.9, 1.5 })
  {
    for (double c : { 0.2, 0.8, 1.0, 3.0 })
    {
      EXPECT_NEAR(ruc::BallInOctant(0.0, b, c, 1.0), 0.0, 1e-15);
      EXPECT_NEAR(ruc::BallInOctant(b, 0.0, c, 1.0), 0.0, 1e-15);
      EXPECT_NEAR(ruc::BallInOctant(b, c, 0.0, 1.0), 0.0, 1e-15);
    }
  }
}

TEST(BallInBox, IsOddInEachCoordinate)
{
  for (int signs = 0; signs < 8; ++signs)
  {
    const auto sign = [&](int q) { return signs >> q & 1 ? -1.0 : 1.0; };
    for (double c : { 0.2, 0.7, 4.0 })
    {
      EXPECT_EQ(ruc::BallInOctant(sign(0) * 0.5, sign(1) * 0.6, sign(2) * c, 1.0),
        sign(0) * sign(1) * sign(2) * ruc::BallInOctant(0.5, 0.6, c, 1.0));
    }
  }
}

TEST(BallInBox, AFarCornerIsTheOctantAndABoxAroundHoldsTheBall)
{
  const double ball = 4.0 / 3.0 * oracle::Pi * 8.0;
  EXPECT_NEAR(ruc::BallInOctant(2.0, 5.0, 1e50, 2.0), ball / 8.0, 1e-14);
  EXPECT_NEAR(ruc::BallInBox({ -2.0, -3.0, -9.0 }, { 2.0, 4.0, 2.5 }, 2.0), ball, 1e-14);
  EXPECT_NEAR(ruc::BallInBox({ -2.0, -3.0, 0.0 }, { 2.0, 4.0, 2.5 }, 2.0), 0.5 * ball, 1e-14);
  EXPECT_NEAR(ruc::BallInBox({ 1.5, 1.5, 0.0 }, { 2.0, 4.0, 2.5 }, 2.0), 0.0, 1e-14);
  EXPECT_NEAR(ruc::BallInBox({ -0.1, 0.0, 0.1 }, { 0.1, 0.1, 0.2 }, 2.0), 0.002, 1e-15);
}

// Whatever planes cut a box into parts, these have what the box has
TEST(BallInBox, PartsOfABoxAddUp)
{
  oracle::Uniform random(6);
  for (int n = 0; n < 100; ++n)
  {
    ruc::Vector3 cut[3];
    for (int q = 0; q < 3; ++q)
    {
      double along[3] = { random(-1.2, 1.2), random(-1.2, 1.2), random(-1.2, 1.2) };
      std::sort(along, along + 3);
      for (int k = 0; k < 3; ++k)
      {
        cut[k][q] = along[k];
      }
    }
    double parts = 0.0;
    for (int part = 0; part < 8; ++part)
    {
      ruc::Vector3 lower, upper;
      for (int q = 0; q < 3; ++q)
      {
        lower[q] = cut[part >> q & 1][q];
        upper[q] = cut[(part >> q & 1) + 1][q];
      }
      const double share = ruc::BallInBox(lower, upper, 1.0);
      EXPECT_GE(share, -1e-14);
      parts += share;
    }
    EXPECT_NEAR(parts, ruc::BallInBox(cut[0], cut[2], 1.0), 1e-13);
  }
}
