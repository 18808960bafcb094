// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// What third-order parameters are, against other methods and identities
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include "ThirdOrderPacks.h"
#include "ruc/Statistics/ThirdOrder/MultipoleSums.h"

#include <cmath>

namespace
{
using oracle::Measure;
using oracle::Settings;
using oracle::SomePack;
using ruc::SpherePack;
using ruc::ThirdOrderOfSpheres;
using ruc::ThirdOrderSettings;
using ruc::Window;

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
