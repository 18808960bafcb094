// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"

#include "Oracles.h"
#include "ruc/Statistics/ThirdOrder/MultipoleProducts.h"

#include <algorithm>
#include <random>

namespace
{
struct Neighbour
{
  ruc::Vector3 At;
  double Radius;
  int Source;
};

// Spheres that touch the unit sphere at 0 at the nearest
std::vector<Neighbour> MakeNeighbours(int count, int sources)
{
  oracle::Uniform random(3);
  std::vector<Neighbour> neighbours;
  for (int n = 0; n < count; ++n)
  {
    ruc::Vector3 at = { random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0) };
    const double radius = random(0.3, 2.0), distance = (1.0 + radius) * random(1.0, 4.0);
    const double scale = distance / ruc::Length(at);
    neighbours.push_back({ { scale * at[0], scale * at[1], scale * at[2] }, radius, n % sources });
  }
  return neighbours;
}

std::vector<double> Sum(const ruc::LocalMultipoles& multipoles,
  const std::vector<Neighbour>& neighbours, double radius = 1.0, double unit = 1.0)
{
  ruc::LocalMultipoles::Neighbours around(multipoles.GetSettings());
  around.Start(radius * unit);
  for (const Neighbour& n : neighbours)
  {
    const ruc::Vector3 d = { unit * n.At[0], unit * n.At[1], unit * n.At[2] };
    around.Add(d[0], d[1], d[2], ruc::Dot(d, d), unit * n.Radius, n.Source);
  }
  std::vector<double> sums(multipoles.Size());
  multipoles.Sum(around, sums.data());
  return sums;
}

ruc::MultipoleSettings Settings(double cutOff, int degree = ruc::GreatestDegree, int sources = 1)
{
  ruc::MultipoleSettings settings;
  settings.CutOff = cutOff;
  settings.Degree = degree;
  settings.Sources = sources;
  return settings;
}
}

// sum over m of n_lm Re(conj I_lm(r) I_lm(s)) = (r s)^(-l-1) P_l
TEST(SolidHarmonics, AdditionTheorem)
{
  const double r[3] = { 0.3, -1.1, 0.7 }, s[3] = { -0.8, 0.2, 1.9 };
  constexpr int count = ruc::HarmonicCount(ruc::GreatestDegree);
  double real[2][count], imaginary[2][count], lengths[2];
  for (int n = 0; n < 2; ++n)
  {
    const double* v = n == 0 ? r : s;
    lengths[n] = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    ruc::FindHarmonics<double>(
      ruc::GreatestDegree, v[0], v[1], v[2], 1.0 / lengths[n], real[n], imaginary[n]);
  }
  const double cosine = (r[0] * s[0] + r[1] * s[1] + r[2] * s[2]) / (lengths[0] * lengths[1]);
  for (int l = 0; l <= ruc::GreatestDegree; ++l)
  {
    double sum = 0.0;
    for (int m = 0; m <= l; ++m)
    {
      const int n = ruc::HarmonicPlace(l, m);
      sum +=
        ruc::HarmonicWeight(l, m) * (real[0][n] * real[1][n] + imaginary[0][n] * imaginary[1][n]);
    }
    const double scale = std::pow(lengths[0] * lengths[1], -l - 1);
    EXPECT_NEAR(sum / scale, std::legendre(l, cosine), 1e-12) << l;
  }
}

// I_lm against (l - m)! r^(-l-1) P_l^m e^(i m phi)
TEST(SolidHarmonics, Definition)
{
  const double x = 0.4, y = -0.9, z = 0.6, r = std::sqrt(x * x + y * y + z * z);
  constexpr int count = ruc::HarmonicCount(ruc::GreatestDegree);
  double real[count], imaginary[count];
  ruc::FindHarmonics<double>(ruc::GreatestDegree, x, y, z, 1.0 / r, real, imaginary);
  for (int l = 0; l <= ruc::GreatestDegree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      // std::assoc_legendre has no (-1)^m either
      const double size =
        std::tgamma(l - m + 1.0) * std::assoc_legendre(l, m, z / r) * std::pow(r, -l - 1);
      const double phi = std::atan2(y, x), scale = 1.0 / std::sqrt(ruc::HarmonicWeight(l, m));
      EXPECT_NEAR(real[ruc::HarmonicPlace(l, m)] / scale, size * std::cos(m * phi) / scale, 1e-11);
      EXPECT_NEAR(
        imaginary[ruc::HarmonicPlace(l, m)] / scale, size * std::sin(m * phi) / scale, 1e-11);
    }
  }
}

// Products of multipoles are double sums over neighbours with Legendre polynomials
TEST(LocalMultipoles, ProductsAreSumsOverPairsOfNeighbours)
{
  const ruc::LocalMultipoles multipoles(Settings(1000.0, ruc::GreatestDegree, 2));
  const ruc::MultipoleProducts products(multipoles);
  const std::vector<Neighbour> neighbours = MakeNeighbours(21, 2);
  const std::vector<double> sums = Sum(multipoles, neighbours);
  for (int s = 0; s < 2; ++s)
  {
    for (int t = s; t < 2; ++t)
    {
      std::vector<double> second(ruc::GreatestDegree - 1);
      products.Second(sums.data(), s, t, second.data());
      double fourth = 0.0;
      for (int l = 2; l <= ruc::GreatestDegree; ++l)
      {
        double z = 0.0;
        for (const Neighbour& j : neighbours)
        {
          for (const Neighbour& k : neighbours)
          {
            if (j.Source != s || k.Source != t)
            {
              continue;
            }
            const double rj = ruc::Length(j.At), rk = ruc::Length(k.At);
            const double weight = std::pow(j.Radius * k.Radius, 3) * std::pow(rj * rk, -l - 1) *
              std::legendre(l, ruc::Dot(j.At, k.At) / (rj * rk));
            z += l * (l - 1.0) * weight;
            const auto a = [&](const Neighbour& n, double r)
            { return n.Radius * n.Radius / 5.0 - r * r / (2.0 * l - 1.0); };
            const double b = 1.0 / (2.0 * l + 3.0), four = 3.0 * l * (l - 1) * (l - 2) * (l - 3);
            const double aj = a(j, rj), ak = a(k, rk);
            fourth += weight * four * (2 * l - 1) * (2 * l - 3) *
              (aj * ak + (2.0 * l + 3) / (2 * l - 3) * b * (aj + ak) +
                (2.0 * l + 3) * (2 * l + 3) / ((2 * l - 5) * (2 * l - 1)) * b * b);
            fourth += weight * 48.0 / 7.0 * (l + 1) * l * (l - 1) * (l - 2) * (2.0 * l + 3) /
              (2 * l - 5) * b * b;
          }
        }
        EXPECT_NEAR(second[l - 2], z, 1e-9 * (1.0 + std::abs(z))) << l;
      }
      EXPECT_NEAR(products.Fourth(sums.data(), s, t), fourth, 1e-9 * (1.0 + std::abs(fourth)));
    }
  }
}

TEST(LocalMultipoles, SameBitsInAnyOrder)
{
  for (double alpha : { 0.0, 0.4 })
  {
    ruc::MultipoleSettings settings = Settings(8.0);
    settings.Alpha = alpha;
    const ruc::LocalMultipoles multipoles(settings);
    std::vector<Neighbour> neighbours = MakeNeighbours(100, 1);
    neighbours.erase(std::remove_if(neighbours.begin(), neighbours.end(),
                       [](const Neighbour& n) { return ruc::Length(n.At) >= 8.0; }),
      neighbours.end());
    const std::vector<double> sums = Sum(multipoles, neighbours);
    std::shuffle(neighbours.begin(), neighbours.end(), std::mt19937(1));
    EXPECT_EQ(Sum(multipoles, neighbours), sums);
  }
}

// A power of two as unit of length changes nothing at all
TEST(LocalMultipoles, HaveNoUnit)
{
  const std::vector<Neighbour> neighbours = MakeNeighbours(20, 1);
  const std::vector<double> sums = Sum(ruc::LocalMultipoles(Settings(20.0)), neighbours, 1.0);
  const double unit = std::ldexp(1.0, 40);
  EXPECT_EQ(Sum(ruc::LocalMultipoles(Settings(20.0 * unit)), neighbours, 1.0, unit), sums);
}

// Two equal spheres alone: zeta and eta of first order in the fraction of spheres that lie at
// random but do not overlap are integrals over their distance, 0.21068 and 0.48274 of the fraction
// (S. Torquato and F. Lado, Phys. Rev. B 33, 6428, 1986, and S. Torquato, F. Lado and P. A. Smith,
// J. Chem. Phys. 86, 6388, 1987)
TEST(LocalMultipoles, OnePairIntegratesToTheDiluteLimit)
{
  const ruc::LocalMultipoles multipoles(Settings(1e6));
  const ruc::MultipoleProducts products(multipoles);
  double zeta = 0.0, x = 0.0;
  constexpr int steps = 2000;
  for (int n = 0; n < steps; ++n)
  {
    // d = 2 / u^2 with u from 0 to 1 puts the points where the integrand is large; midpoints
    const double u = (n + 0.5) / steps, d = 2.0 / (u * u);
    const double width = 4.0 / (u * u * u) / steps, shell = 3.0 * d * d * width; // per fraction
    const std::vector<double> sums =
      Sum(multipoles, { { { 0.48 * d, 0.6 * d, -0.64 * d }, 1.0, 0 } });
    std::vector<double> second(ruc::GreatestDegree - 1);
    products.Second(sums.data(), 0, 0, second.data());
    const ruc::MultipoleRest rest =
      ruc::FindMultipoleRest(1.0 / (d * d), 1.0, ruc::GreatestDegree, true);
    for (double value : second)
    {
      zeta += 0.5 * shell * value;
    }
    zeta += 0.5 * shell * rest.Second;
    x += shell * (products.Fourth(sums.data(), 0, 0) + rest.Fourth);
  }
  EXPECT_NEAR(zeta, 0.21068, 1e-5);
  EXPECT_NEAR(5.0 / 21.0 * zeta + 5.0 / 54.0 * x, 0.48274, 1e-5);
}

// The rest of a neighbour against its terms one by one
TEST(MultipoleRest, IsWhatIsLeftOfASeries)
{
  for (double ratio : { 0.2, 1.0, 3.0 })
  {
    for (double gap : { 1.0, 1.05, 1.5 })
    {
      const double distance = gap * (1.0 + ratio), t = 1.0 / (distance * distance);
      double second = 0.0;
      for (int l = 11; l < 2000; ++l)
      {
        second += l * (l - 1.0) * std::pow(ratio, 6) * std::pow(t, l + 1);
      }
      const ruc::MultipoleRest rest = ruc::FindMultipoleRest(t, ratio, 10, true);
      EXPECT_NEAR(rest.Second, second, 1e-11);
      // Fewer degrees leave more of Fourth, by what these degrees have
      const ruc::LocalMultipoles multipoles(Settings(1000.0, 14));
      const ruc::LocalMultipoles fewer(Settings(1000.0, 10));
      const std::vector<Neighbour> one = { { { 0.0, distance, 0.0 }, ratio, 0 } };
      const double more =
        ruc::MultipoleProducts(multipoles).Fourth(Sum(multipoles, one).data(), 0, 0);
      const double less = ruc::MultipoleProducts(fewer).Fourth(Sum(fewer, one).data(), 0, 0);
      EXPECT_NEAR(
        less + rest.Fourth, more + ruc::FindMultipoleRest(t, ratio, 14, true).Fourth, 1e-8);
    }
  }
}
