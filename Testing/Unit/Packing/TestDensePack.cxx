// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/MaximumFraction.h"
#include "ruc/Packing/PackOrder.h"
#include "ruc/Packing/SphereSizes.h"

#include "PackingOracles.h"

namespace
{
using oracle::Always;
using oracle::Equal;

// Nothing overlaps, not by the last bit; the radii and the fraction are those that were asked for
void ExpectGood(const ruc::DensePack& pack, const ruc::DensePackSettings& settings)
{
  EXPECT_FALSE(pack.Jammed);
  EXPECT_FALSE(pack.Stopped);
  EXPECT_GE(oracle::LeastRoom(pack.Pack, pack.Box), 0.0);
  EXPECT_EQ(pack.Pack.Radius, settings.Radii);
  EXPECT_NEAR(oracle::FractionOf(pack.Pack, pack.Box), settings.Fraction, 1e-12);
  for (std::size_t i = 0; i < pack.Pack.Size(); ++i)
  {
    EXPECT_TRUE(pack.Box.Contains(pack.Pack.Centre(i)));
  }
}

void ExpectRefusal(const ruc::DensePackSettings& settings, const std::string& word)
{
  try
  {
    ruc::MakeDensePack(settings, Always);
    ADD_FAILURE() << "nothing was refused: " << word;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}
}

TEST(DensePack, EqualSpheresOfAnyFraction)
{
  for (double fraction : { 0.01, 0.30, 0.58, 0.60, 0.64 })
  {
    const ruc::DensePackSettings settings = Equal(400, fraction);
    const ruc::DensePack pack = ruc::MakeDensePack(settings, Always);
    ExpectGood(pack, settings);
    EXPECT_EQ(pack.IsSoft, fraction < 0.585);
    EXPECT_EQ(pack.Fraction, fraction);
    // Of a few bonds it is above 0 by chance
    EXPECT_TRUE(fraction < 0.3 || ruc::MeasureOrder(pack.Pack, pack.Box, 1e-5).Q6 < 0.1);
  }
}

// Where the spheres jam they are given in a larger box
TEST(DensePack, IsGoodWhereItJams)
{
  ruc::DensePackSettings settings = Equal(1000, 0.658);
  settings.Rate = 0.03;
  settings.Protocol = ruc::PackingProtocol::Events;
  const ruc::DensePack pack = ruc::MakeDensePack(settings, Always);
  EXPECT_TRUE(pack.Jammed);
  EXPECT_GT(pack.Fraction, 0.625);
  EXPECT_LT(pack.Fraction, 0.648);
  EXPECT_NEAR(oracle::FractionOf(pack.Pack, pack.Box), pack.Fraction, 1e-12);
  EXPECT_EQ(pack.Pack.Radius, settings.Radii);
  EXPECT_GE(oracle::LeastRoom(pack.Pack, pack.Box), 0.0);
}

TEST(DensePack, TwoSizesAndManySizes)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::Classes;
  sizes.Diameters = { 1.0, 3.0 };
  sizes.Shares = { 30.0, 70.0 };
  ruc::DensePackSettings settings;
  settings.Radii = sizes.Make(700).Radius;
  settings.Fraction = 0.70;
  ExpectGood(ruc::MakeDensePack(settings, Always), settings);
  sizes.Law = ruc::SizeLaw::LogNormal;
  sizes.StandardDeviation = 0.6;
  settings.Radii = sizes.Make(400).Radius;
  settings.Exchange = true;
  settings.Fraction = 0.68;
  ExpectGood(ruc::MakeDensePack(settings, Always), settings);
}

// Growth that jams is tried again more slowly
TEST(DensePack, ClimbsTheLadderOfRates)
{
  const ruc::DensePackSettings settings = Equal(300, 0.6434);
  const ruc::DensePack pack = ruc::MakeDensePack(settings, Always);
  ExpectGood(pack, settings);
  EXPECT_LE(pack.History.back().Rate, 0.01);
  for (const ruc::GrowthStep& step : pack.History)
  {
    EXPECT_LE(step.Fraction, settings.Fraction * (1.0 + 1e-9));
  }
}

TEST(DensePack, WallsAndOtherBoxes)
{
  ruc::DensePackSettings settings = Equal(400, 0.55);
  settings.Periodic = { true, true, false };
  settings.Proportions = { 1.0, 1.5, 2.0 };
  settings.Protocol = ruc::PackingProtocol::Events;
  settings.Equilibration = 20.0;
  const ruc::DensePack pack = ruc::MakeDensePack(settings, Always);
  ExpectGood(pack, settings);
  EXPECT_NEAR(pack.Box.Size[1] / pack.Box.Size[0], 1.5, 1e-14);
  EXPECT_NEAR(pack.Box.Size[2] / pack.Box.Size[0], 2.0, 1e-14);
}

// Carnahan and Starling (J. Chem. Phys. 51, 635, 1969)
TEST(DensePack, TellsThePressureOfAFluid)
{
  ruc::DensePackSettings settings = Equal(300, 0.45);
  settings.Equilibration = 2500.0;
  const ruc::DensePack pack = ruc::MakeDensePack(settings, Always);
  const std::optional<ruc::MeanPressure> pressure = ruc::FindMeanPressure(pack.History);
  ASSERT_TRUE(pressure);
  const double phi = 0.45;
  const double expected =
    (1.0 + phi + phi * phi - phi * phi * phi) / ((1.0 - phi) * (1.0 - phi) * (1.0 - phi));
  EXPECT_NEAR(pressure->Value, expected, 3.0 * pressure->Error);
  EXPECT_LT(pressure->Error, 0.01 * expected);
  EXPECT_GT(pressure->Error, 0.0);
  EXPECT_FALSE(ruc::FindMeanPressure({}));
  EXPECT_FALSE(ruc::FindMeanPressure(ruc::MakeDensePack(Equal(100, 0.60), Always).History));
  // The first fifth is left out, and what a step within a round repeats
  std::vector<ruc::GrowthStep> steps;
  for (double value : { 100.0, 3.0, 4.0, 4.0, 5.0, 6.0 })
  {
    steps.push_back({ 0.0, 0.4, value, 10.0 });
  }
  EXPECT_EQ(ruc::FindMeanPressure(steps)->Value, 4.5);
  EXPECT_NEAR(ruc::FindMeanPressure(steps)->Error, std::sqrt(5.0 / 12.0), 1e-15);
}

TEST(DensePack, DependsOnTheSeedAlone)
{
  ruc::DensePackSettings settings = Equal(200, 0.62);
  const ruc::DensePack first = ruc::MakeDensePack(settings, Always);
  EXPECT_EQ(ruc::MakeDensePack(settings, Always).Pack.X, first.Pack.X);
  settings.Seed = 2;
  EXPECT_NE(ruc::MakeDensePack(settings, Always).Pack.X, first.Pack.X);
}

// Stopped at any moment the growth gives the same spheres in a larger box
TEST(DensePack, IsGoodWhereItIsStopped)
{
  const ruc::DensePackSettings settings = Equal(300, 0.64);
  for (int most : { 3, 10 })
  {
    int growing = 0;
    const ruc::DensePack pack = ruc::MakeDensePack(settings,
      [&](const ruc::GrowthStep& step, double)
      {
        growing += step.Collisions > 0.0 ? 1 : 0;
        return growing < most;
      });
    EXPECT_TRUE(pack.Stopped);
    EXPECT_EQ(pack.Pack.Radius, settings.Radii);
    EXPECT_GE(oracle::LeastRoom(pack.Pack, pack.Box), 0.0);
    EXPECT_LT(pack.Fraction, 0.64);
    EXPECT_GT(pack.Fraction, 0.50);
    EXPECT_NEAR(oracle::FractionOf(pack.Pack, pack.Box), pack.Fraction, 1e-12);
  }
  EXPECT_TRUE(ruc::MakeDensePack(settings,
    [](const ruc::GrowthStep&, double) {
      return false;
    }).Pack.Empty());
}

TEST(DensePack, WhatCannotBe)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double fraction : { 0.0, -0.1, nan, 1.0, 0.67 })
  {
    ExpectRefusal(Equal(100, fraction), "Fraction");
  }
  ExpectRefusal(Equal(100, 0.67), "about 0.64");
  ExpectRefusal(Equal(1, 0.5), "NumberOfSpheres");
  ExpectRefusal(Equal(4, 0.6), "NumberOfSpheres"); // an edge of less than two diameters
  ruc::DensePackSettings settings = Equal(100, 0.5);
  settings.Proportions = { 1.0, 0.0, 1.0 };
  ExpectRefusal(settings, "BoxProportions");
  settings.Proportions = { 1.0, 0.01, 1.0 };
  ExpectRefusal(settings, "NumberOfSpheres");
  settings = Equal(100, 0.5);
  settings.Rate = -1.0;
  ExpectRefusal(settings, "Rate");
  settings = Equal(100, 0.5);
  settings.Equilibration = nan;
  ExpectRefusal(settings, "EquilibrationTime");
}
