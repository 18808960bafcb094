// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanSampling.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include "Oracles.h"
#include "SampledComparison.h"
#include "ruc/Tracing/RayFan.h"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#include <malloc.h>
#endif

namespace
{
using oracle::Pi;
using ruc::FanSettings;
using ruc::PhaseTriple;
using ruc::SamplingRegion;
using ruc::SpherePack;
using ruc::ThreePointGrid;
using ruc::ThreePointProbability;
using ruc::Vector3;
using ruc::Window;

ThreePointProbability Fans(const SpherePack& pack, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples, const FanSettings& settings)
{
  const OneThread alone;
  ruc::Communicator serial;
  return ruc::SampleFans(pack, modes, region, grid, triples, settings, serial);
}

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

// What the template counts of a triple: N_b and D_b of every throw
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

void ExpectSame(double a, double b, const char* what, std::size_t triple, std::size_t place)
{
  EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
    << what << " of triple " << triple << " at " << place << ": " << a << " and " << b;
}

template <class Visit>
void ForEachPlace(const ThreePointGrid& grid, Visit&& visit)
{
  for (int t = 0; t < grid.Angles(); ++t)
  {
    for (int k2 = 0; k2 < grid.Points(); ++k2)
    {
      for (int k1 = 0; k1 < grid.Points(); ++k1)
      {
        visit(k1, k2, t);
      }
    }
  }
}

struct Medium
{
  const char* Name;
  SpherePack Pack;
  SamplingRegion Region;
  double Spacing;
};

// Overlapping spheres of two modes in regions of all kinds
std::vector<Medium> Media()
{
  const Window periodic = Window::MakeBox({ -1, 2, 3 }, { 4, 5, 4.5 }, { true, true, true });
  const Window partly = Window::MakeBox({ -1, 2, 3 }, { 4, 5, 6 }, { true, false, true });
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 5, 6, 5.5 }, { false, false, false });
  const Window cylinder = Window::MakeCylinder({ 2, 2, 1 }, { 0.3, -1, 2 }, 2.2, 4.0);
  const Window around = Window::MakeBox({ -2, -2, -2 }, { 9, 9, 9 }, { false, false, false });
  std::vector<std::uint8_t> inside(6 * 6 * 6, 1);
  inside[2 + 6 * (3 + 6 * 2)] = inside[5] = inside[4] = inside[3 + 6 * (3 + 6 * 3)] = 0;
  return { { "periodic", oracle::RandomPack({ 12, 25 }, { 0.9, 0.5 }, periodic, 1),
             SamplingRegion(periodic, 0.0), 0.9 },
    { "partly periodic", oracle::RandomPack({ 12, 25 }, { 0.9, 0.5 }, partly, 2),
      SamplingRegion(partly, 0.3), 0.31 },
    { "box", oracle::RandomPack({ 12, 25 }, { 0.9, 0.5 }, box, 3), SamplingRegion(box, 0.5), 0.29 },
    { "cylinder", oracle::RandomPack({ 40, 90 }, { 0.9, 0.5 }, around, 4),
      SamplingRegion(cylinder, 0.0), 0.3 },
    { "mask", oracle::RandomPack({ 40, 90 }, { 0.9, 0.5 }, around, 5),
      SamplingRegion(ruc::VoxelMask({ 6, 6, 6 }, { 0, 0, 0 }, { 0.8, 0.9, 1.0 }, inside), 0.0),
      0.33 },
    { "empty", SpherePack(), SamplingRegion(periodic, 0.0), 0.5 } };
}

const std::vector<PhaseTriple> Triples = { { 0, 0, 0 }, { 2, 2, 2 }, { 0, 1, 2 }, { 1, 2, 0 },
  { 1, 0, 2 }, { 2, 1, 1 }, { 0, 2, 1 } };
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

TEST(FanSampling, BooleanModel)
{
  // N spheres at random in a periodic cube: in the mean over realisations S_mmm = (1 - V_union /
  // V)^N, which tends to exp(-rho V_union). The scatter of the realisations, each sampled anew, is
  // the standard error. Some 200 numbers: 4.5 standard errors.
  constexpr int realisations = 60, spheres = 60;
  constexpr double a = 0.7, edge = 5.0;
  const ThreePointGrid grid = { { 0.4, 5 }, 10 }; // the triangle's sides up to edge - 2 a: 3.6
  const SamplingRegion region(oracle::PeriodicCube(edge), 0.0);
  MeanFunction mean(grid.Size());
  for (int n = 1; n <= realisations; ++n)
  {
    const SpherePack pack = oracle::RandomPack({ spheres }, { a }, region.GetBounds(), 100 + n);
    const ThreePointProbability sampled =
      Fans(pack, 1, region, grid, { { 1, 1, 1 } }, { static_cast<std::uint32_t>(n), 640, false });
    std::vector<double> values;
    ForEachPlace(
      grid, [&](int k1, int k2, int t) { values.push_back(sampled.Value(0, k1, k2, t)); });
    mean.Add(values);
  }
  int compared = 0;
  ForEachPlace(grid,
    [&](int k1, int k2, int t)
    {
      const double r1 = 0.4 * k1, r2 = 0.4 * k2, theta = Pi * t / 5.0;
      if (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * std::cos(theta) > 3.6 * 3.6)
      {
        return; // the third side meets an image
      }
      const auto place = static_cast<int>(grid.PlaceOf(k1, k2, t));
      const double expected =
        std::pow(1.0 - oracle::UnionOfThree(a, r1, r2, theta) / std::pow(edge, 3), spheres);
      EXPECT_NEAR(mean.Value(place), expected, 4.5 * mean.Error(place))
        << k1 << " " << k2 << " " << t;
      EXPECT_LT(mean.Error(place), 0.02);
      ++compared;
    });
  EXPECT_GT(compared, 180);
}

TEST(FanSampling, OneSphereInAPeriodicBox)
{
  // S_111 = V_common / V and S_mmm = 1 - V_union / V while no side of the triangle reaches an image
  constexpr double a = 1.0, edge = 5.0;
  const SamplingRegion region(oracle::PeriodicCube(edge), 0.0);
  const SpherePack pack = oracle::RandomPack({ 1 }, { a }, region.GetBounds(), 2);
  const ThreePointGrid grid = { { 0.3, 8 }, 16 };
  const ThreePointProbability sampled =
    Fans(pack, 1, region, grid, { { 0, 0, 0 }, { 1, 1, 1 } }, { 3, 12800, true });
  int compared = 0;
  ForEachPlace(grid,
    [&](int k1, int k2, int t)
    {
      const double r1 = 0.3 * k1, r2 = 0.3 * k2, theta = Pi * t / 8.0;
      if (r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * std::cos(theta) >= 9.0)
      {
        return;
      }
      const double volume = std::pow(edge, 3);
      // 5 standard errors, with 1200 numbers; a count of a rare event is not normally distributed,
      // of which five events of the pairs of a throw may be
      const double common = oracle::CommonToThree(a, r1, r2, theta) / volume;
      const double rare = 5.0 * grid.Directions / (12800.0 * grid.RayPairs(t));
      EXPECT_NEAR(
        sampled.Value(0, k1, k2, t), common, 5.0 * sampled.Error(0, k1, k2, t) + rare + 1e-15)
        << k1 << " " << k2 << " " << t;
      EXPECT_NEAR(sampled.Value(1, k1, k2, t),
        1.0 - oracle::UnionOfThree(a, r1, r2, theta) / volume, 5.0 * sampled.Error(1, k1, k2, t))
        << k1 << " " << k2 << " " << t;
      EXPECT_LT(sampled.Error(0, k1, k2, t), 0.002);
      EXPECT_LT(sampled.Error(1, k1, k2, t), 0.004);
      ++compared;
    });
  EXPECT_GT(compared, 500);
}

TEST(FanSampling, PointsFarApartAreIndependent)
{
  // Six radii and more apart in a random pack of many spheres. What is left of correlations is, to
  // first order, that of the three pairs of points, which the exact pair sum knows.
  constexpr double edge = 14.0, lag = 6.0;
  const Window box = oracle::PeriodicCube(edge);
  const SpherePack pack = oracle::RelaxedPack({ 100, 200 }, { 0.9, 0.7 }, box, 3);
  const ThreePointGrid grid = { { lag, 1 }, 6 };
  const std::vector<PhaseTriple> triples = ruc::ParseTriples("all", 2);
  const ThreePointProbability sampled =
    Fans(pack, 2, SamplingRegion(box, 0.0), grid, triples, { 5, 12800, true });
  const ruc::TwoPointProbability near = ruc::SumPairs(pack, box, { lag, 1 });
  const std::vector<double>& c = near.Fractions;
  for (int t = 1; t < grid.Angles(); ++t)
  {
    const double third = 2.0 * lag * std::sin(Pi * t / 6.0);
    const ruc::TwoPointProbability far = ruc::SumPairs(pack, box, { third, 1 });
    const auto correlation = [&](const ruc::TwoPointProbability& pairs, int r, int s)
    { return std::abs(pairs.S(r, s)[1] / (c[r] * c[s]) - 1.0); };
    for (std::size_t n = 0; n < triples.size(); ++n)
    {
      const auto [r, s, q] = triples[n];
      const double apart = c[r] * c[s] * c[q];
      const double left =
        correlation(near, r, s) + correlation(near, r, q) + correlation(far, s, q);
      EXPECT_LT(left, 0.2);
      EXPECT_NEAR(sampled.Value(n, 1, 1, t), apart, 4.5 * sampled.Error(n, 1, 1, t) + left * apart)
        << ruc::TripleName(triples[n], 2) << " " << t;
      EXPECT_LT(sampled.Error(n, 1, 1, t), 0.05 * std::sqrt(apart));
    }
  }
}

TEST(FanSampling, PackTurnedByARightAngle)
{
  // About the z axis through the middle of a cube; the same estimate within the errors of two runs
  const Window cube = Window::MakeBox({ 0, 0, 0 }, { 7, 7, 7 }, { false, false, false });
  SpherePack pack = oracle::RandomPack({ 25, 40 }, { 0.9, 0.6 }, cube, 9);
  SpherePack turned = pack;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    // Denser on one side, so that the turn is seen by whoever should not see it
    pack.X[i] = 7.0 * std::pow(pack.X[i] / 7.0, 1.5);
    turned.X[i] = 7.0 - pack.Y[i];
    turned.Y[i] = pack.X[i];
  }
  const SamplingRegion region(cube, 0.9);
  const ThreePointGrid grid = { { 0.5, 5 }, 8 };
  const ThreePointProbability before = Fans(pack, 2, region, grid, Triples, { 1, 6400, true });
  const ThreePointProbability after = Fans(turned, 2, region, grid, Triples, { 2, 6400, true });
  for (std::size_t n = 0; n < Triples.size(); ++n)
  {
    ForEachPlace(grid,
      [&](int k1, int k2, int t)
      {
        const double error = std::hypot(before.Error(n, k1, k2, t), after.Error(n, k1, k2, t));
        // A count of 0 or a few in one of the runs says little of the error
        EXPECT_NEAR(before.Value(n, k1, k2, t), after.Value(n, k1, k2, t), 5.0 * error + 2e-4)
          << n << " " << k1 << " " << k2 << " " << t;
        EXPECT_LT(error, 0.02);
      });
  }
}

TEST(FanSampling, StandardErrorsCover)
{
  // Of 300 independent runs 68.3 % and 95.4 % are to be within one and two standard errors (67.9
  // and 95.0 % with 64 batches): 204 and 285, with binomial standard deviations of 8.1 and 3.8. The
  // bounds are 4 of these away; 14 quantities are looked at.
  constexpr double a = 1.2, edge = 4.0;
  const SamplingRegion region(oracle::PeriodicCube(edge), 0.0);
  const SpherePack pack = oracle::RandomPack({ 1 }, { a }, region.GetBounds(), 4);
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  const int places[][3] = { { 0, 0, 0 }, { 1, 0, 2 }, { 1, 1, 0 }, { 1, 2, 1 }, { 2, 2, 1 },
    { 3, 1, 0 }, { 1, 1, 4 } };
  int within[2][7][2] = {};
  for (std::uint32_t seed = 1; seed <= 300; ++seed)
  {
    const ThreePointProbability sampled =
      Fans(pack, 1, region, grid, { { 0, 0, 0 }, { 1, 1, 1 } }, { seed, 1280, true });
    for (int n = 0; n < 7; ++n)
    {
      const auto [k1, k2, t] = places[n];
      const double r1 = 0.4 * k1, r2 = 0.4 * k2, theta = Pi * t / 4.0;
      const double expected[2] = { oracle::CommonToThree(a, r1, r2, theta) / std::pow(edge, 3),
        1.0 - oracle::UnionOfThree(a, r1, r2, theta) / std::pow(edge, 3) };
      for (int phase = 0; phase < 2; ++phase)
      {
        const double off = std::abs(sampled.Value(phase, k1, k2, t) - expected[phase]) /
          sampled.Error(phase, k1, k2, t);
        within[phase][n][0] += off < 1.0;
        within[phase][n][1] += off < 2.0;
      }
    }
  }
  for (int phase = 0; phase < 2; ++phase)
  {
    for (int n = 0; n < 7; ++n)
    {
      EXPECT_NEAR(within[phase][n][0], 204, 33) << phase << " " << n;
      EXPECT_NEAR(within[phase][n][1], 285, 16) << phase << " " << n;
    }
  }
}

TEST(FanSampling, RanksAndThreadsGiveEqualResults)
{
  const ThreePointGrid grid = { { 0.4, 4 }, 8 };
  const std::vector<PhaseTriple> triples = { { 0, 0, 0 }, { 1, 2, 0 }, { 2, 2, 2 } };
  const std::vector<Medium> media = Media();
  for (const Medium& medium : { media[0], media[1], media[4] })
  {
    // 200 throws are 50 batches, which 3 ranks cannot share evenly
    ExpectEqualForRanksAndThreads(medium.Pack,
      [&](const SpherePack& own, ruc::Communicator& ranks)
      {
        const ThreePointProbability sampled =
          ruc::SampleFans(own, 2, medium.Region, grid, triples, { 5, 200, true }, ranks);
        // As numbers to compare; of those that are none only that
        std::vector<double> numbers;
        const auto add = [&](double number)
        { numbers.push_back(std::isnan(number) ? -99.0 : number); };
        for (std::size_t n = 0; n < triples.size(); ++n)
        {
          ForEachPlace(grid,
            [&](int k1, int k2, int t)
            {
              add(sampled.Value(n, k1, k2, t));
              add(sampled.Error(n, k1, k2, t));
            });
          if (n != 1)
          {
            add(sampled.ThirdOrder(n).Zeta);
            add(sampled.ThirdOrder(n).Eta);
            add(sampled.ThirdOrderError(n).Zeta);
            add(sampled.ThirdOrderError(n).Eta);
          }
        }
        EXPECT_GT(*std::max_element(numbers.begin(), numbers.end()), 0.3);
        ruc::SampledTwoPoint result = { { 1, { 1.0, 1 } }, {}, {}, {}, sampled.GetThrows(), 0.0 };
        result.Mean.Values = { numbers };
        return result;
      });
  }
}

TEST(FanSampling, FewerBatchesThanRanks)
{
  const Medium medium = Media()[0];
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  const FanSettings settings = { 5, 2, true };
  const ThreePointProbability expected =
    Fans(medium.Pack, 2, medium.Region, grid, Triples, settings);
  oracle::ThreadRanks::Run(5,
    [&](ruc::Communicator& ranks)
    {
      const ThreePointProbability sampled =
        ruc::SampleFans(oracle::PieceOf(medium.Pack, ranks.Rank(), 5, false), 2, medium.Region,
          grid, Triples, settings, ranks);
      for (std::size_t n = 0; n < Triples.size(); ++n)
      {
        ForEachPlace(grid,
          [&](int k1, int k2, int t)
          {
            const std::size_t place = grid.PlaceOf(k1, k2, t);
            ExpectSame(
              sampled.Value(n, k1, k2, t), expected.Value(n, k1, k2, t), "value", n, place);
            ExpectSame(
              sampled.Error(n, k1, k2, t), expected.Error(n, k1, k2, t), "error", n, place);
          });
      }
    });
}

TEST(FanSampling, ReportsItsProgress)
{
  const Medium medium = Media()[0];
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  ruc::Communicator serial;
  std::vector<double> done;
  std::string last;
  ruc::SampleFans(medium.Pack, 2, medium.Region, grid, { { 0, 0, 0 } }, { 1, 500, false }, serial,
    [&](double share, const std::string& text)
    {
      done.push_back(share);
      last = text;
      return true;
    });
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  ASSERT_GT(done.size(), 10u);
  EXPECT_GT(done.front(), 0.0);
  EXPECT_EQ(done.back(), 1.0);
  EXPECT_EQ(last, "500 throws");
}

TEST(FanSampling, StopsWithTheThrowsTakenSoFar)
{
  // 16 throws are 16 batches of one, and so are 6.
  const Medium medium = Media()[0];
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  for (int size : { 1, 2 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const SpherePack own = oracle::PieceOf(medium.Pack, ranks.Rank(), ranks.Size(), false);
        const ThreePointProbability stopped = ruc::SampleFans(own, 2, medium.Region, grid,
          { { 0, 0, 0 } }, { 1, 16, false }, ranks,
          [&](double share, const std::string&) { return ranks.Rank() > 0 || share < 6.0 / 16.0; });
        const ThreePointProbability expected =
          ruc::SampleFans(own, 2, medium.Region, grid, { { 0, 0, 0 } }, { 1, 6, false }, ranks);
        EXPECT_EQ(stopped.GetThrows(), 6);
        for (int k = 0; k <= grid.Lags.Count; ++k)
        {
          EXPECT_EQ(stopped.Value(0, k, 1, 2), expected.Value(0, k, 1, 2));
        }
        EXPECT_EQ(stopped.ThirdOrder(0).Zeta, expected.ThirdOrder(0).Zeta);
      });
  }
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
TEST(FanSampling, TakesTheMemoryItSays)
{
  const OneThread alone; // whose blocks alone are counted
  const auto taken = []()
  {
    const struct mallinfo2 info = ::mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
  };
  const std::vector<Medium> media = Media();
  const ThreePointGrid grid = { { 0.02, 70 }, 12 };
  for (const Medium& medium : { media[0], media[2] })
  {
    const bool bounded = !medium.Region.IsFullyPeriodic();
    for (const bool withErrors : { false, true })
    {
      std::vector<double> most;
      for (const std::int64_t throws : { 1000, 2000 })
      {
        ruc::Communicator serial;
        const double before = taken();
        most.push_back(0.0);
        const ThreePointProbability sampled = ruc::SampleFans(medium.Pack, 2, medium.Region, grid,
          Triples, { 1, throws, withErrors }, serial,
          [&](double, const std::string&)
          {
            most.back() = std::max(most.back(), taken() - before);
            return true;
          });
        // Two of the seven triples are another one with s and q swapped, and not counted again. The
        // rest is for the cells of the pack and up to 125 throws of 12 rays in hand, 3 kB each.
        const double estimate = ruc::EstimateFanMemory(grid, 5, withErrors, bounded);
        EXPECT_LE(most.back(), estimate + 125 * 3e3) << medium.Name << withErrors;
        EXPECT_GE(most.back(), estimate) << medium.Name << withErrors;
        // The result keeps the sums, without the batches
        EXPECT_LE(taken() - before, most.back());
        EXPECT_GE(taken() - before, 0.6 * estimate);
      }
      EXPECT_NEAR(most[0], most[1], 2e5);
    }
  }
}
#endif

TEST(FanSampling, MemoryEstimate)
{
  // 32 bits a place and triple for a batch, 64 for each sum: of N, and with errors of N^2 and N D;
  // in a region with a border of D, and with errors of D^2
  const ThreePointGrid grid = { { 0.1, 9 }, 20 };
  const double places = 10.0 * 10.0 * 11.0;
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 1, false, false), 12.0 * places);
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 5, true, false), 5.0 * 28.0 * places);
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 5, false, true), (5.0 * 12.0 + 12.0) * places);
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 5, true, true), (5.0 * 28.0 + 20.0) * places);
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
