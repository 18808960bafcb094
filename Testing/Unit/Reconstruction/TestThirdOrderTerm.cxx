// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/ThirdOrderTerm.h"
#include "TermProblem.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/SearchCheckpoint.h"

namespace
{
using ruc::NeighbourhoodMultipoles;

ruc::NeighbourhoodSettings FewShells()
{
  ruc::NeighbourhoodSettings settings = ruc::GradientSearchSettings().ThirdOrder;
  settings.Distances = { 0.08, 0.4, 0.9 };
  settings.Degree = 5;
  settings.LeastCentres = 1;
  return settings;
}

NeighbourhoodMultipoles Measure(const ruc::SpherePack& pack, const ruc::Window& window)
{
  ruc::Communicator alone;
  return ruc::MeasureNeighbourhoods(ruc::SharePack(pack, window), FewShells(), alone);
}

struct Problem : TermProblem
{
  Problem()
    : Pack(Measure(this->Made.Pack, this->Made.Box))
  {
  }
  NeighbourhoodMultipoles Pack;
};

const Problem& TheProblem()
{
  static const Problem problem;
  return problem;
}

double Evaluate(
  const ruc::CellContents& contents, const std::vector<double>& centres, double* gradient = nullptr)
{
  ruc::Communicator alone;
  return ruc::ThirdOrderTerm(contents, TheProblem().Pack, alone)
    .Evaluate(centres.data(), 1.0, gradient);
}

ruc::GradientSearchSettings Settings(int iterations)
{
  ruc::GradientSearchSettings settings;
  settings.MaximumIterations = iterations;
  settings.Neighbours.ThirdOrderWeight = 1.0;
  settings.Neighbours.ThirdOrder = TheProblem().Pack;
  return settings;
}

ruc::UnitCell Search(const ruc::GradientSearchSettings& settings)
{
  ruc::Communicator alone;
  return ruc::SearchByGradient(
    TheProblem().Contents, TheProblem().Target, settings, alone, CarryOn);
}
}

// The cell measured as a pack of its own
TEST(ThirdOrderTerm, IsTheMeanSquareInStandardErrors)
{
  const Problem& problem = TheProblem();
  const std::vector<double> centres = problem.SomeCentres();
  const NeighbourhoodMultipoles cell =
    Measure(problem.Contents.MakePack(centres.data()), problem.Contents.MakeBox());
  ASSERT_EQ(cell.Value.size(), problem.Pack.Value.size());
  double misfit = 0.0;
  for (std::size_t n = 0; n < cell.Value.size(); ++n)
  {
    ASSERT_GT(problem.Pack.Error[n], 0.0);
    misfit += std::pow((cell.Value[n] - problem.Pack.Value[n]) / problem.Pack.Error[n], 2) /
      cell.Value.size();
  }
  EXPECT_GT(misfit, 5.0);
  EXPECT_NEAR(Evaluate(problem.Contents, centres), misfit, 1e-8 * misfit);
}

TEST(ThirdOrderTerm, ThePackFitsItself)
{
  ruc::CellContents contents = TheProblem().PackAsCell;
  EXPECT_LT(Evaluate(contents, ruc::CentresOf(TheProblem().Made.Pack)), 1e-12);
  // As types of its modes, of which there are more
  contents.Count = { 20, 30, 30, 150, 50 };
  contents.Radius = { 1.0, 1.0, 1.0, 0.6, 0.6 };
  contents.Mode = { 1, 1, 1, 2, 2 };
  EXPECT_LT(Evaluate(contents, ruc::CentresOf(TheProblem().Made.Pack)), 1e-12);
}

// Spheres that overlap, and images of themselves, give a number
TEST(ThirdOrderTerm, CrowdedAndSmallCells)
{
  const ruc::CellContents& contents = TheProblem().Contents;
  std::vector<double> gradient(3 * contents.NumberOfSpheres(), 0.0);
  EXPECT_TRUE(
    std::isfinite(Evaluate(contents, ruc::RandomCentres(contents, 5, 0), gradient.data())));
  EXPECT_TRUE(std::all_of(
    gradient.begin(), gradient.end(), [](double slope) { return std::isfinite(slope); }));
  ruc::CellContents few = contents;
  few.Count = { 1, 1 };
  few.Edge = 2.4;
  EXPECT_TRUE(std::isfinite(Evaluate(few, { 0.1, 0.2, 0.3, 1.3, 1.4, 1.5 }, gradient.data())));
}

// Where a cap just begins its slope has a kink, or its curvature is large
TEST(ThirdOrderTerm, GradientIsThatOfTheValue)
{
  ExpectGradientOfValue(TheProblem().SomeCentres(), 7, 1e-6, 1e-4,
    [](const std::vector<double>& centres, double* gradient)
    { return Evaluate(TheProblem().Contents, centres, gradient); });
}

TEST(ThirdOrderTerm, IsTheSameOnAnyRanksAndThreads)
{
  const Problem& problem = TheProblem();
  const std::vector<double> centres = problem.SomeCentres();
  ExpectSameOnAnyRanks(centres.size(),
    [&](ruc::Communicator& ranks, double* gradient)
    {
      return ruc::ThirdOrderTerm(problem.Contents, problem.Pack, ranks)
        .Evaluate(centres.data(), 1.0, gradient);
    });
}

TEST(ThirdOrderTerm, IsTheSameWhereNothingIsKept)
{
  const Problem& problem = TheProblem();
  const std::vector<double> centres = problem.SomeCentres();
  ruc::Communicator alone;
  std::vector<double> expected(centres.size(), 0.0), gradient = expected;
  const double value = Evaluate(problem.Contents, centres, expected.data());
  ruc::ThirdOrderTerm term(problem.Contents, problem.Pack, alone, 0);
  EXPECT_EQ(term.Evaluate(centres.data(), 1.0, gradient.data()), value);
  EXPECT_TRUE(gradient == expected);
}

TEST(ThirdOrderTerm, BringsThirdOrderNear)
{
  const ruc::UnitCell cell = Search(Settings(70));
  EXPECT_TRUE(cell.Overlap.IsNone());
  ruc::GradientSearchSettings plain = Settings(105);
  plain.Neighbours = {};
  const double without = Evaluate(TheProblem().Contents, ruc::CentresOf(Search(plain).Pack));
  const double with = cell.Convergence.back().Misfits.ThirdOrder;
  EXPECT_LT(with, 0.5 * without);
  EXPECT_EQ(with, Evaluate(TheProblem().Contents, ruc::CentresOf(cell.Pack)));
}

TEST(ThirdOrderTerm, OffIsAsIfItDidNotExist)
{
  ruc::GradientSearchSettings off = Settings(30), none = Settings(30);
  off.Neighbours.ThirdOrderWeight = 0.0;
  none.Neighbours = {};
  ExpectEqual(Search(off), Search(none));
}

TEST(ThirdOrderTerm, BelongsToTheKeyOfACheckpoint)
{
  const Problem& problem = TheProblem();
  ruc::GradientSearchSettings settings = Settings(3), other = settings;
  other.Neighbours.ThirdOrder.Value[5] *= 1.01;
  const auto key = [&](const ruc::GradientSearchSettings& of)
  { return ruc::MakeKey(problem.Contents, problem.Target, of); };
  EXPECT_NE(key(settings).Target, key(other).Target);
  EXPECT_EQ(key(settings).Settings, key(other).Settings);
  other.Neighbours.ThirdOrderWeight = 2.0;
  EXPECT_NE(key(settings).Settings, key(other).Settings);
}
