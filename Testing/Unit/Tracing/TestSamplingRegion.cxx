// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/SamplingRegion.h"

#include "Oracles.h"

namespace
{
using oracle::Mean;
using oracle::Pi;
using ruc::LineBundle;
using ruc::SampleLine;
using ruc::SamplingRegion;
using ruc::Vector3;
using ruc::VoxelMask;
using ruc::Window;

const Window Box = Window::MakeBox({ -1, 2, 3 }, { 4.0, 5.0, 7.0 }, { false, false, false });
const Window Cylinder = Window::MakeCylinder({ 1, 2, 3 }, { 1, -2, 0.5 }, 2.0, 5.0);

// Expects a mean within 4 standard errors; with some 40 such comparisons in this file, one fails in
// 400 seeds
void ExpectMean(const Mean& mean, double expected)
{
  EXPECT_NEAR(mean.Value(), expected, 4.0 * mean.Error());
}

double LengthOf(const SampleLine& line)
{
  double length = 0.0;
  for (const ruc::LineInterval& interval : line.Inside)
  {
    length += interval.End - interval.Begin;
  }
  return length;
}
}

TEST(SamplingRegion, RefusesBadInput)
{
  EXPECT_SAYS(SamplingRegion(Box, 2.0),
    "The window requires room for a margin of 2 along its border, got a box window 4 x 5 x 7.");
  EXPECT_SAYS(SamplingRegion(Cylinder, 2.0), "got a cylinder window of radius 2 and height 5.");
  EXPECT_SAYS(SamplingRegion(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 5.0, 2.0), 1.0),
    "The window requires room");
  EXPECT_SAYS(SamplingRegion(Box, -1.0), "Margin requires a finite number >= 0, got -1.");
  EXPECT_SAYS(SamplingRegion(Box, NAN), "Margin requires");
  const VoxelMask mask({ 2, 2, 2 }, { 0, 0, 0 }, { 1, 1, 1 }, std::vector<std::uint8_t>(8, 1));
  EXPECT_SAYS(SamplingRegion(mask, 3.0), "The mask requires inside voxels at least 3 from");
  EXPECT_SAYS(SamplingRegion(mask, -3.0), "Margin requires");
}

TEST(SamplingRegion, ShrinksByItsMargin)
{
  const SamplingRegion box(Box, 0.5);
  EXPECT_DOUBLE_EQ(box.Volume(), 3.0 * 4.0 * 6.0);
  EXPECT_DOUBLE_EQ(box.GetShape().ShortestEdge(), 3.0);
  EXPECT_TRUE(box.Contains({ -0.5, 2.5, 3.5 }));
  EXPECT_FALSE(box.Contains({ -0.6, 2.5, 3.5 }));

  const SamplingRegion cylinder(Cylinder, 0.5);
  EXPECT_DOUBLE_EQ(cylinder.Volume(), Pi * 1.5 * 1.5 * 4.0);
  EXPECT_DOUBLE_EQ(cylinder.GetShape().ShortestEdge(), 3.0);

  const SamplingRegion partly(
    Window::MakeBox({ 0, 0, 0 }, { 4, 5, 7 }, { true, false, false }), 0.5);
  EXPECT_DOUBLE_EQ(partly.Volume(), 4.0 * 4.0 * 6.0);
  EXPECT_FALSE(partly.IsFullyPeriodic());
  EXPECT_TRUE(partly.GetBounds().Periodic[0]);

  const SamplingRegion periodic(oracle::PeriodicCube(3.0), 2.0);
  EXPECT_DOUBLE_EQ(periodic.Volume(), 27.0);
  EXPECT_DOUBLE_EQ(periodic.GetShape().ShortestEdge(), 3.0);
  EXPECT_TRUE(periodic.IsFullyPeriodic());

  const SamplingRegion mask(
    VoxelMask({ 8, 8, 9 }, { 0, 0, 0 }, { 1, 1, 1 }, std::vector<std::uint8_t>(8 * 8 * 9, 1)), 2.0);
  EXPECT_DOUBLE_EQ(mask.Volume(), 4.0 * 4.0 * 5.0);
  EXPECT_DOUBLE_EQ(mask.GetShape().ShortestEdge(), 4.0);
}

TEST(SamplingRegion, PointsAreUniform)
{
  Mean x, xx, xy;
  const SamplingRegion box(Box, 0.0);
  for (std::uint32_t n = 0; n < 20000; ++n)
  {
    const Vector3 p = box.RandomPoint(5, n);
    ASSERT_TRUE(box.Contains(p));
    x.Add((p[0] + 1.0) / 4.0);
    xx.Add(std::pow((p[2] - 3.0) / 7.0, 2));
    xy.Add((p[0] + 1.0) / 4.0 * (p[1] - 2.0) / 5.0);
  }
  ExpectMean(x, 0.5);
  ExpectMean(xx, 1.0 / 3.0);
  ExpectMean(xy, 0.25);

  // In a cylinder height and squared lateral distance are uniform
  const SamplingRegion cylinder(Cylinder, 0.0);
  Mean height, lateral2;
  for (std::uint32_t n = 0; n < 20000; ++n)
  {
    const Vector3 p = cylinder.RandomPoint(5, n);
    double along = 0.0, distance2 = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      along += (p[q] - Cylinder.Base[q]) * Cylinder.Axis[q];
      distance2 += std::pow(p[q] - Cylinder.Base[q], 2);
    }
    height.Add(along / 5.0);
    lateral2.Add((distance2 - along * along) / 4.0);
  }
  ExpectMean(height, 0.5);
  ExpectMean(lateral2, 0.5);
}

TEST(SamplingRegion, DirectionsAreIsotropic)
{
  Mean square[3], mixed[3], single[3], turn;
  for (std::uint32_t n = 0; n < 20000; ++n)
  {
    const Vector3 d = SamplingRegion::RandomDirection(2, n);
    ASSERT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1.0, 1e-14);
    for (int q = 0; q < 3; ++q)
    {
      single[q].Add(d[q]);
      square[q].Add(d[q] * d[q]);
      mixed[q].Add(d[q] * d[(q + 1) % 3]);
    }
    turn.Add(SamplingRegion::RandomTurn(2, n));
  }
  for (int q = 0; q < 3; ++q)
  {
    ExpectMean(single[q], 0.0);
    ExpectMean(square[q], 1.0 / 3.0);
    ExpectMean(mixed[q], 0.0);
  }
  ExpectMean(turn, 0.5);
}

namespace
{
// The lines of so many samples in a region of this surface: by Cauchy the mean projected area is a
// quarter of it, the mean number of lines as asked for, and the mean chord 4 V / S. A grid covers
// every place alike, so the integral of x^2 over the lines is that over the volume.
void ExpectCoverage(const SamplingRegion& region, double surface, double meanSquareOfX)
{
  constexpr double number = 7.0;
  Mean lines, length, square, direction[3];
  for (std::uint32_t n = 0; n < 6000; ++n)
  {
    const LineBundle bundle = region.ParallelLines(3, n, number, 1.0);
    lines.Add(static_cast<double>(bundle.Lines.size()));
    EXPECT_LE(bundle.Lines.size(), region.MostLines(number));
    double total = 0.0, integral = 0.0;
    for (const SampleLine& line : bundle.Lines)
    {
      EXPECT_LE(line.Inside.back().End, region.LongestLine(1.0));
      for (const ruc::LineInterval& in : line.Inside)
      {
        total += in.End - in.Begin;
        // Simpson's rule is exact for squares
        const double x0 = line.Start[0] + in.Begin * bundle.Direction[0];
        const double x1 = line.Start[0] + in.End * bundle.Direction[0];
        integral += (in.End - in.Begin) / 3.0 * (x0 * x0 + x0 * x1 + x1 * x1);
      }
    }
    length.Add(total);
    square.Add(integral);
    for (int q = 0; q < 3; ++q)
    {
      direction[q].Add(bundle.Direction[q] * bundle.Direction[q]);
    }
  }
  const double lengthPerVolume = number / (0.25 * surface);
  ExpectMean(lines, number);
  ExpectMean(length, region.Volume() * lengthPerVolume);
  ExpectMean(square, meanSquareOfX * region.Volume() * lengthPerVolume);
  for (const Mean& mean : direction)
  {
    ExpectMean(mean, 1.0 / 3.0);
  }
}
}

TEST(SamplingRegion, ParallelLinesCoverEveryPlaceAlike)
{
  // x in [-1, 3]
  ExpectCoverage(SamplingRegion(Box, 0.0), 2.0 * (20.0 + 28.0 + 35.0), (27.0 + 1.0) / 12.0);
  // Upright, around x = 1, y = 0: mean of (x - 1)^2 is R^2 / 4
  ExpectCoverage(SamplingRegion(Window::MakeCylinder({ 1, 0, 3 }, { 0, 0, 1 }, 2.0, 5.0), 0.0),
    2.0 * Pi * 4.0 + 2.0 * Pi * 2.0 * 5.0, 1.0 + 1.0);

  // Along one direction the number is in proportion to the projected area
  const SamplingRegion box(Box, 0.0);
  const Vector3 direction = { 2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0 };
  Mean lines;
  for (std::uint32_t n = 0; n < 4000; ++n)
  {
    const LineBundle bundle = box.ParallelLinesAlong(direction, 7, 3, n, 9.0, 1.0);
    EXPECT_EQ(bundle.Direction, direction);
    lines.Add(static_cast<double>(bundle.Lines.size()));
  }
  ExpectMean(lines, 9.0 * ((2.0 * 35.0 + 28.0 + 2.0 * 20.0) / 3.0) / (0.5 * (35.0 + 28.0 + 20.0)));
}

// Every place of the lattice is tried, far beyond the disc around the region
TEST(SamplingRegion, NoParallelLineIsMissed)
{
  for (const Vector3& size : { Vector3{ 4, 5, 7 }, { 300, 2, 3 }, { 1, 200, 200 } })
  {
    const SamplingRegion box(Window::MakeBox({ -1, 2, 3 }, size, { false, false, false }), 0.25);
    for (std::uint32_t n = 0; n < 30; ++n)
    {
      const LineBundle bundle = n == 0 ? box.ParallelLinesAlong({ 0, 1, 0 }, 0, 1, n, 30.0, 1.0)
                                       : box.ParallelLines(2, n, 30.0, 1.0);
      std::size_t lines = 0;
      std::vector<ruc::LineInterval> inside;
      for (int i = -200; i <= 200; ++i)
      {
        for (int j = -200; j <= 200; ++j)
        {
          box.Clip(bundle.StartOf(i, j), bundle.Direction, 1000.0, inside);
          lines += !inside.empty();
        }
      }
      EXPECT_EQ(bundle.Lines.size(), lines);
    }
  }
}

TEST(SamplingRegion, LinesAreCutWherePointsLeaveIt)
{
  oracle::Uniform random(12);
  for (const Window& window : { Box, Cylinder })
  {
    const SamplingRegion region(window, 0.3);
    for (std::uint32_t n = 0; n < 50; ++n)
    {
      const LineBundle bundle = region.ParallelLines(1, n, 10.0, 1.0);
      for (const SampleLine& line : bundle.Lines)
      {
        ASSERT_EQ(line.Inside.size(), 1u);
        for (int k = 0; k < 20; ++k)
        {
          const double t = random(0.0, region.LongestLine(1.0));
          const Vector3 p = { line.Start[0] + t * bundle.Direction[0],
            line.Start[1] + t * bundle.Direction[1], line.Start[2] + t * bundle.Direction[2] };
          const ruc::LineInterval in = line.Inside[0];
          const bool near = std::abs(t - in.Begin) < 1e-9 || std::abs(t - in.End) < 1e-9;
          EXPECT_TRUE(near || region.Contains(p) == (t > in.Begin && t < in.End));
        }
      }
    }
  }
  // Straight along the axis of an upright cylinder
  const SamplingRegion upright(Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 1.0, 3.0), 0.0);
  const LineBundle bundle = upright.ParallelLinesAlong({ 0, 0, 1 }, 0, 1, 0, 50.0, 1.0);
  ASSERT_FALSE(bundle.Lines.empty());
  EXPECT_DOUBLE_EQ(LengthOf(bundle.Lines[0]), 3.0);
}

TEST(SamplingRegion, AMaskOfABoxDrawsTheLinesOfTheBox)
{
  // Steps of a quarter are exact, so both have the same bounds and draw the same numbers
  const SamplingRegion box(Box, 0.5);
  const SamplingRegion mask(VoxelMask({ 16, 20, 28 }, { -1, 2, 3 }, { 0.25, 0.25, 0.25 },
                              std::vector<std::uint8_t>(16 * 20 * 28, 1)),
    0.5);
  for (std::uint32_t n = 0; n < 100; ++n)
  {
    const LineBundle a = box.ParallelLines(8, n, 10.0, 1.0);
    const LineBundle b = mask.ParallelLines(8, n, 10.0, 1.0);
    ASSERT_EQ(a.Lines.size(), b.Lines.size());
    for (std::size_t k = 0; k < a.Lines.size(); ++k)
    {
      ASSERT_EQ(b.Lines[k].Inside.size(), 1u);
      EXPECT_NEAR(a.Lines[k].Inside[0].Begin, b.Lines[k].Inside[0].Begin, 1e-12);
      EXPECT_NEAR(a.Lines[k].Inside[0].End, b.Lines[k].Inside[0].End, 1e-12);
    }
    EXPECT_EQ(box.RandomPoint(8, n), mask.RandomPoint(8, n));
  }
}

TEST(SamplingRegion, PeriodicLinesPassThroughTheBoxOnceAndThenTheLag)
{
  const SamplingRegion region(
    Window::MakeBox({ 1, 0, 0 }, { 3.0, 4.0, 5.0 }, { true, true, true }), 0.0);
  Mean turn, same;
  for (std::uint32_t n = 0; n < 4000; ++n)
  {
    const LineBundle bundle = region.ParallelLines(1, n, 6.0, 5.0);
    EXPECT_LE(bundle.Lines.size(), region.MostLines(6.0));
    const Vector3& d = bundle.Direction;
    const double passage = std::min(
      { 3.0 / std::abs(d[0]), 4.0 / std::abs(d[1]), 5.0 / std::abs(d[2]), std::sqrt(3.0) * 5.0 });
    for (const SampleLine& line : bundle.Lines)
    {
      ASSERT_EQ(line.Inside.size(), 1u);
      EXPECT_EQ(line.Inside[0].Begin, 0.0);
      EXPECT_GE(line.Inside[0].End, passage + 5.0 - 1e-12);
      EXPECT_LE(line.Inside[0].End, region.LongestLine(5.0));
    }
    turn.Add(d[2] * d[2]);
    // Lines and points share no numbers
    same.Add(d[1] * (region.RandomPoint(1, n)[1] - 2.0));
  }
  ExpectMean(turn, 1.0 / 3.0);
  ExpectMean(same, 0.0);
}

// By chance only one point in some ten million would meet them
TEST(SamplingRegion, PointsOfARegionThatFillsLittleOfItsBounds)
{
  const int n = 200;
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(n) * n * n, 0);
  inside.front() = inside[n / 2] = inside.back() = 1;
  const SamplingRegion mask(VoxelMask({ n, n, n }, { 1, 2, 3 }, { 0.5, 0.25, 1.0 }, inside), 0.0);
  Mean x, y, z, first;
  const Window thin = Window::MakeCylinder({ 1, 2, 3 }, { 1, 1, 1 }, 1e-3, 10.0);
  const SamplingRegion cylinder(thin, 0.0);
  Mean along, square;
  for (int sample = 0; sample < 20000; ++sample)
  {
    const Vector3 p = mask.RandomPoint(3, sample);
    EXPECT_TRUE(mask.Contains(p));
    first.Add(p[0] < 1.5);
    x.Add((p[0] - 1.0) / 0.5 - std::floor((p[0] - 1.0) / 0.5));
    y.Add((p[1] - 2.0) / 0.25 - std::floor((p[1] - 2.0) / 0.25));
    z.Add(p[2] - std::floor(p[2]));

    const Vector3 c = cylinder.RandomPoint(3, sample);
    EXPECT_TRUE(thin.Contains(c));
    const Vector3 d = { c[0] - 1.0, c[1] - 2.0, c[2] - 3.0 };
    const double t = (d[0] + d[1] + d[2]) / std::sqrt(3.0);
    along.Add(t);
    square.Add((d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - t * t) * 1e6);
  }
  ExpectMean(first, 1.0 / 3.0); // one voxel of three
  ExpectMean(x, 0.5);
  ExpectMean(y, 0.5);
  ExpectMean(z, 0.5);
  ExpectMean(along, 5.0);
  ExpectMean(square, 0.5); // of a disc of radius 1
}
