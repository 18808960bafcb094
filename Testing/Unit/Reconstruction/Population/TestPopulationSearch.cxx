// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationSearch.h"

#include "SearchProblem.h"
#include "ThreadRanks.h"
#include "ruc/Packing/Deposition.h"
#include "ruc/Reconstruction/CellStart.h"
#include "ruc/Reconstruction/GradientSearch.h"

#include <omp.h>

#include <limits>

namespace
{
using ruc::PopulationResult;
using ruc::PopulationSettings;
using ruc::PopulationState;
using ruc::SearchState;

PopulationSettings Annealed(int generations, std::uint32_t seed = 1)
{
  PopulationSettings settings;
  settings.Seed = seed;
  settings.Population = 12;
  settings.MatingPool = 4;
  settings.MaximumGenerations = generations;
  settings.ReheatingGenerations = 5;
  settings.MutatedShare = 0.1;
  return settings;
}

PopulationSettings Hybrid(int generations, std::uint32_t seed = 1)
{
  PopulationSettings settings = ruc::HybridOf({}, {});
  settings.Seed = seed;
  settings.Population = 6;
  settings.MatingPool = 2;
  settings.MaximumGenerations = generations;
  settings.RefinementSteps = 15;
  return settings;
}

PopulationResult Search(const PopulationSettings& settings,
  const std::function<bool(const SearchState&)>& carryOn = CarryOn,
  const PopulationState* resume = nullptr,
  const std::function<void(const PopulationState&)>& save = {})
{
  ruc::Communicator serial;
  return ruc::SearchByPopulation(TheSearchProblem().Contents, TheSearchProblem().Target, settings,
    serial, carryOn, resume, save);
}

std::vector<PopulationState> StatesOf(const PopulationSettings& settings)
{
  std::vector<PopulationState> states;
  Search(settings, CarryOn, nullptr, [&](const PopulationState& s) { states.push_back(s); });
  return states;
}

void ExpectEqual(const PopulationResult& a, const PopulationResult& b)
{
  EXPECT_TRUE(a.Best.Pack.X == b.Best.Pack.X && a.Best.Pack.Y == b.Best.Pack.Y &&
    a.Best.Pack.Z == b.Best.Pack.Z);
  EXPECT_EQ(a.Best.Objective, b.Best.Objective);
  EXPECT_EQ(a.Best.StartObjective, b.Best.StartObjective);
  EXPECT_EQ(a.Best.EndedBy, b.Best.EndedBy);
  EXPECT_EQ(a.Best.Iterations, b.Best.Iterations);
  EXPECT_TRUE(a.Best.Probability.Values == b.Best.Probability.Values);
  for (const auto& [x, y] : { std::pair(a.Before, b.Before), std::pair(a.After, b.After) })
  {
    EXPECT_EQ(x.Minimum, y.Minimum);
    EXPECT_EQ(x.Mean, y.Mean);
    EXPECT_EQ(x.Maximum, y.Maximum);
  }
  ASSERT_EQ(a.Best.Convergence.size(), b.Best.Convergence.size());
  for (std::size_t n = 0; n < a.Best.Convergence.size(); ++n)
  {
    EXPECT_EQ(a.Best.Convergence[n].Objective, b.Best.Convergence[n].Objective);
    EXPECT_EQ(a.Best.Convergence[n].OverlapPercent, b.Best.Convergence[n].OverlapPercent);
  }
}

// F2 of these centres, by the estimator that made the target
double ObjectiveOf(const std::vector<double>& centres)
{
  const ruc::CellContents& contents = TheSearchProblem().Contents;
  ruc::SpherePack pack;
  std::size_t k = 0;
  for (std::size_t m = 0; m < contents.Count.size(); ++m)
  {
    for (int n = 0; n < contents.Count[m]; ++n, k += 3)
    {
      pack.X.push_back(centres[k]);
      pack.Y.push_back(centres[k + 1]);
      pack.Z.push_back(centres[k + 2]);
      pack.Radius.push_back(contents.Radius[m]);
      pack.Mode.push_back(static_cast<int>(m) + 1);
    }
  }
  return ruc::TwoPointDifference(TheSearchProblem().Target,
    ruc::SumPairs(pack, oracle::PeriodicCube(contents.Edge), TheSearchProblem().Target.Lags));
}

void ExpectConsistent(const PopulationResult& result)
{
  const ruc::CellContents& contents = TheSearchProblem().Contents;
  const ruc::UnitCell& cell = result.Best;
  ASSERT_EQ(cell.Pack.Size(), std::size_t(contents.NumberOfSpheres()));
  EXPECT_GE(oracle::LeastGap(cell.Pack, cell.Box), 0.0);
  EXPECT_TRUE(cell.Overlap.IsNone());
  for (std::size_t i = 0; i < cell.Pack.Size(); ++i)
  {
    EXPECT_EQ(cell.Pack.Radius[i], contents.Radius[cell.Pack.Mode[i] - 1]);
  }
  const ruc::TwoPointProbability probability =
    ruc::SumPairs(cell.Pack, cell.Box, TheSearchProblem().Target.Lags);
  EXPECT_EQ(cell.Objective, ruc::TwoPointDifference(TheSearchProblem().Target, probability));
  EXPECT_EQ(cell.StartObjective, result.Before.Mean);
  for (const ruc::ObjectiveRange& range : { result.Before, result.After })
  {
    EXPECT_LE(range.Minimum, range.Mean);
    EXPECT_LE(range.Mean, range.Maximum);
  }
  ASSERT_EQ(cell.Convergence.size(), std::size_t(cell.Iterations) + 1);
  EXPECT_EQ(cell.Convergence.back().Objective, cell.Objective);
  for (int n = 0; n <= cell.Iterations; ++n)
  {
    EXPECT_EQ(cell.Convergence[n].Iteration, n);
  }
}
}

TEST(PopulationSearch, TheDefaultsAreThePapers)
{
  const PopulationSettings settings;
  EXPECT_EQ(settings.Population, 512);
  EXPECT_EQ(settings.RandomShare, 0.5);
  EXPECT_EQ(settings.MatingPool, 16);
  EXPECT_EQ(settings.MaximumGenerations, 10000);
  EXPECT_EQ(settings.PatienceGenerations, 300);
  ruc::CheckSettings(settings);
  ruc::CheckSettings(ruc::HybridOf({}, {}));
}

TEST(PopulationSearch, TheFirstPopulationIsHalfRandomHalfDeposited)
{
  const PopulationState state = StatesOf(Annealed(0)).at(0);
  const ruc::CellContents& contents = TheSearchProblem().Contents;
  ASSERT_EQ(state.Centres.size(), 12u);
  for (std::uint32_t i = 0; i < 12; ++i)
  {
    EXPECT_EQ(state.Centres[i],
      i < 6 ? ruc::RandomCentres(contents, 1, i)
            : ruc::DepositBallistically(
                contents.Radii(), contents.Edge, 1, i, ruc::DefaultDepositionDegree)
                .Centres);
    const double exact = ObjectiveOf(state.Centres[i]);
    EXPECT_NEAR(state.Objective[i], exact, 1e-3 * exact); // what is asked of the search's tables
  }
  EXPECT_EQ(state.First.Minimum, *std::min_element(state.Objective.begin(), state.Objective.end()));
  EXPECT_EQ(state.First.Maximum, *std::max_element(state.Objective.begin(), state.Objective.end()));
}

TEST(PopulationSearch, FitnessIsEquation15)
{
  PopulationState state;
  state.Objective = { 4.0, 1.0, 2.0, 2.0 };
  state.OverlapPercent = { 0.0, 0.0, 0.5, 0.0 };
  state.First.Maximum = 4.0;
  EXPECT_EQ(state.Fitness(0.5), (std::vector<double>{ 1.0, 0.25, 1.0, 0.5 }));
}

TEST(PopulationSearch, NeverAWorseBestMember)
{
  for (const PopulationSettings& settings :
    { Annealed(40), Annealed(40, 2), Hybrid(12), Hybrid(12, 2) })
  {
    double best = std::numeric_limits<double>::infinity();
    for (const PopulationState& state : StatesOf(settings))
    {
      const std::vector<double> fitness = state.Fitness(settings.HalfOverlap);
      const double now = *std::min_element(fitness.begin(), fitness.end());
      EXPECT_LE(now, best);
      best = now;
    }
  }
}

TEST(PopulationSearch, OnlyTheMatingPoolChangesInAGeneration)
{
  const PopulationSettings settings = Annealed(30);
  const std::vector<PopulationState> states = StatesOf(settings);
  int changed = 0;
  for (std::size_t g = 1; g < states.size(); ++g)
  {
    int now = 0;
    for (int i = 0; i < settings.Population; ++i)
    {
      now += states[g].Centres[i] != states[g - 1].Centres[i];
    }
    EXPECT_LE(now, settings.MatingPool);
    changed += now;
  }
  EXPECT_GT(changed, 0);
}

TEST(PopulationSearch, ChildrenAreTakenAsOftenAsTheTemperatureSays)
{
  // All members are parents, and every child is a cell at random
  PopulationSettings settings = Annealed(150);
  settings.MatingPool = settings.Population;
  settings.OperatorWeights = { 0, 0, 0, 1, 0, 0, 0, 0 };
  settings.MutationShape = 0.0;
  settings.MassSpringProbability = 0.0;
  settings.CoolingFactor = 1.0;
  for (double temperature : { 1e9, 1e-12 })
  {
    settings.InitialTemperature = temperature;
    const std::vector<PopulationState> states = StatesOf(settings);
    int parents = 0, taken = 0, better = 0;
    for (std::size_t g = 1; g < states.size(); ++g)
    {
      const std::vector<double> before = states[g - 1].Fitness(settings.HalfOverlap);
      const std::vector<double> after = states[g].Fitness(settings.HalfOverlap);
      const auto best = std::min_element(before.begin(), before.end());
      if (*std::min_element(after.begin(), after.end()) < *best)
      {
        continue; // a child better than the best is always taken
      }
      for (std::size_t i = 0; i < before.size(); ++i)
      {
        if (i == std::size_t(best - before.begin()))
        {
          EXPECT_EQ(states[g].Centres[i], states[g - 1].Centres[i]);
          continue;
        }
        ++parents;
        taken += states[g].Centres[i] != states[g - 1].Centres[i];
        better += after[i] < before[i];
      }
    }
    ASSERT_GT(parents, 1000);
    if (temperature > 1.0) // 1 / (1 + exp(0)), in 5 standard errors
    {
      EXPECT_NEAR(taken, 0.5 * parents, 2.5 * std::sqrt(parents));
    }
    else
    {
      EXPECT_GT(taken, 0);
      EXPECT_EQ(taken, better);
    }
  }
}

TEST(PopulationSearch, TheTemperatureFallsAndRisesAgain)
{
  const PopulationSettings settings = Annealed(40);
  const std::vector<PopulationState> states = StatesOf(settings);
  EXPECT_EQ(states[0].Temperature, settings.InitialTemperature);
  bool reheated = false;
  for (std::size_t g = 1; g < states.size(); ++g)
  {
    const bool due = states[g].Stagnation > 0 && states[g].Stagnation % 5 == 0;
    EXPECT_EQ(states[g].Temperature,
      due ? settings.InitialTemperature : states[g - 1].Temperature * settings.CoolingFactor);
    reheated = reheated || due;
  }
  EXPECT_TRUE(reheated);
}

TEST(PopulationSearch, ImprovesThePopulation)
{
  for (std::uint32_t seed : { 1u, 2u })
  {
    const PopulationResult result = Search(Annealed(60, seed));
    ExpectConsistent(result);
    EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::MaximumIterations);
    // The mass-spring mutation takes the overlap, most of F2, off every member it meets
    EXPECT_LT(result.After.Mean, 0.5 * result.Before.Mean);
    EXPECT_LT(result.After.Minimum, result.Before.Minimum);
  }
}

TEST(PopulationSearch, RefinementByGradientGoesFarther)
{
  for (std::uint32_t seed : { 1u, 2u })
  {
    const PopulationResult hybrid = Search(Hybrid(10, seed));
    ExpectConsistent(hybrid);
    EXPECT_LT(hybrid.Best.Objective, Search(Annealed(10, seed)).Best.Objective);
  }
}

TEST(PopulationSearch, NoGenerationsGiveTheBestOfTheFirst)
{
  const PopulationResult result = Search(Annealed(0));
  ExpectConsistent(result);
  EXPECT_EQ(result.Best.Convergence.size(), 2u);
  EXPECT_EQ(result.Before.Mean, result.After.Mean);
}

TEST(PopulationSearch, EndsWithoutImprovement)
{
  PopulationSettings settings = Annealed(10000);
  settings.PatienceGenerations = 3;
  settings.MassSpringProbability = 0.0;
  settings.OperatorWeights = { 0, 0, 0, 1, 0, 0, 0, 0 };
  settings.MutationGenerations = 1; // nothing moves from the first generation on
  PopulationState last;
  const PopulationResult result =
    Search(settings, CarryOn, nullptr, [&](const PopulationState& s) { last = s; });
  EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::Converged);
  EXPECT_EQ(last.Stagnation, 3);
}

TEST(PopulationSearch, EndsAtTheTargetObjective)
{
  const double reached = Search(Annealed(30)).Best.Objective;
  PopulationSettings settings = Annealed(1000);
  settings.TargetObjective = 1.1 * reached;
  const PopulationResult result = Search(settings);
  ExpectConsistent(result);
  EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::TargetObjective);
  EXPECT_LE(result.Best.Objective, settings.TargetObjective);
  EXPECT_LE(result.Best.Iterations, 31);
}

TEST(PopulationSearch, StopsWhenItIsTold)
{
  for (const PopulationSettings& settings : { Annealed(100), Hybrid(100) })
  {
    for (int stopAt : { 0, 1, 5 })
    {
      const PopulationResult result =
        Search(settings, [&](const SearchState& state) { return state.Iteration < stopAt; });
      ExpectConsistent(result);
      EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::Stopped);
      EXPECT_EQ(result.Best.Iterations, stopAt + 1); // and the cell
    }
  }
}

TEST(PopulationSearch, IsTheSameForAnyNumberOfRanksAndThreads)
{
  for (const PopulationSettings& settings : { Annealed(12), Hybrid(6) })
  {
    omp_set_num_threads(1);
    const PopulationResult one = Search(settings);
    omp_set_num_threads(3);
    ExpectEqual(one, Search(settings));
    omp_set_num_threads(1);
    for (int ranks : { 1, 2, 3 })
    {
      std::vector<PopulationResult> results(ranks, one);
      oracle::ThreadRanks::Run(ranks,
        [&](ruc::Communicator& communicator)
        {
          results[communicator.Rank()] = ruc::SearchByPopulation(TheSearchProblem().Contents,
            TheSearchProblem().Target, settings, communicator, CarryOn);
        });
      for (const PopulationResult& result : results)
      {
        ExpectEqual(one, result);
      }
    }
  }
}

TEST(PopulationSearch, AWishToStopOfOneRankReachesAll)
{
  oracle::ThreadRanks::Run(3,
    [&](ruc::Communicator& communicator)
    {
      const PopulationResult result = ruc::SearchByPopulation(TheSearchProblem().Contents,
        TheSearchProblem().Target, Annealed(100), communicator,
        [&](const SearchState& state) { return communicator.Rank() != 1 || state.Iteration < 3; });
      EXPECT_EQ(result.Best.EndedBy, ruc::EndReason::Stopped);
      EXPECT_EQ(result.Best.Iterations, 4);
    });
}

TEST(PopulationSearch, ResumesToTheSameEnd)
{
  for (const PopulationSettings& settings : { Annealed(12), Hybrid(8) })
  {
    const PopulationResult whole = Search(settings);
    const std::vector<PopulationState> states = StatesOf(settings);
    for (std::size_t g = 0; g < states.size(); g += 3)
    {
      ExpectEqual(whole, Search(settings, CarryOn, &states[g]));
    }
    oracle::ThreadRanks::Run(2,
      [&](ruc::Communicator& communicator)
      {
        ExpectEqual(whole,
          ruc::SearchByPopulation(TheSearchProblem().Contents, TheSearchProblem().Target, settings,
            communicator, CarryOn, &states[5]));
      });
  }
}

TEST(PopulationSearch, AFinishedSearchIsCarriedOn)
{
  const std::vector<PopulationState> states = StatesOf(Annealed(4));
  ExpectEqual(Search(Annealed(9)), Search(Annealed(9), CarryOn, &states.back()));
}

TEST(PopulationSearch, AStateOfAnotherProblemIsRefused)
{
  PopulationState state = StatesOf(Annealed(0)).at(0);
  PopulationSettings settings = Annealed(5);
  settings.Population = 13;
  EXPECT_SAYS(Search(settings, CarryOn, &state), "Resuming requires a state of 13 members");
  state.Centres[3].pop_back();
  EXPECT_SAYS(Search(Annealed(5), CarryOn, &state), "Resuming requires a state of 12 members");
}

TEST(PopulationSearch, SettingsOutOfRangeAreRefused)
{
  PopulationSettings settings = Annealed(1);
  settings.MatingPool = settings.Population + 1;
  EXPECT_SAYS(Search(settings), "MatingPool requires");
}
