// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/PackFormats.h"
#include "ruc/Statistics/ThirdOrder/MultipoleSums.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <omp.h>

namespace
{
using ruc::SpherePack;
using ruc::ThirdOrderOfSpheres;
using ruc::ThirdOrderSettings;
using ruc::Window;

ThirdOrderOfSpheres Measure(
  const SpherePack& pack, const Window& window, const ThirdOrderSettings& settings)
{
  ruc::Communicator serial;
  return ruc::MeasureThirdOrder(ruc::SharePack(pack, window), settings, serial);
}

struct Lattice
{
  const char* Name;
  std::vector<ruc::Vector3> Basis;
};
const Lattice Simple = { "SC", { { 0.0, 0.0, 0.0 } } };
const Lattice BodyCentred = { "BCC", { { 0.0, 0.0, 0.0 }, { 0.5, 0.5, 0.5 } } };
const Lattice FaceCentred = { "FCC",
  { { 0.0, 0.0, 0.0 }, { 0.5, 0.5, 0.0 }, { 0.5, 0.0, 0.5 }, { 0.0, 0.5, 0.5 } } };

// Cells of a lattice, `count` along each edge
SpherePack MakeLattice(const Lattice& lattice, double fraction, int count)
{
  SpherePack pack;
  const double radius = std::cbrt(fraction / lattice.Basis.size() / (4.0 / 3.0 * oracle::Pi));
  for (int n = 0; n < count * count * count; ++n)
  {
    for (const ruc::Vector3& at : lattice.Basis)
    {
      pack.X.push_back(n % count + at[0]);
      pack.Y.push_back(n / count % count + at[1]);
      pack.Z.push_back(n / count / count + at[2]);
      pack.Radius.push_back(radius);
      pack.Mode.push_back(1);
    }
  }
  return pack;
}

ThirdOrderOfSpheres MeasureLattice(
  const Lattice& lattice, double fraction, double diameters, int count = 1)
{
  const SpherePack pack = MakeLattice(lattice, fraction, count);
  ThirdOrderSettings settings;
  settings.CutOff = 2.0 * diameters * pack.Radius.front();
  settings.MaximumDegree = 14;
  return Measure(pack, oracle::PeriodicCube(count), settings);
}

// Two spheres of two modes in a unit cube
SpherePack TwoRadii()
{
  SpherePack pack;
  pack.X = { 0.0, 0.45 };
  pack.Y = { 0.0, 0.5 };
  pack.Z = { 0.0, 0.5 };
  pack.Radius = { 0.42, 0.25 };
  pack.Mode = { 1, 2 };
  return pack;
}

// A pack without overlap in a periodic cube of edge 10
SpherePack SomePack()
{
  return oracle::RelaxedPack({ 60, 90 }, { 0.9, 0.6 }, oracle::PeriodicCube(10.0), 3);
}

ThirdOrderSettings Settings(double cutOff, bool byMode)
{
  ThirdOrderSettings settings;
  settings.CutOff = cutOff;
  settings.ByMode = byMode;
  settings.Blocks = 8;
  return settings;
}

void ExpectSame(const ruc::ThirdOrderFigure& a, const ruc::ThirdOrderFigure& b)
{
  const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  EXPECT_TRUE(same(a.Value, b.Value)) << a.Value << " " << b.Value;
  EXPECT_TRUE(same(a.Error, b.Error)) << a.Error << " " << b.Error;
}

void ExpectSame(const ThirdOrderOfSpheres& a, const ThirdOrderOfSpheres& b)
{
  EXPECT_EQ(a.Centres, b.Centres);
  EXPECT_EQ(a.Blocks, b.Blocks);
  EXPECT_EQ(a.SpectrumOf, b.SpectrumOf);
  ExpectSame(a.Spheres.Zeta, b.Spheres.Zeta);
  ExpectSame(a.Spheres.Eta, b.Spheres.Eta);
  for (std::size_t n = 0; n < a.Second.size(); ++n)
  {
    ExpectSame(a.Second[n], b.Second[n]);
    ExpectSame(a.Fourth[n], b.Fourth[n]);
  }
  ASSERT_EQ(a.Slabs.size(), b.Slabs.size());
  for (std::size_t n = 0; n < a.Slabs.size(); ++n)
  {
    EXPECT_EQ(a.Slabs[n].Centres, b.Slabs[n].Centres);
    EXPECT_EQ(a.Slabs[n].Fraction, b.Slabs[n].Fraction);
    ExpectSame(a.Slabs[n].Zeta, b.Slabs[n].Zeta);
  }
}

double SumOfSpectrum(const ThirdOrderOfSpheres& of)
{
  double sum = 0.0;
  for (const ruc::ThirdOrderFigure& figure : of.Spectrum)
  {
    sum += figure.Value;
  }
  return sum;
}
}

// Zeta of lattices from Rayleigh's method, third order in the contrast, to the last digit given
TEST(ThirdOrderOfSpheres, ZetaOfLattices)
{
  const struct
  {
    Lattice Of;
    double Fraction, Zeta;
  } cases[] = { { Simple, 0.2, 0.004947 }, { Simple, 0.4, 0.067808 }, { Simple, 0.5, 0.173764 },
    { BodyCentred, 0.4, 0.010662 }, { BodyCentred, 0.6, 0.079557 }, { FaceCentred, 0.4, 0.007736 },
    { FaceCentred, 0.6, 0.061973 }, { FaceCentred, 0.7, 0.159670 } };
  for (const auto& of : cases)
  {
    const ThirdOrderOfSpheres found = MeasureLattice(of.Of, of.Fraction, 10.0);
    EXPECT_TRUE(found.Ewald);
    EXPECT_NEAR(found.Spheres.Zeta.Value, of.Zeta, 1.2e-6) << of.Of.Name << " " << of.Fraction;
    // Sums are rounded to 2^-38
    EXPECT_NEAR(SumOfSpectrum(found), found.Spheres.Zeta.Value, 1e-10);
  }
}

// Eta of the simple cubic lattice from fields on grids, made by transforms and extrapolated to an
// infinitely fine one (0.1730 and 0.2556, where the zeta of that way is 0.0678 and 0.1724, so 0.8 %
// too low); the others against change
TEST(ThirdOrderOfSpheres, EtaOfLattices)
{
  EXPECT_NEAR(MeasureLattice(Simple, 0.4, 10.0).Spheres.Eta.Value, 0.1730, 1e-4);
  EXPECT_NEAR(MeasureLattice(Simple, 0.5, 10.0).Spheres.Eta.Value, 0.2556, 2e-3);
  EXPECT_NEAR(MeasureLattice(BodyCentred, 0.4, 10.0).Spheres.Eta.Value, 0.14069, 1e-4);
  EXPECT_NEAR(MeasureLattice(BodyCentred, 0.6, 10.0).Spheres.Eta.Value, 0.28989, 1e-4);
  EXPECT_NEAR(MeasureLattice(FaceCentred, 0.4, 10.0).Spheres.Eta.Value, 0.14403, 1e-4);
  EXPECT_NEAR(MeasureLattice(FaceCentred, 0.6, 10.0).Spheres.Eta.Value, 0.29283, 1e-4);
  EXPECT_NEAR(MeasureLattice(FaceCentred, 0.7, 10.0).Spheres.Eta.Value, 0.36601, 5e-4);
}

// Fields on grids, made by transforms and extrapolated, to the digits that they are good to
TEST(ThirdOrderOfSpheres, IntegralsOfTwoRadii)
{
  ThirdOrderSettings settings = Settings(6.0, true);
  settings.MaximumDegree = 14;
  const ThirdOrderOfSpheres found = Measure(TwoRadii(), oracle::PeriodicCube(1.0), settings);
  const auto second = [&](int q, int r, int s)
  { return found.Second[found.PlaceOf(q, r, s)].Value; };
  EXPECT_NEAR(second(0, 0, 1), -0.000466, 1e-6);
  EXPECT_NEAR(second(0, 1, 1), 0.000280, 1e-6);
  EXPECT_NEAR(second(1, 0, 0), 0.000153, 1e-6);
  EXPECT_NEAR(second(2, 0, 0), 0.04622, 1e-5);
  EXPECT_NEAR(second(2, 0, 1), -0.00403, 1e-5);
  EXPECT_NEAR(second(2, 1, 1), 0.01331, 1e-5);
}

// How Ewald's sum is divided between the two spaces does not matter
TEST(ThirdOrderOfSpheres, DoesNotDependOnAlpha)
{
  const Window box = Window::MakeBox({ 1, 2, 3 }, { 10, 10, 10 }, { true, true, true });
  SpherePack pack = SomePack();
  const ruc::PackShare share = ruc::SharePack(pack, box);
  ruc::Communicator serial;
  const ruc::CentreRegion region(box, 0.0, Settings(0.0, false));
  const ruc::SumLayout layout(1, 10, region);
  const std::vector<int> source(pack.Size(), 0);
  std::vector<std::vector<double>> fields;
  for (double alpha : { 0.4, 0.5, 0.6, 0.75 })
  {
    ruc::MultipoleSettings settings;
    settings.CutOff = 12.0;
    settings.Alpha = alpha;
    ruc::MultipoleSums sums(share, source, settings, region, layout, serial);
    fields.push_back(sums.Sum(serial, {}));
    for (std::size_t n = 0; n < fields.back().size(); ++n)
    {
      EXPECT_NEAR(fields.back()[n], fields.front()[n], 2e-6 * (1.0 + std::abs(fields.front()[n])));
    }
  }
}

// Modes that are one and the same are one mode
TEST(ThirdOrderOfSpheres, PartsOfAPhaseAddUp)
{
  const Window box = oracle::PeriodicCube(10.0);
  const ThirdOrderOfSpheres one = Measure(SomePack(), box, Settings(0.0, false));
  const ThirdOrderOfSpheres two = Measure(SomePack(), box, Settings(0.0, true));
  ASSERT_EQ(one.Sources, 1);
  ASSERT_EQ(two.Sources, 2);
  EXPECT_NEAR(one.Spheres.Zeta.Value, two.Spheres.Zeta.Value, 1e-9);
  EXPECT_NEAR(one.Spheres.Eta.Value, two.Spheres.Eta.Value, 1e-9);
  for (auto of : { &ThirdOrderOfSpheres::Second, &ThirdOrderOfSpheres::Fourth })
  {
    double sum = 0.0;
    for (int q = 0; q < 2; ++q)
    {
      for (int r = 0; r < 2; ++r)
      {
        for (int s = 0; s < 2; ++s)
        {
          sum += (two.*of)[two.PlaceOf(q, r, s)].Value;
        }
      }
    }
    EXPECT_NEAR((one.*of)[one.PlaceOf(0, 0, 0)].Value, sum, 1e-9);
  }
}

// All phases together are the whole space, in which there is no field; and over all centres only
// the pair function is left
TEST(ThirdOrderOfSpheres, SumRules)
{
  const ThirdOrderOfSpheres found =
    Measure(SomePack(), oracle::PeriodicCube(10.0), Settings(0.0, true));
  const double all[2] = { 2.0 / 9.0, 8.0 / 225.0 };
  for (int n = 0; n < 2; ++n)
  {
    const std::vector<ruc::ThirdOrderFigure>& values = n == 0 ? found.Second : found.Fourth;
    for (int r = 0; r < 3; ++r)
    {
      double overCentres = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        double overFields = 0.0;
        for (int s = 0; s < 3; ++s)
        {
          overFields += values[found.PlaceOf(q, r, s)].Value;
        }
        EXPECT_NEAR(overFields, 0.0, 1e-12);
        overCentres += values[found.PlaceOf(q, r, r)].Value;
      }
      const double c = found.Fractions[r];
      EXPECT_NEAR(overCentres, all[n] * c * (1.0 - c), 1e-12);
    }
  }
  // The matrix has 1 - zeta and 1 - eta of the spheres
  EXPECT_NEAR(found.OfPhases.back().Zeta.Value, 1.0 - found.Spheres.Zeta.Value, 1e-9);
  EXPECT_NEAR(found.OfPhases.back().Eta.Value, 1.0 - found.Spheres.Eta.Value, 1e-9);
}

TEST(ThirdOrderOfSpheres, ACellEqualsItsTiling)
{
  ThirdOrderSettings settings = Settings(6.0, true);
  const ThirdOrderOfSpheres one = Measure(TwoRadii(), oracle::PeriodicCube(1.0), settings);
  SpherePack tiled;
  for (int n = 0; n < 12; ++n)
  {
    const SpherePack cell = TwoRadii();
    for (std::size_t i = 0; i < cell.Size(); ++i)
    {
      tiled.Append(cell, i);
      tiled.X.back() += n % 2;
      tiled.Y.back() += n / 2 % 3;
      tiled.Z.back() += n / 6;
    }
  }
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 2, 3, 2 }, { true, true, true });
  const ThirdOrderOfSpheres many = Measure(tiled, box, settings);
  EXPECT_NEAR(one.Spheres.Zeta.Value, many.Spheres.Zeta.Value, 1e-9);
  EXPECT_NEAR(one.Spheres.Eta.Value, many.Spheres.Eta.Value, 1e-9);
  for (std::size_t n = 0; n < one.Second.size(); ++n)
  {
    EXPECT_NEAR(one.Second[n].Value, many.Second[n].Value, 1e-9);
    EXPECT_NEAR(one.Fourth[n].Value, many.Fourth[n].Value, 1e-9);
  }
}

// The unit of length plays no part, from atoms to stars
TEST(ThirdOrderOfSpheres, HaveNoUnit)
{
  const ThirdOrderOfSpheres found =
    Measure(SomePack(), oracle::PeriodicCube(10.0), Settings(0.0, false));
  for (double unit : { 1e-40, 1e-9, 1e40 })
  {
    SpherePack pack = SomePack();
    for (std::vector<double>* values : { &pack.X, &pack.Y, &pack.Z, &pack.Radius })
    {
      for (double& value : *values)
      {
        value *= unit;
      }
    }
    const ThirdOrderOfSpheres other =
      Measure(pack, oracle::PeriodicCube(10.0 * unit), Settings(0.0, false));
    EXPECT_NEAR(found.Spheres.Zeta.Value, other.Spheres.Zeta.Value, 1e-9) << unit;
    EXPECT_NEAR(found.Spheres.Eta.Value, other.Spheres.Eta.Value, 1e-9) << unit;
  }
}

// A cluster in the middle of an empty cylinder, turned about all axes
TEST(ThirdOrderOfSpheres, DoNotDependOnDirections)
{
  const SpherePack periodic = SomePack();
  const double angle = 0.7;
  const ruc::Vector3 rows[3] = { { std::cos(angle), 0.0, -std::sin(angle) }, { 0.48, 0.8, 0.36 },
    { 0.0, 0.0, 0.0 } };
  // Gram and Schmidt make a rotation of two rows
  ruc::Vector3 x = rows[0], y = rows[1];
  const double along = ruc::Dot(x, y);
  for (int k = 0; k < 3; ++k)
  {
    y[k] -= along * x[k];
  }
  const double length = ruc::Length(y);
  for (double& value : y)
  {
    value /= length;
  }
  const ruc::Vector3 z = ruc::Cross(x, y);
  SpherePack straight, turned;
  for (std::size_t i = 0; i < periodic.Size(); ++i)
  {
    const ruc::Vector3 at = { periodic.X[i] - 5.0, periodic.Y[i] - 5.0, periodic.Z[i] - 5.0 };
    if (ruc::Length(at) < 4.5)
    {
      straight.Append(periodic, i);
      turned.Append(periodic, i);
      straight.X.back() = at[0];
      straight.Y.back() = at[1];
      straight.Z.back() = at[2];
      turned.X.back() = ruc::Dot(x, at);
      turned.Y.back() = ruc::Dot(y, at);
      turned.Z.back() = ruc::Dot(z, at);
    }
  }
  const Window window = Window::MakeBox({ -20, -20, -20 }, { 40, 40, 40 }, { false, false, false });
  const ThirdOrderOfSpheres one = Measure(straight, window, Settings(14.0, false));
  const ThirdOrderOfSpheres other = Measure(turned, window, Settings(14.0, false));
  EXPECT_EQ(one.Centres, static_cast<std::int64_t>(straight.Size()));
  EXPECT_FALSE(one.Ewald);
  EXPECT_NEAR(one.Spheres.Zeta.Value / other.Spheres.Zeta.Value, 1.0, 1e-9);
  EXPECT_NEAR(one.Spheres.Eta.Value / other.Spheres.Eta.Value, 1.0, 1e-9);
}

TEST(ThirdOrderOfSpheres, SameBitsOnAnyRanksAndThreads)
{
  const Window windows[] = { oracle::PeriodicCube(10.0),
    Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, true, true }),
    Window::MakeCylinder({ 5, 5, 0 }, { 0.0, 0.0, 1.0 }, 5.0, 10.0) };
  for (const Window& window : windows)
  {
    const SpherePack pack = ruc::CropToWindow(SomePack(), window);
    for (bool byMode : { false, true })
    {
      const ThirdOrderSettings settings = Settings(3.8, byMode);
      const ThirdOrderOfSpheres serial = Measure(pack, window, settings);
      const int threads = omp_get_max_threads();
      omp_set_num_threads(3);
      const ThirdOrderOfSpheres threaded = Measure(pack, window, settings);
      omp_set_num_threads(threads);
      ExpectSame(threaded, serial);
      EXPECT_GT(serial.Centres, 0);
      for (int size : { 2, 3, 4 })
      {
        for (bool allOnLast : { false, true })
        {
          oracle::ThreadRanks::Run(size,
            [&](ruc::Communicator& ranks)
            {
              const ruc::PackShare share = ruc::SharePack(
                oracle::PieceOf(pack, ranks.Rank(), size, allOnLast), window, true, ranks);
              ExpectSame(ruc::MeasureThirdOrder(share, settings, ranks), serial);
            });
        }
      }
    }
  }
}

// The mean over the spheres of their parts, weighted by volume, is zeta, and so is that of the
// slabs
TEST(ThirdOrderOfSpheres, FieldEnergiesAndSlabsMakeZeta)
{
  const Window window = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, true, true });
  const ruc::PackShare share = ruc::SharePack(SomePack(), window);
  ruc::Communicator serial;
  const ThirdOrderOfSpheres found = ruc::MeasureThirdOrder(share, Settings(3.7, false), serial);
  double sum = 0.0, weight = 0.0;
  std::int64_t centres = 0;
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    const double x = share.Own.X[i];
    EXPECT_EQ(std::isnan(found.FieldEnergy[i]), x < 3.7 || x > 6.3);
    if (!std::isnan(found.FieldEnergy[i]))
    {
      const double cube = std::pow(share.Own.Radius[i], 3);
      sum += cube * found.FieldEnergy[i];
      weight += cube;
      ++centres;
    }
  }
  EXPECT_EQ(found.Centres, centres);
  EXPECT_NEAR(sum / weight, found.Spheres.Zeta.Value, 1e-10);
  ASSERT_EQ(found.Slabs.size(), 12u);
  for (int axis = 0; axis < 3; ++axis)
  {
    double mean = 0.0, fraction = 0.0;
    for (int n = 0; n < 4; ++n)
    {
      const ThirdOrderOfSpheres::Slab& slab = found.Slabs[4 * axis + n];
      EXPECT_EQ(slab.Axis, axis);
      const double part = slab.Zeta.Value * (1.0 - slab.Fraction) / found.Fractions.back();
      mean += std::isnan(part) ? 0.0 : part * slab.Fraction;
      fraction += slab.Fraction;
    }
    EXPECT_NEAR(mean / fraction, found.Spheres.Zeta.Value, 1e-9);
  }
}

// Ewald's sum and a smooth end agree on a random pack, as well as the fluctuations of a small cell
// let them, which its images repeat
TEST(ThirdOrderOfSpheres, AWindowCutFromAPackHasItsZeta)
{
  const SpherePack cell = SomePack();
  const ThirdOrderOfSpheres periodic =
    Measure(cell, oracle::PeriodicCube(10.0), Settings(0.0, false));
  // The window holds 3 x 3 x 3 cells, and the centres are those of the one in the middle
  const SpherePack copies = oracle::WithImages(cell, 10.0);
  const Window window = Window::MakeBox({ -10, -10, -10 }, { 30, 30, 30 }, { false, false, false });
  const ThirdOrderOfSpheres cut = Measure(copies, window, Settings(10.0, false));
  EXPECT_FALSE(cut.Ewald);
  EXPECT_EQ(cut.Centres, periodic.Centres);
  EXPECT_NEAR(cut.Spheres.Zeta.Value / periodic.Spheres.Zeta.Value, 1.0, 1e-2);
  EXPECT_NEAR(cut.Spheres.Eta.Value / periodic.Spheres.Eta.Value, 1.0, 1e-2);
}

// The example pack, whose zeta two other programs found: 0.1064 and 0.1058 with centres 200 inside,
// to 0.0007 and 0.0003
TEST(ThirdOrderOfSpheres, ExamplePack)
{
  std::ifstream file(RUC_EXAMPLE_DATA "/bead_block.csv");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  SpherePack pack = ruc::ReadPack(text).Pack;
  pack.Mode.assign(pack.Size(), 1);
  const Window block =
    Window::MakeBox({ 0, 0, 0 }, { 1445.372, 1287.892, 789.106 }, { false, false, false });
  ThirdOrderSettings settings;
  settings.CutOff = 200.0;
  const ThirdOrderOfSpheres found = Measure(pack, block, settings);
  EXPECT_EQ(found.Centres, 5757);
  EXPECT_NEAR(found.Spheres.Zeta.Value, 0.1062, 5e-4);
  EXPECT_NEAR(found.Spheres.Zeta.Error, 0.0007, 2e-4);
  // The mean field grows less from the bottom to the top, as every program found
  for (int n = 1; n < 4; ++n)
  {
    EXPECT_LT(found.Slabs[8 + n].Zeta.Value, found.Slabs[8 + n - 1].Zeta.Value);
  }
}

TEST(ThirdOrderOfSpheres, EstimatesGrowWithTheCutOff)
{
  ruc::PackFigures pack;
  pack.Spheres = 10000;
  pack.Observed = Window::MakeBox({ 0, 0, 0 }, { 40, 40, 40 }, { false, false, false });
  pack.MeanRadius = pack.LargestRadius = 0.6;
  pack.MeanDiameter = 1.2;
  ThirdOrderSettings settings;
  const ruc::Estimate automatic = ruc::EstimateThirdOrder(pack, settings);
  EXPECT_EQ(automatic.Automatic, "Cut Off 6.16823");
  settings.CutOff = 5.0;
  const ruc::Estimate shorter = ruc::EstimateThirdOrder(pack, settings);
  EXPECT_TRUE(shorter.Automatic.empty());
  EXPECT_LT(shorter.Seconds, automatic.Seconds);
  EXPECT_GT(shorter.Seconds, 0.0);
  settings.MaximumDegree = 20;
  EXPECT_THROW(ruc::EstimateThirdOrder(pack, settings), std::invalid_argument);
}

TEST(ThirdOrderOfSpheres, Refusals)
{
  const SpherePack pack = SomePack();
  const Window box = oracle::PeriodicCube(10.0);
  const auto refuses = [](const SpherePack& of, const Window& window,
                         const ThirdOrderSettings& settings, const char* text)
  {
    try
    {
      Measure(of, window, settings);
      ADD_FAILURE() << "not refused: " << text;
    }
    catch (const std::invalid_argument& e)
    {
      EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
    }
  };
  const auto with = [](auto&& change)
  {
    ThirdOrderSettings settings;
    change(settings);
    return settings;
  };
  refuses(pack, box, with([](auto& s) { s.CutOff = -1.0; }), "CutOff requires CutOff >= 0");
  refuses(
    pack, box, with([](auto& s) { s.CutOff = 2.0; }), "CutOff requires at least two diameters");
  refuses(pack, box, with([](auto& s) { s.CutOff = 60.0; }), "CutOff requires at most 54.1926");
  refuses(pack, box, with([](auto& s) { s.MaximumDegree = 3; }), "MaximumDegree requires");
  refuses(pack, box, with([](auto& s) { s.MaximumDegree = 15; }), "MaximumDegree requires");
  refuses(pack, box, with([](auto& s) { s.Blocks = 1; }), "Blocks requires");
  refuses(pack, box, with([](auto& s) { s.Slabs = 0; }), "Slabs requires");

  // Every radius 2 % too large is an overlap of far more than 0.01 %
  SpherePack large = pack;
  for (double& radius : large.Radius)
  {
    radius *= 1.02;
  }
  refuses(large, box, {}, "overlap by at most 0.01 %");
  // A tiny sphere within another is less than that in volume
  SpherePack within = pack;
  within.Append(pack, 0);
  within.X.back() += 0.5;
  within.Radius.back() = 0.01;
  refuses(within, box, {}, "a tenth of the sum of their radii");

  const Window window = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false });
  refuses(pack, window, with([](auto& s) { s.CutOff = 5.0; }), "room for a margin");
  SpherePack rim;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (pack.X[i] < 3.0)
    {
      rim.Append(pack, i);
    }
  }
  refuses(rim, window, with([](auto& s) { s.CutOff = 4.0; }), "from every face of the window");
}
