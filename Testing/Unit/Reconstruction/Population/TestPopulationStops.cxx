// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationSearch.h"

#include "SearchProblem.h"
#include "ThreadRanks.h"

#include <omp.h>

#include <atomic>

namespace
{
// A cell that is too dense to be freed: a child is moved in vain for tens of thousands of steps
struct JammedProblem
{
  ruc::CellContents Contents = { { 16 }, { 1.0 }, std::cbrt(16 * 4.0 / 3.0 * oracle::Pi / 0.85) };
  ruc::TwoPointProbability Target =
    ruc::SumPairs(oracle::RandomPack({ 16 }, { 1.0 }, oracle::PeriodicCube(8.0), 1),
      oracle::PeriodicCube(8.0), { 0.1, 10 });
};
}

TEST(PopulationStops, ComeWithinTheFirstPopulation)
{
  ruc::PopulationSettings settings;
  settings.Population = 200;
  for (int ranks : { 1, 2 })
  {
    std::atomic<int> asked(0);
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        bool saved = false;
        const ruc::PopulationResult result = ruc::SearchByPopulation(
          TheSearchProblem().Contents, TheSearchProblem().Target, settings, communicator,
          [&](const ruc::SearchState& state)
          {
            EXPECT_EQ(state.Iteration, 0);
            EXPECT_GT(state.Objective, 0.0);
            ++asked;
            return false;
          },
          nullptr, [&](const ruc::PopulationState&) { saved = true; });
        EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::Stopped);
        EXPECT_FALSE(saved); // there is no whole population to go on from
        EXPECT_TRUE(result.Best.Overlap.IsNone());
        EXPECT_GE(result.Before.Mean, result.Before.Minimum);
      });
    // Once on each rank, but for one whose other threads were done before its first began
    EXPECT_GE(asked, 1);
    EXPECT_LE(asked, ranks);
  }
}

TEST(PopulationStops, AskWithinAMemberAndWhileTheLastOverlapIsRemoved)
{
  const JammedProblem jammed;
  ruc::PopulationSettings settings;
  settings.Population = 12;
  settings.MatingPool = 4;
  settings.MaximumGenerations = 1000;
  settings.RandomShare = 0.0;
  settings.DepositionDegree = 0.0;
  for (int threads : { 1, 3 })
  {
    omp_set_num_threads(threads);
    for (int stopAfter : { 3, 40, 2000 }) // questions, in the deposition or among children
    {
      int asked = 0, generation = 0;
      ruc::Communicator serial;
      const ruc::PopulationResult result =
        ruc::SearchByPopulation(jammed.Contents, jammed.Target, settings, serial,
          [&](const ruc::SearchState& state)
          {
            generation = state.Iteration;
            return ++asked < stopAfter;
          });
      EXPECT_EQ(asked, stopAfter);
      EXPECT_LE(generation, 20); // a generation has hundreds of questions
      EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::Stopped);
      EXPECT_EQ(result.Best.Pack.Size(), 16u);
      EXPECT_FALSE(result.Best.Overlap.IsNone());
    }
  }
  omp_set_num_threads(1);
  // No generation is wanted, so only the best of the first population is left to be freed
  settings.MaximumGenerations = 0;
  settings.RandomShare = 1.0;
  int removing = 0;
  ruc::Communicator serial;
  const ruc::PopulationResult result = ruc::SearchByPopulation(jammed.Contents, jammed.Target,
    settings, serial, [&](const ruc::SearchState&) { return ++removing < 100; });
  EXPECT_EQ(removing, 100);
  EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::Stopped);
  EXPECT_FALSE(result.Best.Overlap.IsNone());
}
