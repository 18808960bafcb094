// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells whose spheres keep away from each other, and whose modes have several sizes
#include "ruc/Packing/MaximumFraction.h"
#include "ruc/Reconstruction/CellStart.h"
#include "ruc/Reconstruction/GradientSearch.h"

#include "SearchProblem.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <algorithm>
#include <limits>

namespace
{
struct Problem
{
  Problem()
    : Pack(oracle::RelaxedPack({ 160, 320 }, { 1.0, 0.6 }, oracle::PeriodicCube(14.5), 70))
    , Box(oracle::PeriodicCube(14.5))
  {
    oracle::Uniform random(5);
    for (double& radius : this->Pack.Radius)
    {
      radius *= random(0.9, 1.0);
    }
  }
  ruc::SpherePack Pack;
  ruc::Window Box;
};

// The least of (d - length - (1 + share) (a + b)) over all pairs and images
double LeastRoom(const ruc::UnitCell& cell, const ruc::LeastGap& gap)
{
  const double edge = cell.Box.Size[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.Pack.Size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      double d2 = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        double d = cell.Pack.Centre(i)[q] - cell.Pack.Centre(j)[q];
        d -= edge * std::nearbyint(d / edge);
        d2 += d * d;
      }
      const double radii = cell.Pack.Radius[i] + cell.Pack.Radius[j];
      least = std::min(least, std::sqrt(d2) - gap.Length - (1.0 + gap.Share) * radii);
    }
  }
  return least;
}

ruc::UnitCell Search(const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
  int iterations, ruc::Communicator& ranks)
{
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = iterations;
  return ruc::SearchByGradient(
    contents, target, settings, ranks, [](const ruc::SearchState&) { return true; });
}
}

TEST(LeastGap, IsKeptByEveryPair)
{
  const Problem problem;
  const ruc::TwoPointProbability target = ruc::SumPairs(problem.Pack, problem.Box, { 0.15, 24 });
  ruc::Communicator alone;
  for (const ruc::LeastGap& gap :
    { ruc::LeastGap{ 0.05, 0.0 }, ruc::LeastGap{ 0.0, 0.03 }, ruc::LeastGap{ 0.02, 0.02 } })
  {
    ruc::CellContents contents =
      ruc::FindCellContents(ruc::SharePack(problem.Pack, problem.Box), 60);
    const std::vector<double> radii = contents.Radii();
    contents.Gap = gap;
    const ruc::UnitCell cell = Search(contents, target, 30, alone);
    EXPECT_TRUE(cell.TooNear.IsNone());
    EXPECT_TRUE(cell.Overlap.IsNone());
    EXPECT_EQ(cell.Pack.Radius, radii);
    EXPECT_GE(LeastRoom(cell, gap), -1e-11);
    EXPECT_EQ(cell.Objective, ruc::TwoPointDifference(target, cell.Probability));
  }
}

TEST(LeastGap, OfADenseCellIsKeptToo)
{
  const Problem problem;
  const ruc::TwoPointProbability target = ruc::SumPairs(problem.Pack, problem.Box, { 0.15, 24 });
  ruc::CellContents contents = ruc::FindCellContents(ruc::SharePack(problem.Pack, problem.Box), 60);
  // As large a gap as makes the enlarged spheres dense
  const double most = ruc::MaximumRandomFraction(contents.Radii());
  contents.Gap.Share = std::cbrt(0.96 * most / contents.Fraction()) - 1.0;
  ASSERT_TRUE(ruc::IsDense(contents));
  ASSERT_FALSE(ruc::IsDense(contents.Radii(), contents.Fraction(), contents.Edge));
  ruc::Communicator alone;
  const ruc::UnitCell cell = Search(contents, target, 60, alone);
  EXPECT_TRUE(cell.TooNear.IsNone());
  EXPECT_EQ(cell.Pack.Radius, contents.Radii());
  EXPECT_GE(LeastRoom(cell, contents.Gap), -1e-11);
  contents.Gap.Share = 1.0;
  EXPECT_SAYS(Search(contents, target, 60, alone),
    "enlarged by MinimumGap and MinimumGapShare, would have a fraction of");
}

TEST(LeastGap, AndSizesWithinAModeAreTheSameOnAnyRanks)
{
  const Problem problem;
  const ruc::PackShare share = ruc::SharePack(problem.Pack, problem.Box);
  const ruc::TwoPointProbability target = ruc::SumPairs(problem.Pack, problem.Box, { 0.15, 24 });
  ruc::Communicator alone;
  ruc::CellContents contents = ruc::DivideModes(ruc::FindCellContents(share, 60), 3, share, alone);
  contents.Gap.Length = 0.02;
  const ruc::UnitCell expected = Search(contents, target, 20, alone);
  EXPECT_EQ(expected.Pack.Radius, contents.Radii());
  EXPECT_GE(LeastRoom(expected, contents.Gap), -1e-11);
  for (int ranks : { 2, 3, 4 })
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        const ruc::UnitCell cell = Search(contents, target, 20, communicator);
        EXPECT_EQ(cell.Pack.X, expected.Pack.X);
        EXPECT_EQ(cell.Pack.Z, expected.Pack.Z);
        EXPECT_EQ(cell.Objective, expected.Objective);
      });
  }
}
