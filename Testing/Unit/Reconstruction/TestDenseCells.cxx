// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells near random close packing: they are found without overlap, and can be stopped and resumed
#include "ruc/Packing/DensePack.h"
#include "ruc/Reconstruction/ContactMultipliers.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/Population/PopulationSearch.h"

#include "SearchProblem.h"
#include "ThreadRanks.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace
{
// A pack of 600 equal spheres, and a cell of 60
struct DenseProblem
{
  DenseProblem()
    : Made(Make())
    , Contents(ruc::FindCellContents(ruc::SharePack(this->Made.Pack, this->Made.Box), Spheres))
    , Target(ruc::SumPairs(this->Made.Pack, this->Made.Box, { 0.06, 40 }))
  {
  }

  static constexpr int Spheres = 60;
  static ruc::DensePack Make()
  {
    ruc::DensePackSettings settings;
    settings.Radii.assign(600, 0.5);
    settings.Fraction = 0.635;
    ruc::DensePack made =
      ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
    made.Pack.Mode.assign(600, 1);
    return made;
  }

  ruc::DensePack Made;
  ruc::CellContents Contents;
  ruc::TwoPointProbability Target;
};

const DenseProblem& TheDenseProblem()
{
  static const DenseProblem problem;
  return problem;
}

ruc::UnitCell Search(ruc::Communicator& ranks, int iterations,
  const std::function<bool(const ruc::SearchState&)>& carryOn,
  const ruc::GradientState* resume = nullptr,
  const std::function<void(const ruc::GradientState&)>& save = {})
{
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = iterations;
  return ruc::SearchByGradient(
    TheDenseProblem().Contents, TheDenseProblem().Target, settings, ranks, carryOn, resume, save);
}

// A search to its very end, and its states on the way. How many iterations it takes depends on the
// last bits of a machine's logarithms and cosines, so no test knows their number.
struct WholeSearch
{
  static constexpr int MostIterations = 20000, Every = 10;

  WholeSearch()
  {
    ruc::Communicator serial;
    this->Cell.emplace(Search(serial, MostIterations, CarryOn, nullptr,
      [&](const ruc::GradientState& state)
      {
        if (state.Descent.Iterations % Every == 0)
        {
          this->States.push_back(state);
        }
      }));
  }

  std::vector<ruc::GradientState> States;
  std::optional<ruc::UnitCell> Cell;
};

const WholeSearch& TheWholeSearch()
{
  static const WholeSearch search;
  return search;
}

// Every pair, every nearest image
void ExpectHard(const ruc::UnitCell& cell)
{
  EXPECT_TRUE(cell.Overlap.IsNone());
  for (std::size_t i = 0; i < cell.Pack.Size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      double squares = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        double d = cell.Pack.Centre(i)[q] - cell.Pack.Centre(j)[q];
        d -= cell.Box.Size[q] * std::round(d / cell.Box.Size[q]);
        squares += d * d;
      }
      EXPECT_GE(std::sqrt(squares), cell.Pack.Radius[i] + cell.Pack.Radius[j]);
    }
  }
}
}

TEST(ContactMultipliers, TwoSpheres)
{
  ruc::SpherePack pack;
  pack.X = { 9.9, 0.7 }; // 0.8 apart through the face
  pack.Y = pack.Z = { 5.0, 5.0 };
  pack.Radius = { 0.5, 0.5 };
  const std::vector<double> centres = ruc::CentresOf(pack);
  ruc::ContactState state;
  state.Stiffness = 4.0;
  ruc::ContactMultipliers contacts(pack, oracle::PeriodicCube(10.0), state);
  std::vector<double> gradient(6, 0.0);
  // max(0, mu o)^2 / (2 mu) with the relative overlap o
  EXPECT_NEAR(contacts.Add(centres.data(), gradient.data()), 0.5 * 4.0 * 0.04, 1e-7);
  EXPECT_NEAR(gradient[0], 4.0 * 0.2, 1e-6); // towards the other sphere it grows
  EXPECT_NEAR(gradient[3], -4.0 * 0.2, 1e-6);
  EXPECT_NEAR(contacts.Update(centres.data()), 0.2, 1e-7);
  ASSERT_EQ(state.Multiplier.size(), 1u);
  EXPECT_NEAR(state.Multiplier[0], 0.8, 1e-7);
  // (lambda + mu o)^2 - lambda^2, over 2 mu
  EXPECT_NEAR(contacts.Add(centres.data(), nullptr), (1.6 * 1.6 - 0.64) / 8.0, 1e-6);
  // Apart, the pair presses no longer, and adds the constant until the next round
  std::vector<double> apart = centres;
  apart[3] = 3.0;
  EXPECT_NEAR(contacts.Add(apart.data(), nullptr), -0.64 / 8.0, 1e-6);
  EXPECT_EQ(contacts.Update(apart.data()), 0.0);
  EXPECT_TRUE(state.Multiplier.empty());
  EXPECT_EQ(contacts.Add(apart.data(), nullptr), 0.0);
}

TEST(ContactMultipliers, GradientIsThatOfTheSum)
{
  const ruc::Window box = oracle::PeriodicCube(6.0);
  ruc::SpherePack pack = oracle::RandomPack({ 40, 40 }, { 0.8, 0.5 }, box, 3);
  std::vector<double> centres = ruc::CentresOf(pack);
  ruc::ContactState state;
  state.Stiffness = 2.0;
  ruc::ContactMultipliers contacts(pack, box, state);
  contacts.Update(centres.data());
  std::vector<double> gradient(centres.size(), 0.0);
  const double value = contacts.Add(centres.data(), gradient.data());
  EXPECT_GT(value, 0.0);
  // Another object, with other lists, gives the same bits
  ruc::ContactState copy = state;
  ruc::ContactMultipliers again(pack, box, copy);
  std::vector<double> elsewhere = centres;
  elsewhere[0] += 3.0;
  again.Add(elsewhere.data(), nullptr);
  EXPECT_EQ(again.Add(centres.data(), nullptr), value);
  for (std::size_t n = 0; n < centres.size(); n += 7)
  {
    constexpr double h = 1e-6;
    std::vector<double> more = centres, less = centres;
    more[n] += h;
    less[n] -= h;
    const double expected =
      (contacts.Add(more.data(), nullptr) - contacts.Add(less.data(), nullptr)) / (2.0 * h);
    EXPECT_NEAR(gradient[n], expected, 1e-5 * (1.0 + std::abs(expected)));
  }
}

TEST(DenseCells, AreHardAndNearerThanTheirStart)
{
  const ruc::UnitCell& cell = *TheWholeSearch().Cell;
  EXPECT_EQ(cell.EndedBy, ruc::EndReason::Converged);
  ExpectHard(cell);
  EXPECT_LT(cell.Objective, 0.5 * cell.StartObjective);
  EXPECT_EQ(cell.Objective,
    ruc::TwoPointDifference(
      TheDenseProblem().Target, ruc::SumPairs(cell.Pack, cell.Box, TheDenseProblem().Target.Lags)));
}

// What the ban on overlap costs is told once there are multipliers
TEST(DenseCells, TellTheSumOfTheMultipliers)
{
  const WholeSearch& whole = TheWholeSearch();
  EXPECT_EQ(whole.Cell->Convergence.front().SumOfMultipliers, 0.0);
  // At the end of a round they are changed after the iteration is told
  const auto withinRound = std::find_if(whole.States.rbegin(), whole.States.rend(),
    [](const ruc::GradientState& state) { return state.Descent.Iterations % 40 == 20; });
  ASSERT_NE(withinRound, whole.States.rend());
  const std::vector<double>& multipliers = withinRound->Contacts.Multiplier;
  EXPECT_EQ(withinRound->Convergence.back().SumOfMultipliers,
    std::accumulate(multipliers.begin(), multipliers.end(), 0.0));
  EXPECT_GT(whole.Cell->Convergence.back().SumOfMultipliers, 0.0);
}

TEST(DenseCells, AreNoneOfAPopulation)
{
  ruc::CellContents contents = TheDenseProblem().Contents;
  try
  {
    ruc::RequireLoose(contents);
    ADD_FAILURE();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("Method requires Gradient"), std::string::npos)
      << error.what();
  }
  contents.Edge *= 1.02; // a fraction of 0.598
  EXPECT_NO_THROW(ruc::RequireLoose(contents));
}

TEST(DenseCells, AreHardWhereverTheyAreStopped)
{
  ruc::Communicator serial;
  const int all = TheWholeSearch().Cell->Iterations;
  for (int stopAt : { 2, 20, all / 4, all / 2, all - 5 })
  {
    const ruc::UnitCell cell = Search(serial, WholeSearch::MostIterations,
      [&](const ruc::SearchState& state) { return state.Iteration < stopAt; });
    EXPECT_EQ(cell.EndedBy, ruc::EndReason::Stopped);
    ExpectHard(cell);
    EXPECT_LE(cell.Objective, cell.StartObjective);
  }
}

// From its soft stage, from the first rounds of multipliers, and from the last
TEST(DenseCells, ResumeToTheSameEndOnAnyRanks)
{
  const WholeSearch& whole = TheWholeSearch();
  const auto hasMultipliers = [](const ruc::GradientState& state)
  { return !state.Contacts.Multiplier.empty(); };
  const auto first = std::find_if(whole.States.begin(), whole.States.end(), hasMultipliers);
  ASSERT_NE(first, whole.States.end());
  ASSERT_EQ(whole.States.front().Contacts.Round, 0);
  ruc::Communicator serial;
  for (const ruc::GradientState& saved : { whole.States.front(), *first, whole.States.back() })
  {
    ruc::GradientState state;
    ruc::FromBytes(ruc::ToBytes(saved), state);
    ExpectEqual(*whole.Cell, Search(serial, WholeSearch::MostIterations, CarryOn, &state));
  }
  // A few iterations more, across the end of a round
  const int iterations = first->Descent.Iterations + 45;
  const ruc::UnitCell some = Search(serial, iterations, CarryOn, &*first);
  for (int ranks : { 2, 3 })
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& all)
      {
        const ruc::UnitCell cell = Search(all, iterations, CarryOn, &*first);
        if (all.Rank() == ranks - 1)
        {
          ExpectEqual(some, cell);
        }
      });
  }
}

TEST(DenseCells, AForgedStateIsRefused)
{
  const ruc::GradientState& good = TheWholeSearch().States.back();
  ruc::Communicator serial;
  ASSERT_FALSE(good.Contacts.First.empty());
  const auto refuses = [&](const std::function<void(ruc::ContactState&)>& forge)
  {
    ruc::GradientState state = good;
    forge(state.Contacts);
    EXPECT_THROW(
      Search(serial, WholeSearch::MostIterations, CarryOn, &state), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses([](ruc::ContactState& contacts) { contacts.Second.back() = DenseProblem::Spheres; });
  refuses([](ruc::ContactState& contacts) { contacts.First.front() = -1; });
  refuses([](ruc::ContactState& contacts) { contacts.Multiplier.pop_back(); });
  refuses([&](ruc::ContactState& contacts) { contacts.Multiplier.front() = nan; });
  refuses([&](ruc::ContactState& contacts) { contacts.Stiffness = nan; });
  refuses([](ruc::ContactState& contacts) { contacts = {}; });
}

// The spheres are hard and as large as they were; what is given up is the fraction. 18 spheres jam
// in a periodic cube at 0.645, from whatever places they begin.
TEST(DenseCells, AreLargerWhereSpheresJam)
{
  const DenseProblem& problem = TheDenseProblem();
  ruc::CellContents contents =
    ruc::FindCellContents(ruc::SharePack(problem.Made.Pack, problem.Made.Box), 18);
  const double volume = contents.NumberOfSpheres() * oracle::Pi / 6.0;
  contents.Edge = std::cbrt(volume / 0.658);
  ruc::Communicator serial;
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = 60;
  ruc::GradientState middle;
  const ruc::UnitCell cell =
    ruc::SearchByGradient(contents, problem.Target, settings, serial, CarryOn, nullptr,
      [&](const ruc::GradientState& state)
      { middle = middle.Descent.Iterations < 20 ? state : middle; });
  ExpectHard(cell);
  EXPECT_EQ(cell.Pack.Radius, contents.Radii());
  const double fraction = volume / std::pow(cell.Box.Size[0], 3);
  EXPECT_LT(fraction, 0.655);
  EXPECT_GT(fraction, 0.635);
  EXPECT_EQ(cell.Box.Size[0], cell.Box.Size[2]);
  ExpectEqual(
    cell, ruc::SearchByGradient(contents, problem.Target, settings, serial, CarryOn, &middle));
}

TEST(DenseCells, TooDenseIsRefusedAtOnce)
{
  ruc::CellContents contents = TheDenseProblem().Contents;
  contents.Edge *= 0.95; // a fraction of 0.74
  ruc::Communicator serial;
  try
  {
    ruc::SearchByGradient(contents, TheDenseProblem().Target, {}, serial, CarryOn);
    ADD_FAILURE();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("(about 0.64"), std::string::npos) << error.what();
  }
}
