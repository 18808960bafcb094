// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/HardSpheres.h"
#include "ruc/Packing/PackOrder.h"

#include "PackingOracles.h"

namespace
{
const auto Always = []() { return true; };

ruc::DensePack SoftPack(const std::vector<double>& radii, double fraction,
  const std::array<bool, 3>& periodic = { true, true, true })
{
  ruc::DensePackSettings settings;
  settings.Radii = radii;
  settings.Fraction = fraction;
  settings.Periodic = periodic;
  settings.Protocol = ruc::PackingProtocol::Soft;
  return ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
}

struct Mean
{
  double Value, Error;
};

// P V / (N k T), from blocks of 50 collisions of a sphere after an equilibration
Mean MeasurePressure(const std::vector<double>& radii, double fraction)
{
  const ruc::DensePack pack = SoftPack(radii, fraction);
  ruc::HardSpheres spheres(pack.Pack, pack.Box, 1.0, { 1, false });
  spheres.Equilibrate(200.0, Always);
  constexpr int Blocks = 40;
  double sum = 0.0, squares = 0.0;
  for (int n = 0; n < Blocks; ++n)
  {
    spheres.Equilibrate(50.0, Always);
    sum += spheres.ReducedPressure();
    squares += spheres.ReducedPressure() * spheres.ReducedPressure();
  }
  EXPECT_GE(oracle::LeastRoom(spheres.GetPack(), pack.Box), -1e-12);
  const double mean = sum / Blocks;
  return { mean, std::sqrt((squares / Blocks - mean * mean) / (Blocks - 1)) };
}

// g(r) of equal spheres in a cube, in bins of that part of a diameter up to 2.2 of them
std::vector<double> RadialDistribution(
  const ruc::SpherePack& pack, const ruc::Window& box, double bin)
{
  const double diameter = 2.0 * pack.Radius[0], count = static_cast<double>(pack.Size());
  std::vector<double> g(static_cast<std::size_t>(2.2 / bin) + 1, 0.0);
  oracle::ForEachPair(pack, box,
    [&](std::size_t, std::size_t, double distance)
    {
      const auto n = static_cast<std::size_t>(distance / diameter / bin);
      if (n < g.size())
      {
        const double room = 4.0 / 3.0 * oracle::Pi * std::pow(bin * diameter, 3) *
          (std::pow(n + 1.0, 3) - std::pow(n, 3));
        g[n] += box.Volume() / (0.5 * count * count * room);
      }
    });
  return g;
}

std::vector<double> TwoSizes(int small, double a, int large, double b)
{
  std::vector<double> radii(small, a);
  radii.insert(radii.end(), large, b);
  return radii;
}
}

// Carnahan and Starling (J. Chem. Phys. 51, 635, 1969)
TEST(HardSpheres, PressureOfEqualSpheres)
{
  for (double phi : { 0.30, 0.40, 0.49 })
  {
    const Mean found = MeasurePressure(std::vector<double>(400, 0.5), phi);
    const double expected =
      (1.0 + phi + phi * phi - phi * phi * phi) / ((1.0 - phi) * (1.0 - phi) * (1.0 - phi));
    EXPECT_NEAR(found.Value, expected, 3.0 * found.Error) << phi;
    EXPECT_LT(found.Error, 0.01 * expected);
  }
}

// Mansoori, Carnahan, Starling and Leland (J. Chem. Phys. 54, 1523, 1971)
TEST(HardSpheres, PressureOfTwoSizes)
{
  const std::vector<double> radii = TwoSizes(400, 0.5, 40, 1.5);
  const double phi = 0.40;
  const Mean found = MeasurePressure(radii, phi);
  const double volume = [&]()
  {
    double sum = 0.0;
    for (double r : radii)
    {
      sum += oracle::Pi / 6.0 * 8.0 * r * r * r;
    }
    return sum / phi;
  }();
  double xi[4] = {};
  for (double r : radii)
  {
    for (int n = 0; n < 4; ++n)
    {
      xi[n] += oracle::Pi / 6.0 * std::pow(2.0 * r, n) / volume;
    }
  }
  const double rest = 1.0 - xi[3];
  const double expected = 1.0 / rest + 3.0 * xi[1] * xi[2] / (xi[0] * rest * rest) +
    (3.0 - xi[3]) * xi[2] * xi[2] * xi[2] / (xi[0] * rest * rest * rest);
  EXPECT_NEAR(found.Value, expected, 3.0 * found.Error);
  EXPECT_LT(found.Error, 0.02 * expected);
}

// Boublik (J. Chem. Phys. 53, 471, 1970) and Mansoori et al.: how much more often than at random
// two spheres of given sizes touch. Counted in shells of a fiftieth of the contact, and
// extrapolated to it.
TEST(HardSpheres, ContactsOfTwoSizes)
{
  constexpr int Small = 400, Large = 60, Blocks = 30, Snapshots = 12;
  constexpr double Shell = 0.02;
  const double phi = 0.40;
  const std::vector<double> radii = TwoSizes(Small, 0.5, Large, 1.0);
  const ruc::DensePack pack = SoftPack(radii, phi);
  const double edge = pack.Box.Size[0], volume = edge * edge * edge;
  ruc::HardSpheres spheres(pack.Pack, pack.Box, 1.0, { 1, false });
  spheres.Equilibrate(300.0, Always);
  std::array<double, 3> sum{}, squares{}; // small and small, small and large, large and large
  for (int block = 0; block < Blocks; ++block)
  {
    std::array<std::array<double, 2>, 3> pairs{}; // in the two shells
    for (int n = 0; n < Snapshots; ++n)
    {
      spheres.Equilibrate(10.0, Always);
      oracle::ForEachPair(spheres.GetPack(), pack.Box,
        [&](std::size_t i, std::size_t j, double distance)
        {
          const double gap = distance / (radii[i] + radii[j]) - 1.0;
          if (gap < 2.0 * Shell)
          {
            ++pairs[(radii[i] > 0.5) + (radii[j] > 0.5)][gap < Shell ? 0 : 1];
          }
        });
    }
    const double atRandom[3] = { 0.5 * Small * (Small - 1), double(Small) * Large,
      0.5 * Large * (Large - 1) };
    for (int k = 0; k < 3; ++k)
    {
      const double contact = 1.0 + 0.5 * k;
      const auto g = [&](int shell)
      {
        const double inner = contact * (1.0 + shell * Shell), outer = inner + contact * Shell;
        const double room = 4.0 / 3.0 * oracle::Pi * (std::pow(outer, 3) - std::pow(inner, 3));
        return pairs[k][shell] / Snapshots / (atRandom[k] * room / volume);
      };
      const double value = 1.5 * g(0) - 0.5 * g(1);
      sum[k] += value / Blocks;
      squares[k] += value * value / Blocks;
    }
  }
  const double xi = oracle::Pi / 6.0 * (Small + 4.0 * Large) / volume;
  for (int k = 0; k < 3; ++k)
  {
    const double error = std::sqrt((squares[k] - sum[k] * sum[k]) / (Blocks - 1));
    const double d = k == 0 ? 0.5 : k == 1 ? 2.0 / 3.0 : 1.0; // D_i D_j / (D_i + D_j)
    const double expected = 1.0 / (1.0 - phi) + 3.0 * xi * d / ((1.0 - phi) * (1.0 - phi)) +
      2.0 * xi * xi * d * d / std::pow(1.0 - phi, 3);
    // What the line leaves out of the curve of g is below a hundredth
    EXPECT_NEAR(sum[k], expected, 3.0 * error + 0.01 * expected) << k;
    EXPECT_LT(error, 0.03 * expected) << k;
  }
}

TEST(HardSpheres, CollisionsKeepEnergy)
{
  const ruc::DensePack pack = SoftPack(TwoSizes(200, 0.5, 20, 1.0), 0.45);
  ruc::HardSpheres spheres(pack.Pack, pack.Box, 1.0, { 3, false });
  const double energy = spheres.KineticEnergy();
  EXPECT_NEAR(energy, 0.5 * (3 * 220 - 3), 1e-9);
  spheres.Equilibrate(45.0, Always); // fewer than those after which the temperature is set
  EXPECT_NEAR(spheres.KineticEnergy() / energy, 1.0, 1e-10);
  EXPECT_NEAR(spheres.CollisionsOfSphere(), 45.0, 0.1);
}

TEST(HardSpheres, GrowWithoutOverlap)
{
  for (bool exchange : { false, true })
  {
    std::vector<double> radii;
    for (int n = 0; n < 300; ++n)
    {
      radii.push_back(0.5 + 0.002 * n);
    }
    const ruc::DensePack pack = SoftPack(radii, 0.50);
    const double growth = std::cbrt(0.62 / 0.50);
    ruc::HardSpheres spheres(pack.Pack, pack.Box, growth, { 2, exchange });
    EXPECT_EQ(spheres.Grow(growth, 0.05, Always), ruc::HardSpheres::End::Done);
    EXPECT_NEAR(spheres.GetGrowth(), growth, 1e-14);
    const ruc::SpherePack grown = spheres.GetPack();
    EXPECT_GE(oracle::LeastRoom(grown, pack.Box), -1e-12);
    EXPECT_NEAR(oracle::FractionOf(grown, pack.Box), 0.62, 1e-12);
    std::vector<double> sorted = grown.Radius;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      EXPECT_NEAR(sorted[i], growth * radii[i], 1e-12);
    }
    EXPECT_EQ(sorted == grown.Radius, !exchange);
  }
}

// In a thin pack a thousand flights go by between two collisions
TEST(HardSpheres, AreStoppedBeforeTheyCollide)
{
  const ruc::DensePack pack = SoftPack(std::vector<double>(20, 0.5), 1e-5);
  ruc::HardSpheres spheres(pack.Pack, pack.Box, 1.0, { 1, false });
  EXPECT_EQ(spheres.Equilibrate(1e9, []() { return false; }), ruc::HardSpheres::End::Stopped);
  EXPECT_LT(spheres.CollisionsOfSphere(), 50.0);
}

TEST(HardSpheres, StayBetweenWalls)
{
  const ruc::DensePack pack = SoftPack(TwoSizes(200, 0.5, 20, 1.0), 0.40, { false, true, false });
  EXPECT_GE(oracle::LeastRoom(pack.Pack, pack.Box), 0.0);
  const double growth = std::cbrt(0.50 / 0.40);
  ruc::HardSpheres spheres(pack.Pack, pack.Box, growth, { 2, false });
  EXPECT_EQ(spheres.Grow(growth, 0.05, Always), ruc::HardSpheres::End::Done);
  EXPECT_GE(oracle::LeastRoom(spheres.GetPack(), pack.Box), -1e-12);
}

TEST(HardSpheres, AreStoppedAndJam)
{
  const ruc::DensePack pack = SoftPack(std::vector<double>(200, 0.5), 0.50);
  const double growth = std::cbrt(0.70 / 0.50);
  ruc::HardSpheres stopped(pack.Pack, pack.Box, growth, { 2, false });
  EXPECT_EQ(stopped.Grow(growth, 0.05, []() { return false; }), ruc::HardSpheres::End::Stopped);
  ruc::HardSpheres jammed(pack.Pack, pack.Box, growth, { 2, false });
  EXPECT_EQ(jammed.Grow(growth, 0.1, Always), ruc::HardSpheres::End::Jammed);
  EXPECT_LT(jammed.GetGrowth(), std::cbrt(0.65 / 0.50));
  EXPECT_GT(jammed.GetGrowth(), std::cbrt(0.60 / 0.50));
  EXPECT_GE(oracle::LeastRoom(jammed.GetPack(), pack.Box), -1e-12);
}

// What is known of jammed packs of equal spheres without friction (Donev, Torquato and Stillinger,
// Phys. Rev. E 71, 011105, 2005; O'Hern et al., Phys. Rev. E 68, 011306, 2003)
TEST(HardSpheres, JammedSpheresAreIsostatic)
{
  const ruc::DensePack pack = SoftPack(std::vector<double>(1000, 0.5), 0.54);
  const double growth = std::cbrt(0.70 / 0.54);
  ruc::HardSpheres spheres(pack.Pack, pack.Box, growth, { 1, false });
  EXPECT_EQ(spheres.Grow(growth, 0.03, Always), ruc::HardSpheres::End::Jammed);
  for (double step : { 1e-3, 1e-4, 1e-5 }) // by which the gaps are closed
  {
    while (spheres.Grow(1.0 + step, 0.03, Always) == ruc::HardSpheres::End::Done)
    {
    }
  }
  const ruc::SpherePack jammed = spheres.GetPack();
  EXPECT_GE(oracle::LeastRoom(jammed, pack.Box), -1e-12);
  const double fraction = oracle::FractionOf(jammed, pack.Box);
  EXPECT_GT(fraction, 0.625);
  EXPECT_LT(fraction, 0.648);
  const ruc::PackOrder order = ruc::MeasureOrder(jammed, pack.Box, 1e-4);
  EXPECT_GT(order.CoordinationNumber, 5.3);
  EXPECT_LT(order.CoordinationNumber, 6.3);
  EXPECT_GT(order.RattlerPercent, 1.0);
  EXPECT_LT(order.RattlerPercent, 15.0);
  EXPECT_LT(order.Q6, 0.1);

  // The second peak of g(r) is split: at sqrt(3) and at 2 diameters, behind
  // which it falls at once
  const std::vector<double> g = RadialDistribution(jammed, pack.Box, 0.02);
  const auto at = [&](double diameters) { return g[static_cast<std::size_t>(diameters / 0.02)]; };
  const double third = at(1.733), second = at(1.99);
  for (double elsewhere : { 1.61, 1.65, 1.69, 1.79, 1.83, 1.87 })
  {
    EXPECT_GT(third, 1.05 * at(elsewhere)) << elsewhere;
  }
  for (double elsewhere : { 1.81, 1.85, 1.89, 1.93, 2.03, 2.07, 2.11, 2.15 })
  {
    EXPECT_GT(second, 1.1 * at(elsewhere)) << elsewhere;
  }
  EXPECT_GT(second, 1.3 * at(2.01));
}
