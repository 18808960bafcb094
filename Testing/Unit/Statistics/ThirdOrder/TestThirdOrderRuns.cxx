// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// How third-order parameters are measured: on any ranks, in windows, and what is refused
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include "ThirdOrderPacks.h"
#include "ThreadRanks.h"
#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/PackFormats.h"

#include <omp.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace
{
using oracle::Measure;
using oracle::Settings;
using oracle::SomePack;
using ruc::SpherePack;
using ruc::ThirdOrderOfSpheres;
using ruc::ThirdOrderSettings;
using ruc::Window;

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
