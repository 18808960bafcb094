// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellObjective.h"

#include "Oracles.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <omp.h>

namespace
{
using ruc::CellContents;
using ruc::CellObjective;
using ruc::TwoPointProbability;

CellContents Contents()
{
  CellContents contents;
  contents.Count = { 12, 28 };
  contents.Radius = { 1.0, 0.6 };
  contents.Edge = 6.0;
  return contents;
}

// The target of another pack with the same contents
TwoPointProbability Target(const ruc::LagGrid& lags)
{
  const ruc::Window box = oracle::PeriodicCube(6.0);
  return ruc::SumPairs(oracle::RelaxedPack({ 12, 28 }, { 1.0, 0.6 }, box, 50), box, lags);
}

std::vector<double> Centres(std::uint64_t seed, bool relaxed)
{
  const ruc::Window box = oracle::PeriodicCube(6.0);
  ruc::SpherePack pack = oracle::RandomPack({ 12, 28 }, { 1.0, 0.6 }, box, seed);
  if (relaxed)
  {
    EXPECT_TRUE(ruc::RemoveOverlap(pack, box, 1, []() { return true; }));
  }
  std::vector<double> centres;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    centres.insert(centres.end(), { pack.X[i], pack.Y[i], pack.Z[i] });
  }
  return centres;
}

const ruc::LagGrid Fine = { 0.05, 60 }, Coarse = { 0.5, 6 };
}

TEST(CellObjective, AgreesWithTheFinerTablesOfThePairSum)
{
  ruc::Communicator serial;
  for (const ruc::LagGrid& lags : { Fine, Coarse })
  {
    const TwoPointProbability target = Target(lags);
    CellObjective objective(Contents(), target, serial);
    for (bool relaxed : { false, true })
    {
      const std::vector<double> centres = Centres(51, relaxed);
      const double exact = ruc::TwoPointDifference(
        target, ruc::SumPairs(Contents().MakePack(centres.data()), Contents().MakeBox(), lags));
      EXPECT_GT(exact, 0.01);
      // The tables have knots 1/4 of the smaller radius apart; the search asks them for 1e-3 of F2
      EXPECT_NEAR(objective.Evaluate(centres.data(), nullptr).TwoPoint, exact, 1e-3 * exact)
        << relaxed;
    }
  }
}

TEST(CellObjective, LagZeroHoldsTheOverlap)
{
  // Every pair that overlaps adds its lens twice to the sum of S_rs(0): the search reads its
  // overlap in percent from it.
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Fine);
  CellObjective objective(Contents(), target, serial);
  const std::vector<double> centres = Centres(60, false);
  objective.Evaluate(centres.data(), nullptr);
  double sum = -objective.GetProbability().Fractions[0] - objective.GetProbability().Fractions[1];
  for (int r : { 0, 1 })
  {
    for (int s : { 0, 1 })
    {
      sum += objective.GetProbability().S(r, s)[0];
    }
  }
  const ruc::SpherePack pack = Contents().MakePack(centres.data());
  double shared = 0.0, bound = 0.0;
  oracle::ForEachPair(pack, Contents().MakeBox(), 2.0,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    {
      const double a = pack.Radius[i], b = pack.Radius[j];
      shared += 2.0 * oracle::LensVolume(a, b, d) / 216.0;
      bound += 2.0 * oracle::HermiteError(a, b, 0.0, d, 0.25 * std::min(a, b)) / 216.0;
    });
  EXPECT_GT(shared, 0.05);
  EXPECT_LT(bound, 0.05 * shared);
  EXPECT_NEAR(sum, shared, bound);
}

TEST(CellObjective, IsZeroForItsOwnTarget)
{
  ruc::Communicator serial;
  const std::vector<double> centres = Centres(52, true);
  const ruc::Window box = oracle::PeriodicCube(6.0);
  const TwoPointProbability target = ruc::SumPairs(Contents().MakePack(centres.data()), box, Fine);
  CellObjective objective(Contents(), target, serial);
  const CellObjective::Terms terms = objective.Evaluate(centres.data(), nullptr);
  // Nine functions of K lags, each off by the error of tables twice as coarse as those of 1e-6: 16
  // times that, third order and sign changes; of c < 1.
  EXPECT_LT(terms.TwoPoint, 9.0 * std::sqrt(60.0) * 16e-6);
  EXPECT_EQ(terms.Penalty, 0.0);
  const std::vector<double> other = Centres(53, true);
  EXPECT_GT(objective.Evaluate(other.data(), nullptr).TwoPoint, 0.05);
}

TEST(CellObjective, PenaltyIsTheSumOfSquaredOverlaps)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Coarse);
  CellObjective objective(Contents(), target, serial);
  objective.SetPenaltyWeight(2.5);
  const std::vector<double> centres = Centres(54, false);
  const ruc::SpherePack pack = Contents().MakePack(centres.data());
  // The mean radius, weighted by volume
  const double r = (12 * 1.0 + 28 * std::pow(0.6, 4)) / (12 * 1.0 + 28 * std::pow(0.6, 3));
  double expected = 0.0;
  oracle::ForEachPair(pack, Contents().MakeBox(), 2.0,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    { expected += 2.5 * std::pow(std::max(pack.Radius[i] + pack.Radius[j] - d, 0.0) / r, 2); });
  EXPECT_GT(expected, 1.0);
  EXPECT_NEAR(objective.Evaluate(centres.data(), nullptr).Penalty, expected,
    1e-10 * expected); // the interpolant is exact
}

TEST(CellObjective, GradientIsThatOfTheValue)
{
  ruc::Communicator serial;
  for (const ruc::LagGrid& lags : { Fine, Coarse })
  {
    const TwoPointProbability target = Target(lags);
    CellObjective objective(Contents(), target, serial);
    for (double weight : { 0.0, 1.0 })
    {
      objective.SetPenaltyWeight(weight);
      for (bool relaxed : { false, true })
      {
        std::vector<double> centres = Centres(55, relaxed), gradient(centres.size());
        objective.Evaluate(centres.data(), gradient.data());
        double norm = 0.0;
        for (double g : gradient)
        {
          norm = std::max(norm, std::abs(g));
        }
        EXPECT_GT(norm, 1e-4);
        const double step = 1e-6;
        for (std::size_t n = 0; n < centres.size(); ++n)
        {
          const double at = centres[n];
          centres[n] = at + step;
          const double above = objective.Evaluate(centres.data(), nullptr).Total();
          centres[n] = at - step;
          const double below = objective.Evaluate(centres.data(), nullptr).Total();
          centres[n] = at;
          // The interpolant is C1: across a knot its second derivative jumps, which makes an error
          // of the order of step x jump, 1e-6 of the largest force over a radius; and rounding of
          // F2 ~ 1, 1e-15, over the step.
          EXPECT_NEAR((above - below) / (2.0 * step), gradient[n], 3e-6 * norm + 3e-9)
            << "number " << n << " weight " << weight << " relaxed " << relaxed;
        }
      }
    }
  }
}

TEST(CellObjective, ForcesAddUpToNothing)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Coarse);
  CellObjective objective(Contents(), target, serial);
  const std::vector<double> centres = Centres(56, false);
  std::vector<double> gradient(centres.size());
  objective.Evaluate(centres.data(), gradient.data());
  for (int q = 0; q < 3; ++q)
  {
    double sum = 0.0;
    for (std::size_t n = q; n < gradient.size(); n += 3)
    {
      sum += gradient[n];
    }
    EXPECT_NEAR(sum, 0.0, 1e-11); // pairs pull equally in integers; rounding of 40 doubles
  }
}

TEST(CellObjective, TranslationAndWholeEdgesChangeNothing)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Fine);
  CellObjective objective(Contents(), target, serial);
  const std::vector<double> centres = Centres(57, false);
  std::vector<double> gradient(centres.size()), movedGradient(centres.size());
  const CellObjective::Terms terms = objective.Evaluate(centres.data(), gradient.data());
  oracle::Uniform random(1);
  for (int n = 0; n < 3; ++n)
  {
    const ruc::Vector3 shift = { random(-6, 6), random(-6, 6), random(-6, 6) };
    std::vector<double> moved = centres;
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      moved[i] += shift[i % 3] + 6.0 * std::floor(random(-3, 4));
    }
    const CellObjective::Terms other = objective.Evaluate(moved.data(), movedGradient.data());
    // The rounding of coordinates of about 20, 4e-15, for forces of about 10 between 1e4 pairs
    EXPECT_NEAR(other.TwoPoint, terms.TwoPoint, 1e-10);
    EXPECT_NEAR(other.Penalty, terms.Penalty, 1e-10);
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      EXPECT_NEAR(movedGradient[i], gradient[i], 1e-9);
    }
    const ruc::SpherePack pack = Contents().MakePack(moved.data());
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      for (double c : pack.Centre(i))
      {
        EXPECT_GE(c, 0.0);
        EXPECT_LT(c, 6.0);
      }
    }
  }
}

TEST(CellObjective, IsTheSameOnAnyNumberOfThreads)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Fine);
  const std::vector<double> centres = Centres(58, false);
  std::vector<std::vector<double>> gradients;
  std::vector<double> totals;
  for (int threads : { 1, 2, 4 })
  {
    omp_set_num_threads(threads);
    CellObjective objective(Contents(), target, serial);
    gradients.emplace_back(centres.size());
    totals.push_back(objective.Evaluate(centres.data(), gradients.back().data()).Total());
    EXPECT_TRUE(gradients.back() == gradients.front());
    EXPECT_EQ(totals.back(), totals.front());
  }
  omp_set_num_threads(1);
}

TEST(CellObjective, SignalComesBack)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Coarse);
  CellObjective objective(Contents(), target, serial);
  const std::vector<double> centres = Centres(59, true);
  std::int64_t signal = 5;
  const double with = objective.Evaluate(centres.data(), nullptr, &signal).Total();
  EXPECT_EQ(signal, 5); // summed over the one rank
  EXPECT_EQ(with, objective.Evaluate(centres.data(), nullptr).Total());
}

// Several sizes in a mode: F2 as of the exact sum, and its gradient as of differences
TEST(CellObjective, KnowsSizesWithinAMode)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Fine);
  CellContents contents = Contents();
  contents.Count = { 5, 7, 16, 12 };
  contents.Radius = { 1.05, 0.95, 0.55, 0.65 };
  contents.Mode = { 1, 1, 2, 2 };
  CellObjective objective(contents, target, serial);
  std::vector<double> centres = Centres(51, false), gradient(centres.size());
  const CellObjective::Terms terms = objective.Evaluate(centres.data(), gradient.data());
  const TwoPointProbability sum =
    ruc::SumPairs(contents.MakePack(centres.data()), contents.MakeBox(), Fine);
  const double exact = ruc::TwoPointDifference(target, sum);
  EXPECT_NEAR(terms.TwoPoint, exact, 1e-3 * exact);
  for (int p = 0; p < sum.Pairs(); ++p)
  {
    for (int k = 0; k <= Fine.Count; ++k)
    {
      EXPECT_NEAR(objective.GetProbability().Values[p][k], sum.Values[p][k], 1e-4);
    }
  }
  for (std::size_t n : { 3u, 20u, 50u, 100u })
  {
    const double step = 1e-5, there = centres[n];
    centres[n] = there + step;
    const double above = objective.Evaluate(centres.data(), nullptr).Total();
    centres[n] = there - step;
    const double below = objective.Evaluate(centres.data(), nullptr).Total();
    centres[n] = there;
    EXPECT_NEAR(gradient[n], (above - below) / (2.0 * step), 1e-5 * std::abs(gradient[n]) + 1e-6);
  }
}

// The penalty of spheres that are enlarged, at distances which the knots have exactly or not
TEST(CellObjective, PenaltyCountsFromTheLeastGap)
{
  ruc::Communicator serial;
  const TwoPointProbability target = Target(Fine);
  CellContents contents = Contents();
  contents.Gap = { 0.03, 0.02 };
  CellObjective objective(contents, target, serial);
  const std::vector<double> centres = Centres(51, false);
  const double penalty = objective.Evaluate(centres.data(), nullptr).Penalty;
  const ruc::SpherePack pack = contents.MakePack(centres.data());
  double sum = 0.0, volume = 0.0, weighted = 0.0;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    volume += std::pow(pack.Radius[i], 3);
    weighted += std::pow(pack.Radius[i], 4);
    for (std::size_t j = 0; j < i; ++j)
    {
      double d2 = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        double d = pack.Centre(i)[q] - pack.Centre(j)[q];
        d -= 6.0 * std::nearbyint(d / 6.0);
        d2 += d * d;
      }
      const double reach = 1.02 * (pack.Radius[i] + pack.Radius[j]) + 0.03;
      sum += std::pow(std::max(reach - std::sqrt(d2), 0.0), 2);
    }
  }
  const double radius = weighted / volume;
  EXPECT_NEAR(penalty, sum / (radius * radius), 1e-3 * penalty);
}
