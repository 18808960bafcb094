// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanSampling.h"

#include "Oracles.h"
#include "Statistics/Sampling/FanMedia.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Tracing/RayFan.h"

namespace
{
using namespace fans;
using oracle::Pi;
using ruc::Vector3;

// The lowest mode at a point, by the distance to all spheres and images; -1 outside the region
int PhaseAt(const SpherePack& pack, int modes, const SamplingRegion& region, const Vector3& point)
{
  const Window& box = region.GetBounds();
  if (!region.IsFullyPeriodic() && !region.Contains(point))
  {
    return -1;
  }
  int lowest = modes;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    double distance2 = 0.0;
    for (int q = 0; q < 3; ++q)
    {
      double d = point[q] - pack.Centre(i)[q];
      d -= box.Periodic[q] ? box.Size[q] * std::round(d / box.Size[q]) : 0.0;
      distance2 += d * d;
    }
    if (distance2 < pack.Radius[i] * pack.Radius[i])
    {
      lowest = std::min(lowest, pack.Mode[i] - 1);
    }
  }
  return lowest;
}

// What the template counts for a triple: N_b and D_b of every throw
struct PlainCounts
{
  std::vector<std::vector<std::int64_t>> Found, Inside;

  double Sum(const std::vector<std::vector<std::int64_t>>& numbers, std::size_t place) const
  {
    std::int64_t sum = 0;
    for (const std::vector<std::int64_t>& number : numbers)
    {
      sum += number[place];
    }
    return static_cast<double>(sum);
  }
};

// Phases of all points of the throws: phases[throw][ray][k]
using Points = std::vector<std::vector<std::vector<int>>>;

Points LookUpPoints(const SpherePack& pack, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const FanSettings& settings)
{
  Points points(settings.Throws);
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const ruc::RayFan fan =
      ruc::RayFan::Random(region, settings.Seed, static_cast<std::uint32_t>(n));
    points[n].resize(grid.Directions);
    for (int ray = 0; ray < grid.Directions; ++ray)
    {
      const double angle = 2.0 * Pi * ray / grid.Directions;
      for (int k = 0; k < grid.Points(); ++k)
      {
        Vector3 point = fan.Centre;
        for (int q = 0; q < 3; ++q)
        {
          point[q] +=
            k * grid.Lags.Spacing * (std::cos(angle) * fan.U[q] + std::sin(angle) * fan.V[q]);
        }
        points[n][ray].push_back(PhaseAt(pack, modes, region, point));
      }
    }
  }
  return points;
}

// All pairs of rays and all K^2 pairs of points
PlainCounts CountPlainly(
  const Points& points, const ThreePointGrid& grid, const PhaseTriple& triple)
{
  PlainCounts counts;
  for (const std::vector<std::vector<int>>& rays : points)
  {
    std::vector<std::int64_t> found(grid.Size(), 0), inside(grid.Size(), 0);
    for (int i = 0; i < grid.Directions; ++i)
    {
      for (int j = 0; j < grid.Directions; ++j)
      {
        const int apart = std::abs(i - j), t = std::min(apart, grid.Directions - apart);
        for (int k2 = 0; k2 < grid.Points(); ++k2)
        {
          for (int k1 = 0; k1 < grid.Points(); ++k1)
          {
            const int r = rays[0][0], s = rays[i][k1], q = rays[j][k2];
            const std::size_t place = grid.PlaceOf(k1, k2, t);
            inside[place] += s >= 0 && q >= 0;
            found[place] += r == triple.R && s == triple.S && q == triple.Q;
          }
        }
      }
    }
    counts.Found.push_back(std::move(found));
    counts.Inside.push_back(std::move(inside));
  }
  return counts;
}
}

TEST(FanSampling, CountsWhatTheTripleLoopCounts)
{
  for (const Medium& medium : Media())
  {
    for (const int directions : { 2, 3, 7, 8 })
    {
      const ThreePointGrid grid = { { medium.Spacing, 6 }, directions };
      const FanSettings settings = { 4, 150, false };
      const Points points = LookUpPoints(medium.Pack, 2, medium.Region, grid, settings);
      // With and without errors tables are summed up in different ways
      const ThreePointProbability plain =
        Fans(medium.Pack, 2, medium.Region, grid, Triples, settings);
      const ThreePointProbability withErrors =
        Fans(medium.Pack, 2, medium.Region, grid, Triples, { 4, 150, true });
      EXPECT_EQ(plain.GetTriples(), Triples);
      EXPECT_EQ(plain.GetThrows(), 150);
      EXPECT_EQ(plain.GetModes(), 2);
      EXPECT_FALSE(plain.HasErrors());
      EXPECT_TRUE(withErrors.HasErrors());
      double greatest = 0.0;
      for (std::size_t n = 0; n < Triples.size(); ++n)
      {
        const PlainCounts counts = CountPlainly(points, grid, Triples[n]);
        ForEachPlace(grid,
          [&](int k1, int k2, int t)
          {
            const std::size_t place = grid.PlaceOf(k1, k2, t);
            const double expected =
              counts.Sum(counts.Found, place) / counts.Sum(counts.Inside, place);
            ExpectSame(plain.Value(n, k1, k2, t), expected, medium.Name, n, place);
            ExpectSame(withErrors.Value(n, k1, k2, t), expected, medium.Name, n, place);
            EXPECT_TRUE(std::isnan(plain.Error(n, k1, k2, t)));
            greatest = std::max(greatest, expected);
          });
      }
      EXPECT_GT(greatest, 0.2);
    }
  }
}

TEST(FanSampling, ErrorsAreTheScatterOfBatches)
{
  // Up to 64 throws are batches of their own, so that the standard error of the ratio is known
  for (const Medium& medium : Media())
  {
    const ThreePointGrid grid = { { medium.Spacing, 4 }, 6 };
    const FanSettings settings = { 8, 60, true };
    const Points points = LookUpPoints(medium.Pack, 2, medium.Region, grid, settings);
    const ThreePointProbability sampled =
      Fans(medium.Pack, 2, medium.Region, grid, Triples, settings);
    for (std::size_t n = 0; n < Triples.size(); ++n)
    {
      const PlainCounts counts = CountPlainly(points, grid, Triples[n]);
      ForEachPlace(grid,
        [&](int k1, int k2, int t)
        {
          const std::size_t place = grid.PlaceOf(k1, k2, t);
          const double all = counts.Sum(counts.Inside, place);
          const double ratio = counts.Sum(counts.Found, place) / all;
          double squares = 0.0;
          for (std::size_t b = 0; b < counts.Found.size(); ++b)
          {
            squares += std::pow(counts.Found[b][place] - ratio * counts.Inside[b][place], 2);
          }
          // Sums of squares up to 60 x 12^2 that cancel lose 1e-12 of them, half as many digits
          // under the root
          const double expected = std::sqrt(squares * 60.0 / 59.0) / all;
          EXPECT_NEAR(sampled.Error(n, k1, k2, t), expected, 1e-6 / all + 1e-12)
            << medium.Name << " " << n << " " << place;
        });
    }
  }
}

TEST(FanSampling, LagsLongerThanAPeriodicBox)
{
  // Four edges: three images on either side
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 2.1, 2.6, 3.4 }, { true, true, true });
  const SamplingRegion region(box, 0.0);
  const SpherePack pack = oracle::RandomPack({ 1, 8 }, { 1.0, 0.3 }, box, 2);
  const ThreePointGrid grid = { { 0.7, 12 }, 5 };
  EXPECT_DOUBLE_EQ(ruc::LagLimit::ForFans(box, region.GetShape()).Largest, grid.Lags.Maximum());
  const FanSettings settings = { 1, 100, false };
  const ThreePointProbability sampled = Fans(pack, 2, region, grid, Triples, settings);
  const Points points = LookUpPoints(pack, 2, region, grid, settings);
  for (std::size_t n = 0; n < Triples.size(); ++n)
  {
    const PlainCounts counts = CountPlainly(points, grid, Triples[n]);
    ForEachPlace(grid,
      [&](int k1, int k2, int t)
      {
        const std::size_t place = grid.PlaceOf(k1, k2, t);
        ExpectSame(sampled.Value(n, k1, k2, t),
          counts.Sum(counts.Found, place) / counts.Sum(counts.Inside, place), "periodic", n, place);
      });
  }
}

TEST(FanSampling, RefusesBadInput)
{
  const SpherePack none;
  const SamplingRegion periodic(oracle::PeriodicCube(2.0), 0.0);
  const SamplingRegion box(Window::MakeBox({ 0, 0, 0 }, { 4, 5, 7 }, { false, true, false }), 0.5);
  const auto sample =
    [&](const SamplingRegion& region, double spacing, int lags, int directions, std::int64_t throws)
  {
    Fans(none, 1, region, { { spacing, lags }, directions }, { { 0, 0, 0 } }, { 1, throws, false });
  };
  EXPECT_SAYS(Fans(none, 1, periodic, { { 1.0, 2 }, 8 }, { { 0, 0, 0 } }, { 1, 1, true }),
    "NumberOfThrows requires a number >= 2, without which no standard error is known, got 1.");
  EXPECT_SAYS(sample(periodic, 1.0, 2, 8, 0),
    "NumberOfThrows requires a number from 1 to 2147483648, got 0.");
  EXPECT_SAYS(sample(periodic, 1.0, 2, 8, -5), "NumberOfThrows requires");
  EXPECT_SAYS(sample(periodic, 1.0, 2, 8, (std::int64_t(1) << 31) + 1),
    "NumberOfThrows requires a number from 1 to 2147483648, got 2147483649.");
  EXPECT_SAYS(
    sample(periodic, 1.0, 2, 1, 10), "NumberOfDirections requires a number from 2 to 512, got 1.");
  EXPECT_SAYS(sample(periodic, 1.0, 2, 513, 10),
    "NumberOfDirections requires a number from 2 to 512, got 513.");
  EXPECT_SAYS(
    sample(periodic, 1.0, 0, 8, 10), "NumberOfLags requires a number from 1 to 20000, got 0.");
  EXPECT_SAYS(sample(periodic, 1e-5, 20001, 8, 10),
    "NumberOfLags requires a number from 1 to 20000, got 20001.");
  EXPECT_SAYS(
    sample(periodic, 4.01, 2, 8, 10), "MaximumLag requires 0 < MaximumLag <= 8, got 8.02.");
  EXPECT_SAYS(
    sample(box, 0.75, 2, 8, 10), "MaximumLag requires 0 < MaximumLag <= 1.4985, got 1.5.");
  EXPECT_SAYS(sample(periodic, NAN, 2, 8, 10), "MaximumLag requires 0 < MaximumLag <= 8, got nan.");
  EXPECT_SAYS(sample(periodic, INFINITY, 2, 8, 10), "got inf.");
  EXPECT_SAYS(sample(periodic, 0.0, 2, 8, 10), "got 0.");
  EXPECT_SAYS(sample(periodic, -1.0, 2, 8, 10), "got -2.");
  // The limits themselves are allowed
  EXPECT_EQ(oracle::MessageOf([&]() { sample(periodic, 4.0, 2, 2, 1); }), "<no exception>");
  EXPECT_EQ(oracle::MessageOf([&]() { sample(periodic, 4.0, 2, 512, 1); }), "<no exception>");
  EXPECT_EQ(oracle::MessageOf([&]() { sample(box, 0.74925, 2, 8, 1); }), "<no exception>");
}
