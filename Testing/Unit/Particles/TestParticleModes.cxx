// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/ParticleModes.h"

#include "Oracles.h"
#include "ThreadRanks.h"

namespace
{
using ruc::ModeMethod;
using ruc::ModeSettings;
using ruc::ParticleModes;

ModeSettings Settings(
  ModeMethod method, int modes, std::vector<double> edges = {}, double minimum = 0.0)
{
  ModeSettings settings;
  settings.Method = method;
  settings.NumberOfModes = modes;
  settings.Edges = std::move(edges);
  settings.MinimumDiameter = minimum;
  return settings;
}

std::vector<int> ModesOf(const ParticleModes& modes, const std::vector<double>& diameters)
{
  std::vector<int> result;
  for (double d : diameters)
  {
    result.push_back(modes.ModeOf(d));
  }
  return result;
}

// The summaries must be those of the diameters that ModeOf puts into a mode.
void ExpectSummaries(const ParticleModes& modes, const std::vector<double>& diameters)
{
  for (int m = 1; m <= modes.NumberOfModes(); ++m)
  {
    std::size_t count = 0;
    double least = 1e300, most = 0.0, cubes = 0.0;
    for (double d : diameters)
    {
      if (modes.ModeOf(d) == m)
      {
        ++count;
        least = std::min(least, d);
        most = std::max(most, d);
        cubes += d * d * d;
      }
    }
    const ruc::ModeSummary& summary = modes.Summary(m);
    EXPECT_GT(count, 0u);
    EXPECT_EQ(summary.Count, count);
    EXPECT_EQ(summary.MinimumDiameter, least);
    EXPECT_EQ(summary.MaximumDiameter, most);
    // The rounding of a sum of positive terms
    EXPECT_NEAR(summary.Volume, oracle::Pi / 6.0 * cubes, 1e-12 * cubes);
    EXPECT_NEAR(summary.VolumeMeanDiameter, std::cbrt(cubes / count), 1e-12 * most);
  }
}
}

TEST(ParticleModes, EqualWidth)
{
  const std::vector<double> diameters = { 2.9, 1.0, 1.4, 4.0, 2.1, 1.99, 3.1 };
  const ParticleModes modes(
    diameters, Settings(ModeMethod::EqualWidth, 3)); // [1, 2), [2, 3), [3, 4]
  EXPECT_EQ(ModesOf(modes, diameters), (std::vector<int>{ 2, 1, 1, 3, 2, 1, 3 }));
  ExpectSummaries(modes, diameters);
  EXPECT_EQ(ModesOf(ParticleModes(diameters, Settings(ModeMethod::EqualWidth, 1)), diameters),
    std::vector<int>(7, 1));
}

TEST(ParticleModes, EmptyModesAreLeftOut)
{
  const std::vector<double> diameters = { 1.0, 1.1, 9.8, 10.0, 5.5 };
  const ParticleModes modes(diameters, Settings(ModeMethod::EqualWidth, 9));
  EXPECT_EQ(modes.NumberOfModes(), 3);
  EXPECT_EQ(ModesOf(modes, diameters), (std::vector<int>{ 1, 1, 3, 3, 2 }));
  ExpectSummaries(modes, diameters);
  EXPECT_EQ(
    ParticleModes({ 2.0, 2.0, 2.0 }, Settings(ModeMethod::EqualWidth, 9)).NumberOfModes(), 1);
  EXPECT_EQ(
    ParticleModes({ 2.0, 2.0, 2.0 }, Settings(ModeMethod::EqualVolume, 9)).NumberOfModes(), 1);
}

TEST(ParticleModes, EqualVolume)
{
  oracle::Uniform random(6);
  std::vector<double> diameters;
  double total = 0.0, largest = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    diameters.push_back(std::exp(random(0.0, 1.5)));
    const double volume = oracle::Pi / 6.0 * std::pow(diameters.back(), 3);
    total += volume;
    largest = std::max(largest, volume);
  }
  for (int number : { 1, 2, 5, 9 })
  {
    const ParticleModes modes(diameters, Settings(ModeMethod::EqualVolume, number));
    ASSERT_EQ(modes.NumberOfModes(), number);
    for (int m = 1; m <= number; ++m)
    {
      EXPECT_NEAR(modes.Summary(m).Volume, total / number, largest)
        << m; // half a sphere at either border
      EXPECT_TRUE(
        m == 1 || modes.Summary(m).MinimumDiameter > modes.Summary(m - 1).MaximumDiameter);
    }
    ExpectSummaries(modes, diameters);
  }
}

TEST(ParticleModes, EqualVolumeWithFewSpheres)
{
  const std::vector<double> diameters = { 1.0, 1.0, 10.0 };
  const ParticleModes modes(diameters, Settings(ModeMethod::EqualVolume, 5));
  ExpectSummaries(modes, diameters);
  EXPECT_EQ(ModesOf(modes, diameters), (std::vector<int>{ 1, 1, 2 }));
}

TEST(ParticleModes, ExplicitEdges)
{
  const std::vector<double> diameters = { 1.0, 2.0, 2.5, 3.0, 7.0, 10.0 };
  const ParticleModes modes(
    diameters, Settings(ModeMethod::ExplicitEdges, 9, { 1.0, 2.5, 4.0, 6.0, 10.0 }));
  EXPECT_EQ(ModesOf(modes, diameters), (std::vector<int>{ 1, 1, 2, 2, 3, 3 })); // none in [4, 6)
  ExpectSummaries(modes, diameters);
}

TEST(ParticleModes, OnePerSize)
{
  const std::vector<double> diameters = { 3.0, 1.0, 3.0, 2.0, 1.0 * (1 + 1e-12), 1.001 };
  const ParticleModes modes(diameters, Settings(ModeMethod::OnePerSize, 1));
  EXPECT_EQ(ModesOf(modes, diameters), (std::vector<int>{ 4, 1, 4, 3, 1, 2 }));
  ExpectSummaries(modes, diameters);
  std::vector<double> many;
  for (int i = 0; i < ruc::MostModes; ++i)
  {
    many.push_back(1.0 + 0.01 * i);
  }
  EXPECT_EQ(
    ParticleModes(many, Settings(ModeMethod::OnePerSize, 1)).NumberOfModes(), ruc::MostModes);
  many.push_back(20.0);
  EXPECT_SAYS(
    ParticleModes(many, Settings(ModeMethod::OnePerSize, 1)), "at most 256 distinct diameters");
}

TEST(ParticleModes, MinimumDiameterLeavesSmallSpheresOut)
{
  const std::vector<double> diameters = { 0.5, 1.0, 2.0, 0.99, 3.0 };
  const ParticleModes modes(diameters, Settings(ModeMethod::EqualWidth, 2, {}, 1.0));
  EXPECT_EQ(ModesOf(modes, diameters), (std::vector<int>{ 0, 1, 2, 0, 2 }));
  EXPECT_EQ(modes.Summary(1).Count, 1u);
  ExpectSummaries(modes, diameters);
  const ParticleModes edges(
    diameters, Settings(ModeMethod::ExplicitEdges, 1, { 1.0, 2.5, 3.0 }, 1.0));
  EXPECT_EQ(ModesOf(edges, diameters), (std::vector<int>{ 0, 1, 1, 0, 2 }));
}

TEST(ParticleModes, BadSettings)
{
  const std::vector<double> some = { 1.0, 2.0 };
  EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::EqualWidth, 0)),
    "NumberOfModes requires 1 <= NumberOfModes <= 256, got 0");
  EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::EqualWidth, 257)), "got 257");
  EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::EqualWidth, -1)), "got -1");
  EXPECT_SAYS(
    ParticleModes(some, Settings(ModeMethod::ExplicitEdges, 9, std::vector<double>(300, 1.0))),
    "got 300");
  EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::EqualWidth, 3, {}, 2.5)),
    "MinimumDiameter requires a value that leaves");
  EXPECT_SAYS(ParticleModes({}, Settings(ModeMethod::EqualWidth, 3)), "at least one sphere");
  for (double bad : { -1.0, std::nan(""), HUGE_VAL })
  {
    EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::EqualWidth, 3, {}, bad)),
      "MinimumDiameter requires a finite number >= 0");
  }
  const std::vector<std::vector<double>> badEdges = { {}, { 1.0 }, { 2.0, 1.0 }, { 1.0, 1.0, 2.0 },
    { -1.0, 3.0 }, { 1.0, HUGE_VAL }, { std::nan(""), 3.0 }, { 1.0, std::nan(""), 3.0 },
    { 1.0, std::nan("") } };
  for (const std::vector<double>& edges : badEdges)
  {
    EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::ExplicitEdges, 9, edges)),
      "Edges requires two or more ascending");
  }
  EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::ExplicitEdges, 9, { 1.5, 3.0 })),
    "got diameters from 1 to 2");
  EXPECT_SAYS(ParticleModes(some, Settings(ModeMethod::ExplicitEdges, 9, { 0.5, 1.5 })),
    "got diameters from 1 to 2");
}

TEST(ParticleModes, AreTheSameForAnySharing)
{
  oracle::Uniform random(9);
  std::vector<double> diameters;
  for (int i = 0; i < 500; ++i)
  {
    diameters.push_back(0.1 * std::floor(random(10.0, 80.0)) * (1.0 + 1e-12 * random()));
  }
  for (const ModeSettings& settings :
    { Settings(ModeMethod::EqualWidth, 9), Settings(ModeMethod::EqualVolume, 7),
      Settings(ModeMethod::ExplicitEdges, 9, { 0.5, 2.0, 3.3, 9.0 }),
      Settings(ModeMethod::OnePerSize, 1), Settings(ModeMethod::EqualWidth, 9, {}, 3.0) })
  {
    const ParticleModes whole(diameters, settings);
    for (int size : { 2, 5 })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          std::vector<double> own; // the last rank has none
          for (std::size_t i = 0; i < diameters.size(); ++i)
          {
            if (static_cast<int>(i) % (size - 1) == ranks.Rank())
            {
              own.push_back(diameters[i]);
            }
          }
          const ParticleModes shared(own, settings, ranks);
          ASSERT_EQ(shared.NumberOfModes(), whole.NumberOfModes());
          for (int m = 1; m <= whole.NumberOfModes(); ++m)
          {
            const ruc::ModeSummary &a = shared.Summary(m), &b = whole.Summary(m);
            EXPECT_EQ(a.Count, b.Count);
            EXPECT_EQ(a.MinimumDiameter, b.MinimumDiameter);
            EXPECT_EQ(a.MaximumDiameter, b.MaximumDiameter);
            EXPECT_EQ(a.VolumeMeanDiameter, b.VolumeMeanDiameter);
            EXPECT_EQ(a.Volume, b.Volume);
          }
          for (double d : diameters)
          {
            EXPECT_EQ(shared.ModeOf(d), whole.ModeOf(d));
          }
        });
    }
  }
}

TEST(ParticleModes, AModeOfTinySpheresKeepsItsVolume)
{
  for (double tiny : { 1e-3, 1e-5, 1e-6, 1e-12 })
  {
    std::vector<double> diameters = { 2.0 };
    diameters.insert(diameters.end(), 30, 2.0 * tiny);
    const ParticleModes modes(diameters, Settings(ModeMethod::OnePerSize, 0));
    ASSERT_EQ(modes.NumberOfModes(), 2);
    EXPECT_NEAR(modes.Summary(1).VolumeMeanDiameter / (2.0 * tiny), 1.0, 1e-6);
    EXPECT_NEAR(
      modes.Summary(1).Volume / (30 * 4.0 / 3.0 * oracle::Pi * std::pow(tiny, 3)), 1.0, 1e-6);
  }
}
