// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackFigures.h"

#include "Oracles.h"
#include "ruc/Packing/DensePack.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/Population/PopulationSettings.h"
#include "ruc/Statistics/PairSums/DirectionalProbability.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/PairSums/RadialDistribution.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/Sampling/FanSampling.h"
#include "ruc/Statistics/Sampling/TemplateSampling.h"

// Tests do not look at seconds, but at how they grow with the work
namespace
{
ruc::PackFigures MakePack(double spheres, bool periodic)
{
  ruc::PackFigures pack;
  pack.Spheres = spheres;
  const double edge = std::cbrt(spheres); // of density 1
  pack.Observed =
    ruc::Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { periodic, periodic, periodic });
  pack.MeanRadius = pack.LargestRadius = 0.5;
  pack.MeanSquareRadius = 0.25;
  pack.MeanDiameter = 1.0;
  pack.Modes = 9;
  pack.Types = 9;
  return pack;
}

// Pairs of random points in a box closer than a distance, and the standard error over the boxes
std::pair<double, double> CountPairs(const ruc::PackFigures& pack, double distance)
{
  constexpr int Boxes = 40;
  const double edge = pack.Observed.ShortestEdge();
  oracle::Uniform uniform(5);
  double sum = 0.0, squares = 0.0;
  for (int box = 0; box < Boxes; ++box)
  {
    std::vector<ruc::Vector3> points(static_cast<std::size_t>(pack.Spheres));
    for (ruc::Vector3& point : points)
    {
      point = { uniform(0.0, edge), uniform(0.0, edge), uniform(0.0, edge) };
    }
    double pairs = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        double square = 0.0;
        for (int q = 0; q < 3; ++q)
        {
          double d = std::abs(points[i][q] - points[j][q]);
          d = pack.Observed.IsFullyPeriodic() ? std::min(d, edge - d) : d;
          square += d * d;
        }
        pairs += square < distance * distance;
      }
    }
    sum += pairs;
    squares += pairs * pairs;
  }
  const double mean = sum / Boxes;
  return { mean, std::sqrt((squares / Boxes - mean * mean) / (Boxes - 1)) };
}
}

TEST(Estimates, PairsOfAnEvenPackAreCounted)
{
  for (bool periodic : { true, false })
  {
    const ruc::PackFigures pack = MakePack(512.0, periodic); // of edge 8
    for (double distance : { 1.0, 2.5, 4.0 })
    {
      const auto [pairs, error] = CountPairs(pack, distance);
      // There are N (N - 1) / 2 pairs, where the estimate takes N^2 / 2
      EXPECT_NEAR(pack.PairsWithin(distance), pairs, 4.0 * error + pairs / pack.Spheres)
        << periodic << " " << distance;
    }
    EXPECT_LE(MakePack(8.0, false).PairsWithin(100.0), 32.0); // there are no more
  }
}

TEST(Estimates, OfAPeriodicPackGrowWithItsSpheres)
{
  const ruc::PackFigures small = MakePack(1e5, true), large = MakePack(8e5, true);
  const ruc::LagGrid lags = { 0.05, 100 };
  const double none = ruc::EstimatePairSum(MakePack(1.0, true), lags).Seconds; // the tables
  const double ratio = (ruc::EstimatePairSum(large, lags).Seconds - none) /
    (ruc::EstimatePairSum(small, lags).Seconds - none);
  EXPECT_NEAR(ratio, 8.0, 1e-3); // one sphere in 1e5
  EXPECT_NEAR(ruc::EstimateRadialDistribution(large, lags).Seconds /
      ruc::EstimateRadialDistribution(small, lags).Seconds,
    8.0, 1e-9);
  EXPECT_NEAR(
    ruc::EstimatePack(large).MegabytesOfAll / ruc::EstimatePack(small).MegabytesOfAll, 8.0, 1e-9);
  EXPECT_EQ(ruc::EstimatePack(large).MegabytesOfRank, 0.0); // no rank holds all of it
}

TEST(Estimates, GrowWithTheCubeOfTheDistance)
{
  const ruc::PackFigures pack = MakePack(1e6, true);
  EXPECT_NEAR(pack.PairsWithin(6.0) / pack.PairsWithin(3.0), 8.0, 1e-9);
  const double near = ruc::EstimateRadialDistribution(pack, { 0.1, 50 }).Seconds;
  EXPECT_NEAR(ruc::EstimateRadialDistribution(pack, { 0.1, 100 }).Seconds / near, 8.0, 1e-9);
}

TEST(Estimates, GrowWithTheSamples)
{
  const ruc::PackFigures pack = MakePack(1e4, false);
  const ruc::LagGrid lags = { 0.05, 100 };
  const ruc::ThreePointGrid grid = { lags, 20 };
  // Three numbers of samples n, 2 n, 3 n: equal steps
  const auto steps = [](auto&& seconds)
  { return (seconds(3) - seconds(2)) / (seconds(2) - seconds(1)); };
  EXPECT_NEAR(
    steps([&](int n) { return ruc::EstimateChords(pack, lags, 1000.0 * n).Seconds; }), 1.0, 1e-9);
  EXPECT_NEAR(
    steps([&](int n) { return ruc::EstimateTemplate(pack, lags, 1000.0 * n).Seconds; }), 1.0, 1e-9);
  EXPECT_NEAR(
    steps([&](int n) { return ruc::EstimateFans(pack, grid, 3, false, 1000.0 * n).Seconds; }), 1.0,
    1e-9);
  EXPECT_NEAR(
    steps([&](int n) { return ruc::EstimatePairSumAlong(pack, lags, n).Seconds; }), 1.0, 1e-9);
  // More triples and errors take more memory, more throws do not
  const auto memory = [&](std::size_t triples, bool errors, double throws)
  { return ruc::EstimateFans(pack, grid, triples, errors, throws).MegabytesOfRank; };
  EXPECT_GT(memory(2, false, 1e3), 1.4 * memory(1, false, 1e3));
  EXPECT_GT(memory(2, true, 1e3), memory(2, false, 1e3));
  EXPECT_EQ(memory(2, true, 1e6), memory(2, true, 1e3));
}

// The tables have a knot every so many parts of the smallest radius up to the last lag, and no
// fewer numbers than an objective has
TEST(Estimates, OfAnObjectiveGrowsWithTheRatioOfItsRadii)
{
  ruc::CellContents contents = { { 5, 15 }, { 1.0, 1e-3 }, 4.0 };
  const ruc::LagGrid lags = { 0.2, 10 };
  const double bytes = ruc::EstimateObjectiveBytes(ruc::FiguresOf(contents), lags);
  const ruc::PairHistogram histogram({ { 1, 1.0 }, { 2, 1e-3 } }, lags, ruc::SearchKnots);
  EXPECT_GT(bytes, 4.0 * sizeof(double) * histogram.Size());
  EXPECT_LT(bytes, 10.0 * sizeof(double) * histogram.Size());
  contents.Radius[1] = 1e-6;
  EXPECT_NEAR(ruc::EstimateObjectiveBytes(ruc::FiguresOf(contents), lags) / bytes, 1e3, 10.0);
}

TEST(Estimates, OfDenseCellsHaveTheirStart)
{
  const auto estimate = [](double fraction, const std::vector<double>& share)
  {
    ruc::CellFigures cell;
    cell.Spheres = 1000.0;
    cell.Density = fraction / (oracle::Pi / 6.0);
    cell.LargestRadius = 0.5;
    cell.Radius = { 0.5 };
    cell.Share = share;
    ruc::GradientSearchSettings settings;
    settings.MaximumIterations = 10;
    return ruc::EstimateGradientSearch(cell, { 0.05, 60 }, settings).Seconds;
  };
  ruc::DensePackSettings settings;
  settings.Radii = { 0.5 };
  settings.Fraction = 0.64;
  settings.Protocol = ruc::PackingProtocol::Events;
  const double start = ruc::EstimateDensePack(settings, 1000.0).Seconds;
  EXPECT_NEAR(estimate(0.64, { 1.0 }) - estimate(0.64, {}), start, 1e-9);
  EXPECT_EQ(estimate(0.58, { 1.0 }), estimate(0.58, {}));
  EXPECT_THROW(estimate(0.70, { 1.0 }), std::invalid_argument);
}

// What is denser, or grows more slowly, collides more often
TEST(Estimates, OfDensePacks)
{
  ruc::DensePackSettings settings;
  settings.Radii = { 0.5 };
  settings.Protocol = ruc::PackingProtocol::Events;
  double before = 0.0;
  for (double fraction : { 0.50, 0.60, 0.62, 0.64, 0.6449 })
  {
    settings.Fraction = fraction;
    const double seconds = ruc::EstimateDensePack(settings, 1000.0).Seconds;
    EXPECT_GT(seconds, 1.2 * before) << fraction;
    before = seconds;
  }
  settings.Rate = 0.001;
  const double slow = ruc::EstimateDensePack(settings, 1000.0).Seconds;
  settings.Rate = 0.002;
  EXPECT_NEAR(slow / ruc::EstimateDensePack(settings, 1000.0).Seconds, 2.0, 0.1);
}

TEST(Estimates, OfSearchesGrowWithTheirIterations)
{
  ruc::CellFigures cell;
  cell.Spheres = 1000.0;
  cell.Density = 1.0;
  cell.LargestRadius = 0.5;
  cell.Modes = 9;
  const ruc::LagGrid lags = { 0.05, 100 };
  ruc::GradientSearchSettings descent;
  const auto gradient = [&](int n)
  {
    descent.MaximumIterations = n;
    return ruc::EstimateGradientSearch(cell, lags, descent).Seconds;
  };
  EXPECT_NEAR((gradient(300) - gradient(0)) / (gradient(100) - gradient(0)), 3.0, 1e-9);
  EXPECT_NEAR((gradient(100) - gradient(0)) / 100.0, ruc::EstimateEvaluation(cell, lags, true),
    1e-9 * gradient(100));

  // Half as many iterations more, 0.9 of them with pores
  const double alone = gradient(100) - gradient(0);
  descent.Neighbours.ContactWeight = 1.0;
  EXPECT_NEAR((gradient(100) - gradient(0)) / alone, 1.5, 1e-9);
  descent.Neighbours.PoreWeight = 1.0;
  EXPECT_NEAR(gradient(100) - gradient(0) - 1.5 * alone,
    90.0 * ruc::EstimatePoreTerm(cell.Spheres).Seconds, 1e-9 * gradient(100));

  ruc::PopulationSettings settings;
  const auto population = [&]() { return ruc::EstimatePopulationSearch(cell, lags, settings); };
  settings.MaximumGenerations = 0;
  const ruc::Estimate first = population();
  settings.Population *= 2;
  EXPECT_NEAR(population().Seconds / first.Seconds, 2.0, 1e-9);
  EXPECT_NEAR(population().MegabytesOfRank / first.MegabytesOfRank, 2.0, 1e-9);
  const double none = population().Seconds;
  settings.MaximumGenerations = 10;
  const double ten = population().Seconds - none;
  settings.MatingPool *= 3;
  EXPECT_NEAR((population().Seconds - none) / ten, 3.0, 1e-9);

  ruc::PopulationSettings hybrid = ruc::HybridOf({}, {});
  hybrid.MaximumGenerations = 7;
  const double descents = ruc::EstimatePopulationSearch(cell, lags, hybrid).Seconds;
  hybrid.MaximumGenerations = 0;
  EXPECT_NEAR(descents - ruc::EstimatePopulationSearch(cell, lags, hybrid).Seconds,
    7.0 * hybrid.RefinementSteps * ruc::EstimateEvaluation(cell, lags, true), 1e-9 * descents);
}
