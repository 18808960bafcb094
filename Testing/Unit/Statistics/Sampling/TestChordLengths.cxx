// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/ChordLengths.h"

#include "Oracles.h"
#include "SampledComparison.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"

namespace
{
using oracle::Pi;
using ruc::ChordLengths;
using ruc::LagGrid;
using ruc::SamplingRegion;
using ruc::SpherePack;
using ruc::Window;

ChordLengths Measured(const SpherePack& pack, int modes, const SamplingRegion& region,
  const LagGrid& lags, std::int64_t lines, std::uint32_t seed = 1)
{
  ruc::Communicator serial;
  ChordLengths lengths;
  ruc::SampleChords(pack, modes, region, lags, { seed, lines, 0.0 }, serial, {}, &lengths);
  return lengths;
}
}

TEST(ChordLengths, OfEqualSpheresAreKnown)
{
  // Chords of a sphere have the density c / (2 a^2), with a mean of 4 a / 3, and their number per
  // length is number density x pi a^2; the mean chord of the matrix is 4 c_m / s, s the surface per
  // volume. In a box of 6 few lines are so short as to cut chords; the window's 4 shows the
  // correction.
  const Window cube = oracle::PeriodicCube(6.0);
  constexpr double a = 0.7, edge = 6.0;
  constexpr int spheres = 45, lines = 12800;
  const SpherePack pack = oracle::RelaxedPack({ spheres }, { a }, cube, 2);
  const double perLength = spheres / std::pow(edge, 3) * Pi * a * a;
  const double fraction = perLength * 4.0 / 3.0 * a;
  const LagGrid lags = { 0.15, 12 };
  const ChordLengths lengths = Measured(pack, 1, SamplingRegion(cube, 0.0), lags, lines);
  const double chords = lines * (edge + lags.Maximum()) * perLength;
  // Mean chords: numbers of chords are uncertain by less than 1 / sqrt(chords), lengths likewise
  EXPECT_NEAR(lengths.MeanChord[0], 4.0 / 3.0 * a, 5.0 * a / std::sqrt(chords));
  const double matrix = (1.0 - fraction) / perLength;
  EXPECT_NEAR(lengths.MeanChord[1], matrix, 5.0 * matrix / std::sqrt(chords));
  for (int k = 0; k <= lags.Count; ++k)
  {
    const double low = std::min(std::max(k - 0.5, 0.0) * lags.Spacing, 2.0 * a);
    const double high = std::min((k + 0.5) * lags.Spacing, 2.0 * a);
    const double width = (k == 0 ? 0.5 : 1.0) * lags.Spacing;
    const double density = (high * high - low * low) / (4.0 * a * a) / width;
    // The mean over the bin is weighted by the length that lines have left, a slope of 1 / (l - z)
    // against one of 1 / z: (0.15)^2 / 12 / (4 z) of z at most
    const double weighting = 0.15 * 0.15 / 12.0 / 4.0;
    EXPECT_NEAR(lengths.Density[0][k], density,
      4.0 * std::hypot(lengths.DensityError[0][k], density / std::sqrt(chords)) + weighting)
      << k;
    EXPECT_LT(lengths.DensityError[0][k], 0.05);
    // Lineal path of spheres: (chords per length) x mean of (c - z)+
    const double z = std::min(k * lags.Spacing, 2.0 * a);
    const double path = perLength *
      (4.0 / 3.0 * a - z +
        z * z * z / (12.0 * a * a)); // integral of (c - z) c / (2 a^2) from z to 2 a
    EXPECT_NEAR(lengths.LinealPath[0][k], path, 4.0 * lengths.LinealPathError[0][k] + 1e-12);
    EXPECT_LT(lengths.LinealPathError[0][k], 0.01);
  }
}

TEST(ChordLengths, ShortLinesAreCorrectedFor)
{
  const OneThread alone;
  // The chords of the same spheres, seen through windows hardly longer than they are
  const Window cube = oracle::PeriodicCube(6.0);
  constexpr double a = 0.7;
  const SpherePack pack = oracle::WithImages(oracle::RelaxedPack({ 45 }, { a }, cube, 2), 6.0);
  const LagGrid lags = { 0.2, 8 };
  MeanFunction density(lags.Count + 1), path(lags.Count + 1);
  MeanFunction chord(1);
  oracle::Uniform random(5);
  for (int n = 1; n <= 60; ++n)
  {
    const SamplingRegion region(
      Window::MakeBox({ random(0, 6) - 3, random(0, 6) - 3, random(0, 6) - 3 }, { 2.5, 2.5, 2.5 },
        { false, false, false }),
      0.0);
    const ChordLengths lengths = Measured(pack, 1, region, lags, 640, n);
    // Weighted by what a window holds, so that the mean of the ratios is that of the medium
    std::vector<double> numbers = lengths.Density[0];
    const double perLength = lengths.LinealPath[0][0] / lengths.MeanChord[0];
    for (double& number : numbers)
    {
      number *= perLength;
    }
    density.Add(numbers);
    path.Add(lengths.LinealPath[0]);
    chord.Add({ perLength });
  }
  const double perLength = 45.0 / 216.0 * Pi * a * a;
  EXPECT_NEAR(chord.Value(0), perLength, 4.0 * chord.Error(0));
  for (int k = 0; k <= lags.Count; ++k)
  {
    const double low = std::min(std::max(k - 0.5, 0.0) * lags.Spacing, 2.0 * a);
    const double high = std::min((k + 0.5) * lags.Spacing, 2.0 * a);
    const double expected =
      perLength * (high * high - low * low) / (4.0 * a * a) / ((k == 0 ? 0.5 : 1.0) * lags.Spacing);
    // The bin's mean is weighted by the length left, mostly above 1: 0.2^2 / 12
    EXPECT_NEAR(density.Value(k), expected, 4.0 * density.Error(k) + perLength * 0.2 * 0.2 / 12.0)
      << k;
    const double z = std::min(k * lags.Spacing, 2.0 * a);
    EXPECT_NEAR(path.Value(k), perLength * (4.0 / 3.0 * a - z + z * z * z / (12.0 * a * a)),
      4.0 * path.Error(k) + 1e-12)
      << k;
  }
}

TEST(ChordLengths, LinealPathOfTheBooleanModel)
{
  const OneThread alone;
  // The segment misses all N centres' spheres: (1 - (4/3 pi a^3 + pi a^2 z) / V)^N, as in
  // ExpectBooleanModel
  constexpr double a = 0.7, edge = 5.0;
  constexpr int spheres = 60;
  const LagGrid lags = { 0.3, 8 };
  const Window box = oracle::PeriodicCube(edge);
  MeanFunction mean(lags.Count + 1);
  for (int n = 1; n <= 40; ++n)
  {
    const SpherePack pack = oracle::RandomPack({ spheres }, { a }, box, 100 + n);
    mean.Add(Measured(pack, 1, SamplingRegion(box, 0.0), lags, 640, n).LinealPath[1]);
  }
  for (int k = 0; k <= lags.Count; ++k)
  {
    const double swept = 4.0 / 3.0 * Pi * a * a * a + Pi * a * a * k * lags.Spacing;
    EXPECT_NEAR(
      mean.Value(k), std::pow(1.0 - swept / std::pow(edge, 3), spheres), 4.0 * mean.Error(k))
      << k;
  }
}

TEST(ChordLengths, RanksGiveEqualResults)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 5, 6, 7 }, { true, true, true });
  const SpherePack pack = oracle::RandomPack({ 15, 40 }, { 0.9, 0.5 }, box, 3);
  const SamplingRegion region(box, 0.0);
  const LagGrid lags = { 0.3, 12 };
  const ChordLengths expected = Measured(pack, 2, region, lags, 500);
  for (int size : { 2, 3 })
  {
    std::vector<SpherePack> shares(size);
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      shares[i % 5 == 0 ? 0 : size - 1].Append(pack, i);
    }
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        ChordLengths lengths;
        ruc::SampleChords(
          shares[ranks.Rank()], 2, region, lags, { 1, 500, 0.0 }, ranks, {}, &lengths);
        EXPECT_EQ(lengths.Density, expected.Density);
        EXPECT_EQ(lengths.DensityError, expected.DensityError);
        EXPECT_EQ(lengths.LinealPath, expected.LinealPath);
        EXPECT_EQ(lengths.LinealPathError, expected.LinealPathError);
        EXPECT_EQ(lengths.MeanChord, expected.MeanChord);
      });
  }
}

TEST(ChordLengths, OfAPhaseWithoutEndsAreNotNumbers)
{
  const ChordLengths lengths =
    Measured({}, 1, SamplingRegion(oracle::PeriodicCube(2.0), 0.0), { 0.5, 2 }, 10);
  EXPECT_TRUE(std::isnan(lengths.MeanChord[0]));
  EXPECT_TRUE(std::isnan(lengths.Density[1][1]));
  EXPECT_EQ(lengths.LinealPath[0], std::vector<double>(3, 0.0));
  EXPECT_EQ(lengths.LinealPath[1], std::vector<double>(3, 1.0));
}
