// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// Cells near random close packing: they are found without overlap, and can be stopped and resumed
#include "ruc/Packing/DensePack.h"
#include "ruc/Reconstruction/ContactMultipliers.h"
#include "ruc/Reconstruction/GradientSearch.h"

#include "SearchProblem.h"
#include "ThreadRanks.h"

#include <limits>
#include <random>

namespace
{
// A pack of 600 equal spheres, and a cell of 120
struct DenseProblem
{
  DenseProblem()
    : Made(Make())
    , Contents(ruc::FindCellContents(ruc::SharePack(this->Made.Pack, this->Made.Box), 120))
    , Target(ruc::SumPairs(this->Made.Pack, this->Made.Box, { 0.06, 40 }))
  {
  }

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

ruc::UnitCell Search(
  int iterations, const std::function<bool(const ruc::SearchState&)>& carryOn = CarryOn)
{
  ruc::Communicator serial;
  return Search(serial, iterations, carryOn);
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
  const ruc::UnitCell cell = Search(1000);
  ExpectHard(cell);
  EXPECT_LT(cell.Objective, 0.5 * cell.StartObjective);
  EXPECT_EQ(cell.Objective,
    ruc::TwoPointDifference(
      TheDenseProblem().Target, ruc::SumPairs(cell.Pack, cell.Box, TheDenseProblem().Target.Lags)));
}

TEST(DenseCells, AreHardWhereverTheyAreStopped)
{
  for (int stopAt : { 2, 20, 60, 150, 400 })
  {
    const ruc::UnitCell cell =
      Search(1000, [&](const ruc::SearchState& state) { return state.Iteration < stopAt; });
    EXPECT_EQ(cell.EndedBy, ruc::EndReason::Stopped);
    ExpectHard(cell);
    EXPECT_LE(cell.Objective, cell.StartObjective);
  }
}

TEST(DenseCells, ResumeToTheSameEndOnAnyRanks)
{
  std::vector<ruc::GradientState> states;
  ruc::Communicator serial;
  const ruc::UnitCell whole = Search(serial, 300, CarryOn, nullptr,
    [&](const ruc::GradientState& state) { states.push_back(state); });
  ASSERT_GT(states.size(), 250u);
  ExpectEqual(whole, Search(300));
  EXPECT_GT(states.back().Contacts.Round, 1);
  for (std::size_t n : { std::size_t(3), std::size_t(120), states.size() - 45 })
  {
    ruc::GradientState state;
    ruc::FromBytes(ruc::ToBytes(states[n]), state);
    ExpectEqual(whole, Search(serial, 300, CarryOn, &state));
  }
  for (int ranks : { 2, 3 })
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& all)
      {
        const ruc::UnitCell cell = Search(all, 300, CarryOn, &states[120]);
        if (all.Rank() == ranks - 1)
        {
          ExpectEqual(whole, cell);
        }
      });
  }
}

TEST(DenseCells, AForgedStateIsRefused)
{
  ruc::GradientState good;
  ruc::Communicator serial;
  Search(serial, 300, CarryOn, nullptr, [&](const ruc::GradientState& state) { good = state; });
  ASSERT_FALSE(good.Contacts.First.empty());
  const auto refuses = [&](const std::function<void(ruc::ContactState&)>& forge)
  {
    ruc::GradientState state = good;
    forge(state.Contacts);
    EXPECT_THROW(Search(serial, 300, CarryOn, &state), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses([](ruc::ContactState& contacts) { contacts.Second.back() = 120; });
  refuses([](ruc::ContactState& contacts) { contacts.First.front() = -1; });
  refuses([](ruc::ContactState& contacts) { contacts.Multiplier.pop_back(); });
  refuses([&](ruc::ContactState& contacts) { contacts.Multiplier.front() = nan; });
  refuses([&](ruc::ContactState& contacts) { contacts.Stiffness = nan; });
  refuses([](ruc::ContactState& contacts) { contacts = {}; });
}

// The spheres are hard and as large as they were; what is given up is the fraction
TEST(DenseCells, AreLargerWhereSpheresJam)
{
  ruc::CellContents contents = TheDenseProblem().Contents;
  const double volume = contents.NumberOfSpheres() * oracle::Pi / 6.0;
  contents.Edge = std::cbrt(volume / 0.658);
  ruc::Communicator serial;
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = 50;
  ruc::GradientState last;
  const ruc::UnitCell cell = ruc::SearchByGradient(contents, TheDenseProblem().Target, settings,
    serial, CarryOn, nullptr, [&](const ruc::GradientState& state) { last = state; });
  ExpectHard(cell);
  EXPECT_EQ(cell.Pack.Radius, contents.Radii());
  const double fraction = volume / std::pow(cell.Box.Size[0], 3);
  EXPECT_LT(fraction, 0.6579);
  EXPECT_GT(fraction, 0.60);
  EXPECT_EQ(cell.Box.Size[0], cell.Box.Size[2]);
  settings.MaximumIterations = 60;
  ExpectEqual(ruc::SearchByGradient(contents, TheDenseProblem().Target, settings, serial, CarryOn),
    ruc::SearchByGradient(contents, TheDenseProblem().Target, settings, serial, CarryOn, &last));
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
