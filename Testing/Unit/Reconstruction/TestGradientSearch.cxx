// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/GradientSearch.h"

#include "SearchProblem.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <omp.h>

namespace
{
using ruc::SearchState;
using ruc::TwoPointProbability;
using ruc::UnitCell;

// A pack of 8 times 60 spheres, and a cell of 60
struct Problem
{
  Problem()
    : Pack(oracle::RelaxedPack({ 160, 320 }, { 1.0, 0.6 }, oracle::PeriodicCube(14.5), 70))
    , Box(oracle::PeriodicCube(14.5))
    , Contents(ruc::FindCellContents(ruc::SharePack(this->Pack, this->Box), 60))
    , Target(ruc::SumPairs(this->Pack, this->Box, { 0.15, 24 }))
  {
  }
  ruc::SpherePack Pack;
  ruc::Window Box;
  ruc::CellContents Contents;
  TwoPointProbability Target;
};

const Problem& TheProblem()
{
  static const Problem problem;
  return problem;
}

UnitCell Search(const ruc::GradientSearchSettings& settings,
  const std::function<bool(const SearchState&)>& carryOn)
{
  ruc::Communicator serial;
  return ruc::SearchByGradient(
    TheProblem().Contents, TheProblem().Target, settings, serial, carryOn);
}

ruc::GradientSearchSettings Settings(int iterations, std::uint32_t seed = 1, double target = 0.0)
{
  ruc::GradientSearchSettings settings;
  settings.Seed = seed;
  settings.MaximumIterations = iterations;
  settings.TargetObjective = target;
  return settings;
}

// Expects what every cell has to be, however the search ended
void ExpectConsistent(const UnitCell& cell)
{
  const ruc::CellContents& contents = TheProblem().Contents;
  ASSERT_EQ(cell.Pack.Size(), std::size_t(contents.NumberOfSpheres()));
  std::vector<int> counts(contents.Count.size(), 0);
  for (std::size_t i = 0; i < cell.Pack.Size(); ++i)
  {
    ++counts[cell.Pack.Mode[i] - 1];
    EXPECT_EQ(cell.Pack.Radius[i], contents.Radius[cell.Pack.Mode[i] - 1]);
    for (double c : cell.Pack.Centre(i))
    {
      EXPECT_GE(c, 0.0);
      EXPECT_LT(c, contents.Edge);
    }
  }
  EXPECT_EQ(counts, contents.Count);
  EXPECT_TRUE(cell.Box.IsFullyPeriodic());
  EXPECT_EQ(cell.Box.Size, (ruc::Vector3{ contents.Edge, contents.Edge, contents.Edge }));
  // The objective is F2 of the pack that is returned, and the last row of the convergence says so.
  const TwoPointProbability probability =
    ruc::SumPairs(cell.Pack, cell.Box, TheProblem().Target.Lags);
  EXPECT_EQ(cell.Objective, ruc::TwoPointDifference(TheProblem().Target, probability));
  EXPECT_EQ(cell.Probability.Values, probability.Values);
  ASSERT_GE(cell.Convergence.size(), 2u);
  EXPECT_EQ(cell.Convergence.back().Objective, cell.Objective);
  EXPECT_EQ(cell.Convergence.back().OverlapPercent, cell.Overlap.Percent);
  EXPECT_EQ(cell.Convergence.back().Iteration, cell.Iterations);
  for (std::size_t n = 0; n < cell.Convergence.size(); ++n)
  {
    EXPECT_EQ(cell.Convergence[n].Iteration, int(n));
  }
  EXPECT_EQ(cell.Convergence[1].Objective, cell.StartObjective);
  EXPECT_EQ(cell.Overlap.IsNone(), oracle::LeastGap(cell.Pack, cell.Box) >= 0.0);
}

}

TEST(GradientSearch, FindsABetterCellWithoutOverlap)
{
  for (std::uint32_t seed : { 1u, 2u })
  {
    const UnitCell cell = Search(Settings(150, seed), CarryOn);
    ExpectConsistent(cell);
    EXPECT_GE(oracle::LeastGap(cell.Pack, cell.Box), 0.0);
    EXPECT_EQ(cell.Overlap.Pairs, 0);
    // On problems of this kind F2 was measured to fall to a tenth within 150 iterations; a search
    // that does not descend stays at 1
    EXPECT_LT(cell.Objective, 0.5 * cell.StartObjective);
    EXPECT_LT(
      cell.StartObjective, cell.Convergence[0].Objective); // an overlapping start is farther away
    EXPECT_GT(cell.Convergence[0].OverlapPercent, 1.0);
  }
}

TEST(GradientSearch, SeedsGiveOtherCells)
{
  EXPECT_NE(Search(Settings(0, 1), CarryOn).Pack.X, Search(Settings(0, 2), CarryOn).Pack.X);
}

TEST(GradientSearch, IsTheSameForEveryRunAndNumberOfThreads)
{
  omp_set_num_threads(1);
  const UnitCell first = Search(Settings(60), CarryOn);
  ExpectEqual(first, Search(Settings(60), CarryOn));
  for (int threads : { 2, 3 })
  {
    omp_set_num_threads(threads);
    ExpectEqual(first, Search(Settings(60), CarryOn));
  }
  omp_set_num_threads(1);
}

TEST(GradientSearch, NoIterationsGiveTheStart)
{
  const UnitCell cell = Search(Settings(0), CarryOn);
  ExpectConsistent(cell);
  EXPECT_EQ(cell.EndedBy, ruc::EndReason::MaximumIterations);
  EXPECT_EQ(cell.Convergence.size(), 2u);
  EXPECT_EQ(cell.Objective, cell.StartObjective);
  EXPECT_TRUE(cell.Overlap.IsNone());
}

TEST(GradientSearch, EndsAtTheMaximumOfIterations)
{
  int last = -1;
  const UnitCell cell = Search(Settings(7),
    [&](const SearchState& state)
    {
      last = std::max(last, state.Iteration);
      return true;
    });
  ExpectConsistent(cell);
  EXPECT_EQ(cell.EndedBy, ruc::EndReason::MaximumIterations);
  EXPECT_EQ(
    cell.Convergence.size(), 2u + 7u + 1u); // start, without overlap, 7 iterations, the cell
  EXPECT_EQ(last, cell.Iterations);
}

TEST(GradientSearch, StopsWhenItIsTold)
{
  for (int stopAt : { 0, 1, 2, 5, 30 })
  {
    const UnitCell cell =
      Search(Settings(200), [&](const SearchState& state) { return state.Iteration < stopAt; });
    SCOPED_TRACE(stopAt);
    ExpectConsistent(cell);
    EXPECT_EQ(cell.EndedBy, ruc::EndReason::Stopped);
    EXPECT_LE(cell.Iterations, stopAt + 3);
    if (stopAt >= 2) // the overlap of the start was removed by then
    {
      EXPECT_TRUE(cell.Overlap.IsNone());
    }
    if (stopAt == 30) // what the descent has found is freed from overlap and kept
    {
      EXPECT_LT(cell.Objective, cell.StartObjective);
    }
  }
}

TEST(GradientSearch, EndsAtTheTargetObjective)
{
  const double start = Search(Settings(0), CarryOn).StartObjective;
  const UnitCell cell = Search(Settings(500, 1, 0.4 * start), CarryOn);
  ExpectConsistent(cell);
  EXPECT_EQ(cell.EndedBy, ruc::EndReason::TargetObjective);
  EXPECT_LE(cell.Objective, 0.4 * start);
  EXPECT_TRUE(cell.Overlap.IsNone());
  EXPECT_LT(cell.Iterations, 500);
  const UnitCell atOnce = Search(Settings(500, 1, 2.0 * start), CarryOn);
  EXPECT_EQ(atOnce.EndedBy, ruc::EndReason::TargetObjective);
  EXPECT_EQ(atOnce.Objective, start);
}

TEST(GradientSearch, AnOverlappingCellDoesNotMeetTheTarget)
{
  // Told to stop before the overlap of the start is removed: whatever its F2, that cell is not what
  // was asked for.
  const UnitCell cell = Search(Settings(10, 1, 1e9), [](const SearchState&) { return false; });
  EXPECT_FALSE(cell.Overlap.IsNone());
  EXPECT_EQ(cell.EndedBy, ruc::EndReason::Stopped);
}
