// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadRanks.h"
#include "HardPack.h"
#include "SearchProblem.h"
#include "ruc/Packing/DensePack.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/SearchCheckpoint.h"

namespace
{
using ruc::HingeSums;
using ruc::NeighbourMisfits;
using ruc::NeighbourTarget;

// Hard spheres after some collisions, a cell of a quarter of them, and their near neighbours
struct Problem
{
  Problem()
    : Made(80, 200, 0.45)
    , Pack(Made.Pack)
    , Box(Made.Box)
  {
    this->Contents = ruc::FindCellContents(ruc::SharePack(this->Pack, this->Box), 70);
    this->Target = ruc::SumPairs(this->Pack, this->Box, { 0.15, 20 });
    ruc::Communicator alone;
    this->Neighbours.ContactWeight = this->Neighbours.PoreWeight = 1.0;
    this->Neighbours.Pack = ruc::MeasureNeighbourSums(ruc::SharePack(this->Pack, this->Box), alone);
  }
  HardPack Made;
  const ruc::SpherePack& Pack;
  const ruc::Window& Box;
  ruc::CellContents Contents;
  ruc::TwoPointProbability Target{ 1, { 1.0, 1 } };
  NeighbourTarget Neighbours;
};

const Problem& TheProblem()
{
  static const Problem problem;
  return problem;
}

std::vector<double> LooseCentres()
{
  const ruc::CellContents& contents = TheProblem().Contents;
  ruc::SpherePack pack = contents.MakePack(ruc::RandomCentres(contents, 5, 0).data());
  ruc::RemoveOverlap(pack, contents.MakeBox(), 5, []() { return true; });
  return ruc::CentresOf(pack);
}

ruc::GradientSearchSettings Settings(int iterations)
{
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = iterations;
  settings.Neighbours = TheProblem().Neighbours;
  return settings;
}

ruc::UnitCell Search(const ruc::GradientSearchSettings& settings, ruc::Communicator& ranks,
  const ruc::GradientState* resume = nullptr,
  const std::function<void(const ruc::GradientState&)>& save = {})
{
  return ruc::SearchByGradient(
    TheProblem().Contents, TheProblem().Target, settings, ranks, CarryOn, resume, save);
}

NeighbourMisfits MisfitsOf(const ruc::SpherePack& pack, const ruc::CellContents& contents)
{
  ruc::Communicator alone;
  ruc::ContactState none;
  ruc::SearchObjective objective(
    contents, TheProblem().Target, TheProblem().Neighbours, false, none, alone);
  objective.BeginNeighbours(1.0);
  return objective.FindMisfits(ruc::CentresOf(pack).data());
}

// The pack is itself a periodic cell, so its own misfits are those of the bins and of the lattice
TEST(NeighbourTerms, ThePackFitsItself)
{
  ruc::CellContents contents = TheProblem().Contents;
  contents.Count = { 80, 200 };
  contents.Radius = { 1.0, 0.6 };
  contents.Edge = TheProblem().Box.Size[0];
  const NeighbourMisfits misfits = MisfitsOf(TheProblem().Pack, contents);
  EXPECT_LT(misfits.Gaps, 1e-3);
  EXPECT_LT(misfits.Nearest, 1e-3);
  EXPECT_LT(misfits.Pores, 2.0);
  // Another cell, of random centres without overlap, does not
  const ruc::CellContents& small = TheProblem().Contents;
  const NeighbourMisfits other = MisfitsOf(small.MakePack(LooseCentres().data()), small);
  EXPECT_GT(other.Gaps, 10.0);
}

// Where no pair passes a threshold and no point changes its sphere within the step, the terms are
// smooth but for the roundings of the distances of the pores
TEST(NeighbourTerms, GradientIsThatOfTheValue)
{
  const std::vector<double> centres = LooseCentres();
  const Problem& problem = TheProblem();
  for (double pores : { 0.0, 1.0 })
  {
    NeighbourTarget neighbours = problem.Neighbours;
    neighbours.ContactWeight = 1.0 - pores;
    neighbours.PoreWeight = pores;
    ruc::Communicator alone;
    ruc::ContactState none;
    ruc::SearchObjective objective(
      problem.Contents, problem.Target, neighbours, false, none, alone);
    objective.BeginNeighbours(0.02);
    std::vector<double> gradient(centres.size()), ignored(centres.size());
    objective.Evaluate(centres.data(), gradient.data(), nullptr);
    oracle::Uniform random(21);
    std::vector<double> along;
    for (std::size_t n = 0; n < centres.size(); ++n)
    {
      along.push_back(random(-1.0, 1.0));
    }
    const auto valueAt = [&](double step)
    {
      std::vector<double> place = centres;
      for (std::size_t n = 0; n < place.size(); ++n)
      {
        place[n] += step * along[n];
      }
      return objective.Evaluate(place.data(), nullptr, nullptr).Total;
    };
    const double slope = std::inner_product(gradient.begin(), gradient.end(), along.begin(), 0.0);
    const double step = pores > 0.0 ? 2e-4 : 1e-6;
    EXPECT_NEAR((valueAt(step) - valueAt(-step)) / (2.0 * step), slope, 2e-3 * std::abs(slope));
  }
}

TEST(NeighbourTerms, AreTheSameOnAnyRanks)
{
  const std::vector<double> centres = LooseCentres();
  const Problem& problem = TheProblem();
  std::vector<double> expected(centres.size());
  double total = 0.0;
  for (int ranks = 1; ranks <= 4; ++ranks)
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        ruc::ContactState none;
        ruc::SearchObjective objective(
          problem.Contents, problem.Target, problem.Neighbours, false, none, communicator);
        objective.BeginNeighbours(0.02);
        objective.MoveLattice(2);
        std::vector<double> gradient(centres.size());
        const auto terms = objective.Evaluate(centres.data(), gradient.data(), nullptr);
        if (ranks == 1)
        {
          expected = gradient;
          total = terms.Total;
        }
        EXPECT_TRUE(gradient == expected);
        EXPECT_EQ(terms.Total, total);
      });
  }
}

TEST(NeighbourTerms, BringNeighboursAndPoresNear)
{
  ruc::Communicator alone;
  const ruc::UnitCell cell = Search(Settings(60), alone);
  EXPECT_TRUE(cell.Overlap.IsNone());
  ruc::GradientSearchSettings plain = Settings(60);
  plain.Neighbours = {};
  const ruc::UnitCell other = Search(plain, alone);
  const NeighbourMisfits with = MisfitsOf(cell.Pack, TheProblem().Contents);
  const NeighbourMisfits without = MisfitsOf(other.Pack, TheProblem().Contents);
  EXPECT_LT(with.Gaps, 0.1 * without.Gaps);
  EXPECT_LT(with.Nearest, 0.1 * without.Nearest);
  EXPECT_LT(cell.Objective, 2.0 * other.Objective);
  EXPECT_EQ(cell.Convergence.back().Objective, cell.Objective);
  EXPECT_LE(static_cast<int>(cell.Convergence.size()), 36 + 54 + 4);
}

TEST(NeighbourTerms, OffAreAsIfTheyDidNotExist)
{
  ruc::Communicator alone;
  ruc::GradientSearchSettings off = Settings(30), none = Settings(30);
  off.Neighbours.ContactWeight = off.Neighbours.PoreWeight = 0.0;
  none.Neighbours = {};
  ExpectEqual(Search(off, alone), Search(none, alone));
}

TEST(NeighbourTerms, ResumeToTheSameEndOnAnyRanks)
{
  const ruc::GradientSearchSettings settings = Settings(50);
  const ruc::SearchKey key = ruc::MakeKey(TheProblem().Contents, TheProblem().Target, settings);
  std::vector<std::string> states;
  ruc::Communicator alone;
  const ruc::UnitCell whole = Search(settings, alone, nullptr,
    [&](const ruc::GradientState& state) { states.push_back(ruc::WriteCheckpoint(state, key)); });
  ASSERT_EQ(states.size(), 75u); // 30 of F2 alone, and 20, 20 and 5 with three lattices
  for (std::size_t n : { 5, 29, 40, 49, 50, 74 })
  {
    const ruc::GradientState state = ruc::ReadGradientCheckpoint(states[n], key);
    const int ranks = 1 + static_cast<int>(n % 3);
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      { ExpectEqual(Search(settings, communicator, &state), whole); });
  }
}

// What a state holds of its function is that of its own lattice, whatever the settings are then
TEST(NeighbourTerms, MoreIterationsGoOnWithTheLatticeOfTheState)
{
  ruc::Communicator alone;
  std::vector<ruc::GradientState> states;
  const ruc::UnitCell whole = Search(Settings(40), alone, nullptr,
    [&](const ruc::GradientState& state) { states.push_back(state); });
  const auto second = std::find_if(states.begin(), states.end(),
    [](const ruc::GradientState& state)
    { return state.Lattice == 1 && !state.Descent.Gradient.empty(); });
  ASSERT_NE(second, states.end());
  const ruc::UnitCell more = Search(Settings(60), alone, &*second);
  const std::size_t next = second->Convergence.size();
  ASSERT_LT(next, more.Convergence.size());
  EXPECT_EQ(more.Convergence[next].Objective, whole.Convergence[next].Objective);
  EXPECT_EQ(more.Convergence[next].Misfits.Pores, whole.Convergence[next].Misfits.Pores);
}

TEST(NeighbourTerms, AStateOfAnotherPackOrAForgedOneIsRefused)
{
  const Problem& problem = TheProblem();
  ruc::GradientSearchSettings settings = Settings(6);
  const ruc::SearchKey key = ruc::MakeKey(problem.Contents, problem.Target, settings);
  ruc::GradientState last;
  ruc::Communicator alone;
  Search(settings, alone, nullptr, [&](const ruc::GradientState& state) { last = state; });
  const std::string bytes = ruc::WriteCheckpoint(last, key);
  settings.Neighbours.Pack.Gaps.Value[3] *= 1.01;
  EXPECT_SAYS(
    ruc::ReadGradientCheckpoint(bytes, ruc::MakeKey(problem.Contents, problem.Target, settings)),
    "target differs");
  settings = Settings(6);
  settings.Neighbours.PoreWeight = 0.5;
  EXPECT_SAYS(
    ruc::ReadGradientCheckpoint(bytes, ruc::MakeKey(problem.Contents, problem.Target, settings)),
    "settings or seed differ");
  settings = Settings(6);
  for (double reference : { -1.0, std::nan(""), 1e300 })
  {
    ruc::GradientState forged = last;
    forged.Reference = reference;
    EXPECT_SAYS(Search(settings, alone, &forged), "near neighbours of the state are damaged");
  }
  for (auto number : { &ruc::GradientState::Before, &ruc::GradientState::Lattice })
  {
    for (int value : { -1, 100000 })
    {
      ruc::GradientState forged = last;
      forged.*number = value;
      EXPECT_SAYS(Search(settings, alone, &forged), "near neighbours of the state are damaged");
    }
  }
}

TEST(NeighbourTerms, TheTargetObjectiveWaitsForTheMisfits)
{
  ruc::Communicator alone;
  ruc::GradientSearchSettings settings = Settings(200);
  settings.TargetObjective = 0.4;
  const ruc::UnitCell cell = Search(settings, alone);
  ASSERT_EQ(cell.EndedBy, ruc::EndReason::TargetObjective);
  EXPECT_LE(cell.Objective, 0.4);
  EXPECT_LE(cell.Convergence.back().Misfits.Largest(), 1.0);
  EXPECT_LT(cell.Iterations, 300);
}

// Between its soft contacts and the multipliers
TEST(NeighbourTerms, ADenseCellHasThemToo)
{
  ruc::DensePackSettings made;
  made.Radii.assign(600, 0.5);
  made.Fraction = 0.63;
  made.Protocol = ruc::PackingProtocol::Events;
  ruc::DensePack pack =
    ruc::MakeDensePack(made, [](const ruc::GrowthStep&, double) { return true; });
  pack.Pack.Mode.assign(600, 1);
  const ruc::PackShare share = ruc::SharePack(pack.Pack, pack.Box);
  const ruc::CellContents contents = ruc::FindCellContents(share, 60);
  ASSERT_TRUE(ruc::IsDense(contents.Radii(), contents.Fraction(), contents.Edge));
  const ruc::TwoPointProbability target = ruc::SumPairs(pack.Pack, pack.Box, { 0.06, 40 });
  ruc::Communicator alone;
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = 2000;
  settings.Neighbours.Pack = ruc::MeasureNeighbourSums(share, alone);
  const ruc::UnitCell plain = ruc::SearchByGradient(contents, target, settings, alone, CarryOn);
  settings.Neighbours.ContactWeight = settings.Neighbours.PoreWeight = 1.0;
  const ruc::UnitCell cell = ruc::SearchByGradient(contents, target, settings, alone, CarryOn);
  EXPECT_TRUE(cell.Overlap.IsNone());
  ruc::ContactState none;
  ruc::SearchObjective objective(contents, target, settings.Neighbours, false, none, alone);
  const NeighbourMisfits with = objective.FindMisfits(ruc::CentresOf(cell.Pack).data());
  const NeighbourMisfits without = objective.FindMisfits(ruc::CentresOf(plain.Pack).data());
  EXPECT_LT(with.Nearest, 0.3 * without.Nearest);
  EXPECT_LT(with.Gaps, without.Gaps);
}
}
