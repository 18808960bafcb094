// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/NeighbourhoodMultipoles.h"
#include "HardPack.h"
#include "ThirdOrderPacks.h"
#include "ThreadRanks.h"

#include <omp.h>

#include <random>

namespace
{
using ruc::NeighbourhoodMultipoles;
using ruc::ShellMultipoles;

double Legendre(int l, double x)
{
  double before = 1.0, here = x;
  for (int k = 2; k <= l; ++k)
  {
    before = std::exchange(here, ((2 * k - 1) * x * here - (k - 1) * before) / k);
  }
  return l == 0 ? 1.0 : here;
}

// 2 pi times the integral of P_l from x to 1, by Simpson's rule
double Cap(int l, double x)
{
  constexpr int steps = 2000;
  double sum = 0.0;
  for (int n = 0; n <= steps; ++n)
  {
    const double factor = n == 0 || n == steps ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
    sum += factor * Legendre(l, x + (1.0 - x) * n / steps);
  }
  return 2.0 * ruc::Pi * sum * (1.0 - x) / steps / 3.0;
}

// Neighbours of a unit sphere, some of which reach no shell
std::vector<ShellMultipoles::Neighbour> SomeNeighbours(int count, int classes)
{
  oracle::Uniform random(5);
  std::vector<ShellMultipoles::Neighbour> around;
  for (int n = 0; n < count; ++n)
  {
    const ruc::Vector3 at = { random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0) };
    const double length = ruc::Length(at), radius = random(0.4, 1.3);
    around.push_back({ { at[0] / length, at[1] / length, at[2] / length },
      1.0 + radius + random(0.0, 3.0), radius, n % classes });
  }
  return around;
}

std::vector<double> ProductsOf(
  const ShellMultipoles& shells, const std::vector<ShellMultipoles::Neighbour>& around)
{
  std::vector<double> sums(shells.Size()), products(shells.GetSettings().NumberOfProducts());
  shells.Sum(1.0, around, sums.data());
  shells.FindProducts(sums.data(), products.data());
  return products;
}

ruc::NeighbourhoodSettings Settings(int classes)
{
  ruc::NeighbourhoodSettings settings;
  settings.Distances = { 0.05, 0.3, 0.7, 1.2 };
  settings.Classes = classes;
  settings.Degree = 6;
  settings.Blocks = 8;
  return settings;
}

NeighbourhoodMultipoles Measure(const ruc::SpherePack& pack, const ruc::Window& window,
  const ruc::NeighbourhoodSettings& settings)
{
  ruc::Communicator alone;
  return ruc::MeasureNeighbourhoods(ruc::SharePack(pack, window), settings, alone);
}

const HardPack& ThePack()
{
  static const HardPack pack(80, 200, 0.45);
  return pack;
}
}

TEST(ShellMultipoles, OneNeighbourCutsCaps)
{
  const ShellMultipoles shells({ { 0.2, 0.9, 1.7, 2.4, 6.0 }, ruc::HighestOfShells, 1 });
  const double d = 3.1, b = 1.2;
  const std::vector<double> products = ProductsOf(shells, { { { 0.48, -0.6, 0.64 }, d, b, 0 } });
  for (int l = 0; l <= ruc::HighestOfShells; ++l)
  {
    std::vector<double> caps;
    for (double distance : shells.GetSettings().Distances)
    {
      const double rho = 1.0 + distance;
      caps.push_back(Cap(l, std::clamp((d * d + rho * rho - b * b) / (2.0 * d * rho), -1.0, 1.0)));
    }
    for (std::size_t n1 = 0; n1 < caps.size(); ++n1)
    {
      for (std::size_t n2 = 0; n2 < caps.size(); ++n2)
      {
        EXPECT_NEAR(products[shells.GetSettings().PlaceOf(0, 0, l, n1, n2)],
          (2 * l + 1) * caps[n1] * caps[n2] / (16.0 * ruc::Pi * ruc::Pi), 1e-9);
      }
    }
  }
}

// The addition theorem: of two neighbours the angle between them
TEST(ShellMultipoles, ProductsAreSumsOverPairsByTheirAngle)
{
  const ShellMultipoles shells({ { 0.3, 1.1, 2.0 }, 7, 2 });
  const auto around = SomeNeighbours(9, 2);
  const std::vector<double> products = ProductsOf(shells, around);
  const auto cap = [&](int l, const ShellMultipoles::Neighbour& j, int n)
  {
    const double rho = 1.0 + shells.GetSettings().Distances[n];
    const double x =
      (j.Distance * j.Distance + rho * rho - j.Radius * j.Radius) / (2.0 * j.Distance * rho);
    return Cap(l, std::clamp(x, -1.0, 1.0));
  };
  for (int l : { 0, 1, 4, 7 })
  {
    double sum = 0.0;
    for (const auto& j : around)
    {
      for (const auto& k : around)
      {
        if (j.Class == 0 && k.Class == 1)
        {
          sum += (2 * l + 1) * cap(l, j, 1) * cap(l, k, 2) *
            Legendre(l, ruc::Dot(j.Direction, k.Direction)) / (16.0 * ruc::Pi * ruc::Pi);
        }
      }
    }
    EXPECT_NEAR(products[shells.GetSettings().PlaceOf(0, 1, l, 1, 2)], sum, 1e-8);
  }
}

// Centres without any order around one: the pairs of two of them add the product of the means, for
// l = 0, and each with itself density (2 l + 1) / (4 pi) int C_l(n1) C_l(n2) d^2 dd
TEST(ShellMultipoles, RandomOverlappingSpheresHaveThePairSum)
{
  const ShellMultipoles shells({ { 0.2, 0.9, 1.7 }, 6, 1 });
  const ruc::ShellSettings& settings = shells.GetSettings();
  constexpr double radius = 0.8, density = 0.3, half = 3.6; // none beyond the box reaches a shell
  constexpr int packs = 4000;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-half, half);
  std::poisson_distribution<int> number(density * std::pow(2.0 * half, 3));
  std::vector<double> sums(settings.NumberOfProducts(), 0.0), squares = sums;
  for (int n = 0; n < packs; ++n)
  {
    std::vector<ShellMultipoles::Neighbour> around(number(random));
    for (ShellMultipoles::Neighbour& sphere : around)
    {
      const ruc::Vector3 centre = { place(random), place(random), place(random) };
      const double d = ruc::Length(centre);
      sphere = { { centre[0] / d, centre[1] / d, centre[2] / d }, d, radius, 0 };
    }
    const std::vector<double> products = ProductsOf(shells, around);
    for (std::size_t k = 0; k < products.size(); ++k)
    {
      sums[k] += products[k] / packs;
      squares[k] += products[k] * products[k] / packs;
    }
  }
  const double ball = density * 4.0 / 3.0 * ruc::Pi * std::pow(radius, 3);
  const auto cap = [&](int l, double d, int n)
  {
    const double rho = 1.0 + settings.Distances[n];
    return Cap(l, std::clamp((d * d + rho * rho - radius * radius) / (2.0 * d * rho), -1.0, 1.0));
  };
  double worst = 0.0;
  for (int l : { 0, 1, 3, 6 })
  {
    for (const auto& [n1, n2] : { std::pair(0, 0), std::pair(0, 1), std::pair(1, 2) })
    {
      constexpr int steps = 400;
      constexpr double step = half / steps;
      double integral = 0.0;
      for (int k = 0; k < steps; ++k)
      {
        const double d = (k + 0.5) * step;
        integral += step * d * d * cap(l, d, n1) * cap(l, d, n2);
      }
      // A point lies in so many spheres on average, on any shell
      const double expected =
        (l == 0 ? ball * ball : 0.0) + density * (2 * l + 1) / (4.0 * ruc::Pi) * integral;
      const std::size_t at = settings.PlaceOf(0, 0, l, n1, n2);
      const double error = std::sqrt((squares[at] - sums[at] * sums[at]) / packs);
      EXPECT_NEAR(sums[at], expected, 4.0 * error) << l << " " << n1 << " " << n2;
      worst = std::max(worst, error / std::abs(sums[at]));
    }
  }
  EXPECT_LT(worst, 0.1) << "the errors are small beside what they are errors of";
}

TEST(ShellMultipoles, ForcesAreSlopes)
{
  const ShellMultipoles shells({ { 0.05, 0.3, 0.8, 1.2, 1.5, 1.9, 2.2, 2.6, 3.0 }, 6, 2 });
  const auto around = SomeNeighbours(12, 2);
  std::vector<double> mu(shells.GetSettings().NumberOfProducts());
  for (std::size_t n = 0; n < mu.size(); ++n)
  {
    mu[n] = std::sin(1.0 + n);
  }
  const auto value = [&](const std::vector<ShellMultipoles::Neighbour>& of)
  {
    const std::vector<double> products = ProductsOf(shells, of);
    return std::inner_product(products.begin(), products.end(), mu.begin(), 0.0);
  };
  std::vector<double> sums(shells.Size()), lambda(shells.Size()), forces(3 * around.size());
  shells.Sum(1.0, around, sums.data());
  shells.FindGradient(sums.data(), shells.MakeFactors(mu.data()).data(), lambda.data());
  shells.FindForces(1.0, around, lambda.data(), forces.data());
  constexpr double step = 1e-4;
  for (std::size_t j = 0; j < around.size(); ++j)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto moved = [&](double by)
      {
        auto of = around;
        ruc::Vector3 at;
        for (int q = 0; q < 3; ++q)
        {
          at[q] = of[j].Distance * of[j].Direction[q] + (q == axis ? by : 0.0);
        }
        of[j].Distance = ruc::Length(at);
        for (int q = 0; q < 3; ++q)
        {
          of[j].Direction[q] = at[q] / of[j].Distance;
        }
        return of;
      };
      EXPECT_NEAR(
        forces[3 * j + axis], (value(moved(step)) - value(moved(-step))) / (2.0 * step), 1e-5);
    }
  }
}

// Points on shells around centres, where they are in other spheres
TEST(NeighbourhoodMultipoles, AreMeansOverPairsOfPoints)
{
  const ruc::SpherePack& pack = ThePack().Pack;
  const double edge = ThePack().Box.Size[0];
  const ruc::NeighbourhoodSettings settings = Settings(2);
  const NeighbourhoodMultipoles found = Measure(pack, ThePack().Box, settings);
  ASSERT_EQ(found.Shells.Classes, 2);
  ASSERT_EQ(found.ClassOfMode, (std::vector<int>{ 1, 0 })) << "mode 1 has the larger spheres";
  oracle::Uniform random(17);
  const auto direction = [&]()
  {
    while (true)
    {
      const ruc::Vector3 u = { random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0) };
      const double length = ruc::Length(u);
      if (length > 0.1 && length < 1.0)
      {
        return ruc::Vector3{ u[0] / length, u[1] / length, u[2] / length };
      }
    }
  };
  const auto classAt = [&](std::size_t i, const ruc::Vector3& u, double rho)
  {
    for (std::size_t j = 0; j < pack.Size(); ++j)
    {
      double d2 = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        const ruc::Vector3 from = pack.Centre(i), to = pack.Centre(j);
        double d = from[q] + rho * u[q] - to[q];
        d -= edge * std::nearbyint(d / edge);
        d2 += d * d;
      }
      if (j != i && d2 < pack.Radius[j] * pack.Radius[j])
      {
        return found.ClassOfMode[pack.Mode[j] - 1];
      }
    }
    return -1;
  };
  constexpr int n1 = 1, n2 = 2, throws = 100000, degrees = 5;
  double sum[4][degrees] = {}, squares[4][degrees] = {};
  for (int n = 0; n < throws; ++n)
  {
    const std::size_t i = n % 80; // of mode 1
    const ruc::Vector3 u = direction(), v = direction();
    const int s = classAt(i, u, pack.Radius[i] + settings.Distances[n1]);
    const int q = classAt(i, v, pack.Radius[i] + settings.Distances[n2]);
    for (int l = 0; s >= 0 && q >= 0 && l < degrees; ++l)
    {
      const double value = (2 * l + 1) * Legendre(l, ruc::Dot(u, v));
      sum[2 * s + q][l] += value;
      squares[2 * s + q][l] += value * value;
    }
  }
  for (int l = 0; l < degrees; ++l)
  {
    for (int pair = 0; pair < 4; ++pair)
    {
      const int s = pair / 2, q = pair % 2;
      const double mean = sum[pair][l] / throws;
      const double error = std::sqrt((squares[pair][l] / throws - mean * mean) / throws);
      const std::size_t place =
        s <= q ? found.PlaceOf(1, s, q, l, n1, n2) : found.PlaceOf(1, q, s, l, n2, n1);
      EXPECT_NEAR(found.Value[place], mean, 4.0 * error) << s << q << l;
    }
  }
}

TEST(NeighbourhoodMultipoles, OfACellAreThoseOfItsTiling)
{
  const ruc::SpherePack& cell = ThePack().Pack;
  ruc::SpherePack tiled;
  const ruc::Vector3& size = ThePack().Box.Size;
  for (int n = 0; n < 8; ++n)
  {
    for (std::size_t i = 0; i < cell.Size(); ++i)
    {
      tiled.Append(cell, i);
      tiled.X.back() += n % 2 * size[0];
      tiled.Y.back() += n / 2 % 2 * size[1];
      tiled.Z.back() += n / 4 * size[2];
    }
  }
  const ruc::Window box = ruc::Window::MakeBox(
    ThePack().Box.Origin, { 2 * size[0], 2 * size[1], 2 * size[2] }, { true, true, true });
  const NeighbourhoodMultipoles one = Measure(cell, ThePack().Box, Settings(2));
  const NeighbourhoodMultipoles eight = Measure(tiled, box, Settings(2));
  ASSERT_EQ(one.Value.size(), eight.Value.size());
  EXPECT_EQ(eight.Centres[0], 8 * one.Centres[0]);
  for (std::size_t n = 0; n < one.Value.size(); ++n)
  {
    EXPECT_NEAR(one.Value[n], eight.Value[n], 1e-9);
  }
}

TEST(NeighbourhoodMultipoles, OfAWindowAreThoseOfItsPack)
{
  const HardPack whole(600, 1500, 0.45), cut(600, 1500, 0.45, false);
  ruc::NeighbourhoodSettings settings = Settings(1);
  settings.Blocks = 32;
  const NeighbourhoodMultipoles all = Measure(whole.Pack, whole.Box, settings);
  const NeighbourhoodMultipoles part = Measure(cut.Pack, cut.Box, settings);
  EXPECT_LT(part.Centres[0], 0.7 * all.Centres[0]);
  double squares = 0.0;
  for (std::size_t n = 0; n < all.Value.size(); ++n)
  {
    EXPECT_GT(part.Error[n], 0.0);
    squares += std::pow((part.Value[n] - all.Value[n]) / part.Error[n], 2) / all.Value.size();
  }
  EXPECT_LT(squares, 2.0);
}

TEST(NeighbourhoodMultipoles, SameBitsOnAnyRanksAndThreads)
{
  const NeighbourhoodMultipoles expected = Measure(ThePack().Pack, ThePack().Box, Settings(2));
  for (int ranks = 1; ranks <= 4; ++ranks)
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        omp_set_num_threads(5 - ranks);
        ruc::SpherePack piece;
        for (std::size_t i = communicator.Rank(); i < ThePack().Pack.Size(); i += ranks)
        {
          piece.Append(ThePack().Pack, i);
        }
        const ruc::PackShare share =
          ruc::SharePack(std::move(piece), ThePack().Box, true, communicator);
        const NeighbourhoodMultipoles found =
          ruc::MeasureNeighbourhoods(share, Settings(2), communicator);
        EXPECT_TRUE(found.Value == expected.Value);
        EXPECT_TRUE(found.Error == expected.Error);
      });
  }
}

TEST(NeighbourhoodMultipoles, WhatCannotBeIsRefused)
{
  const auto says = [](const ruc::NeighbourhoodSettings& settings, const char* text)
  { EXPECT_SAYS(Measure(ThePack().Pack, ThePack().Box, settings), text); };
  ruc::NeighbourhoodSettings settings = Settings(5);
  says(settings, "MultipoleClasses requires");
  settings = Settings(1);
  settings.Degree = 14;
  says(settings, "MultipoleDegree requires");
  settings = Settings(1);
  settings.Distances = { 0.5, 0.4 };
  says(settings, "MultipoleDistances requires distances > 0 that ascend, got 0.4 after 0.5");
  settings.Distances = { 0.0 };
  says(settings, "MultipoleDistances requires distances > 0 that ascend, got 0 after 0");
  ruc::SpherePack pack = ThePack().Pack;
  pack.Radius[3] *= 1.2;
  EXPECT_SAYS(
    Measure(pack, ThePack().Box, Settings(1)), "Multipoles requires spheres that overlap");
  const ruc::Window window =
    ruc::Window::MakeBox(ThePack().Box.Origin, ThePack().Box.Size, { true, false, true });
  settings = Settings(1);
  settings.Distances = { 4.0 };
  EXPECT_SAYS(Measure(ThePack().Pack, window, settings),
    "Multipoles requires 1 centres of every class at least 6 from every face of the window");
}

// All centres of a class in one place tell no errors; a filter shows the values all the same
TEST(NeighbourhoodMultipoles, AClassWithoutScatterIsRefusedWhereItIsNeeded)
{
  ruc::SpherePack pack = ThePack().Pack;
  std::fill(pack.Mode.begin(), pack.Mode.end(), 1);
  const std::size_t largest =
    std::max_element(pack.Radius.begin(), pack.Radius.end()) - pack.Radius.begin();
  pack.Mode[largest] = 2;
  ruc::NeighbourhoodSettings settings = Settings(4); // so many that both modes are classes
  EXPECT_EQ(Measure(pack, ThePack().Box, settings).Centres.back(), 1);
  settings.NeedsScatter = true;
  EXPECT_SAYS(Measure(pack, ThePack().Box, settings),
    "Multipoles requires spheres of every class in more than one part of the pack, which differ, "
    "got no scatter in class 2");
}

TEST(NeighbourhoodMultipoles, ClassesHaveAboutEqualVolumes)
{
  using Classes = std::vector<int>;
  EXPECT_EQ(ruc::FindClasses({ 3, 1, 2 }, { 1, 1, 1 }, 3), (Classes{ 2, 0, 1 }));
  EXPECT_EQ(ruc::FindClasses({ 1, 2, 3, 4 }, { 1, 1, 1, 1 }, 2), (Classes{ 0, 0, 1, 1 }));
  EXPECT_EQ(ruc::FindClasses({ 1, 2 }, { 1, 1 }, 1), (Classes{ 0, 0 }));
  EXPECT_EQ(ruc::FindClasses({ 1, 2 }, { 1, 8 }, 4), (Classes{ 0, 1 })) << "no class without modes";
  EXPECT_EQ(ruc::FindClasses({ 5 }, { 2 }, 3), (Classes{ 0 }));
}
