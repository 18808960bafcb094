// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/GeneticOperators.h"

#include "Oracles.h"
#include "ruc/Base/Random.h"
#include "ruc/Reconstruction/Population/AnnealedSelection.h"

#include <functional>
#include <set>

namespace
{
using ruc::Chromosome;
using ruc::RandomSequence;

constexpr double Edge = 7.0;
constexpr int Spheres = 40;

Chromosome Parent(std::uint64_t seed)
{
  oracle::Uniform random(seed);
  Chromosome centres(3 * Spheres);
  for (double& c : centres)
  {
    c = random(0.0, Edge);
  }
  return centres;
}

// Expects genes that moved by less than half an edge either way
double ShortestWay(double from, double to)
{
  double way = to - from;
  while (way > 0.5 * Edge)
  {
    way -= Edge;
  }
  while (way < -0.5 * Edge)
  {
    way += Edge;
  }
  return way;
}

std::set<int> ChangedSpheres(const Chromosome& parent, const Chromosome& child)
{
  std::set<int> changed;
  for (std::size_t k = 0; k < parent.size(); ++k)
  {
    if (parent[k] != child[k])
    {
      changed.insert(static_cast<int>(k / 3));
    }
  }
  return changed;
}

void ExpectInCell(const Chromosome& centres)
{
  for (double c : centres)
  {
    EXPECT_GE(c, 0.0);
    EXPECT_LT(c, Edge);
  }
}

// Calls check(child) for many random sequences
void ForManyChildren(const std::function<Chromosome(RandomSequence&)>& make,
  const std::function<void(const Chromosome&)>& check, int number = 2000)
{
  for (int n = 0; n < number; ++n)
  {
    RandomSequence random(1, ruc::RandomStream::MutationOperator, n);
    const Chromosome child = make(random);
    ExpectInCell(child);
    check(child);
  }
}

// Expects the mean and the mean square of a uniform number, 1/2 and 1/3, within 5 standard errors
void ExpectMomentsOfUniform(const std::vector<double>& samples)
{
  const double n = samples.size();
  double sum = 0.0, squares = 0.0;
  for (double u : samples)
  {
    EXPECT_GE(u, 0.0);
    EXPECT_LE(u, 1.0 + 1e-9); // rounding of a coordinate
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / n, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 5.0 * std::sqrt((1.0 / 5.0 - 1.0 / 9.0) / n));
}

// Expects a share within 5 standard errors of a probability
void ExpectShare(int count, int of, double probability)
{
  EXPECT_NEAR(
    count, of * probability, 5.0 * std::sqrt(of * probability * (1.0 - probability)) + 1e-9);
}
}

TEST(GeneticOperators, UniformMutationPutsSpheresAnywhere)
{
  const Chromosome parent = Parent(1);
  std::vector<double> places;
  std::vector<int> drawn(Spheres, 0);
  ForManyChildren([&](RandomSequence& random)
    { return ruc::UniformMutation(parent, Edge, 3, random); },
    [&](const Chromosome& child)
    {
      const std::set<int> changed = ChangedSpheres(parent, child);
      EXPECT_EQ(changed.size(), 3u);
      for (int i : changed)
      {
        ++drawn[i];
        for (int q = 0; q < 3; ++q)
        {
          places.push_back(child[3 * i + q] / Edge);
        }
      }
    });
  ExpectMomentsOfUniform(places);
  for (int count : drawn)
  {
    ExpectShare(count, 2000, 3.0 / Spheres);
  }
}

TEST(GeneticOperators, AllSpheresMayBeMutated)
{
  const Chromosome parent = Parent(1);
  RandomSequence random(1, ruc::RandomStream::MutationOperator, 3);
  EXPECT_EQ(
    ChangedSpheres(parent, ruc::UniformMutation(parent, Edge, Spheres, random)).size(), Spheres);
}

TEST(GeneticOperators, BoundaryMutationPutsOneCoordinateOnTheBorder)
{
  const Chromosome parent = Parent(1);
  int axes[3] = { 0, 0, 0 };
  ForManyChildren([&](RandomSequence& random) { return ruc::BoundaryMutation(parent, 2, random); },
    [&](const Chromosome& child)
    {
      int changed = 0;
      for (std::size_t k = 0; k < child.size(); ++k)
      {
        if (child[k] != parent[k])
        {
          EXPECT_EQ(child[k], 0.0);
          ++axes[k % 3];
          ++changed;
        }
      }
      EXPECT_EQ(changed, 2);
      EXPECT_EQ(ChangedSpheres(parent, child).size(), 2u);
    });
  for (int count : axes)
  {
    ExpectShare(count, 4000, 1.0 / 3.0);
  }
}

TEST(GeneticOperators, NonUniformMutationGoesTowardsTheBoundsLessAndLess)
{
  const Chromosome parent = Parent(1);
  for (double share : { 0.0, 0.5, 0.9 })
  {
    const double shape = 3.0, reach = 0.8;
    const double farthest = 0.5 * Edge * reach * std::pow(1.0 - share, shape);
    std::vector<double> lengths;
    int up = 0;
    ForManyChildren(
      [&](RandomSequence& random) {
        return ruc::NonUniformMutation(parent, Edge, 2, { share, shape, reach }, random);
      },
      [&](const Chromosome& child)
      {
        const std::set<int> changed = ChangedSpheres(parent, child);
        EXPECT_EQ(changed.size(), 2u);
        for (int i : changed)
        {
          for (int k = 3 * i; k < 3 * i + 3; ++k)
          {
            const double way = ShortestWay(parent[k], child[k]);
            lengths.push_back(std::abs(way) / farthest);
            up += way > 0.0;
          }
        }
      });
    ExpectMomentsOfUniform(lengths);
    ExpectShare(up, static_cast<int>(lengths.size()), 0.5);
  }
  RandomSequence random(1, ruc::RandomStream::MutationOperator, 3);
  EXPECT_EQ(ruc::NonUniformMutation(parent, Edge, 2, { 1.0, 2.0, 1.0 }, random), parent);
}

TEST(GeneticOperators, MultiNonUniformMutationMovesAll)
{
  const Chromosome parent = Parent(1);
  std::vector<double> lengths;
  ForManyChildren(
    [&](RandomSequence& random) {
      return ruc::MultiNonUniformMutation(parent, Edge, { 0.5, 2.0, 1.0 }, random);
    },
    [&](const Chromosome& child)
    {
      EXPECT_EQ(ChangedSpheres(parent, child).size(), Spheres);
      for (std::size_t k = 0; k < child.size(); ++k)
      {
        lengths.push_back(std::abs(ShortestWay(parent[k], child[k])) / (0.5 * Edge * 0.25));
      }
    },
    50);
  ExpectMomentsOfUniform(lengths);
}

TEST(GeneticOperators, SimpleCrossoverCutsOnce)
{
  const Chromosome x = Parent(1), y = Parent(2);
  std::vector<int> cuts(Spheres, 0);
  ForManyChildren([&](RandomSequence& random) { return ruc::SimpleCrossover(x, y, random); },
    [&](const Chromosome& child)
    {
      int cut = 0;
      while (cut < Spheres && child[3 * cut] == x[3 * cut])
      {
        ++cut;
      }
      ASSERT_GE(cut, 1);
      ASSERT_LT(cut, Spheres);
      ++cuts[cut];
      for (int k = 0; k < 3 * Spheres; ++k)
      {
        EXPECT_EQ(child[k], k < 3 * cut ? x[k] : y[k]);
      }
    });
  for (int cut = 1; cut < Spheres; ++cut)
  {
    ExpectShare(cuts[cut], 2000, 1.0 / (Spheres - 1));
  }
}

TEST(GeneticOperators, ArithmeticCrossoversGoTheShortWayToTheOtherParent)
{
  const Chromosome x = Parent(1), y = Parent(2);
  std::vector<double> shares;
  const auto check = [&](const Chromosome& child, std::size_t changed)
  {
    EXPECT_EQ(ChangedSpheres(x, child).size(), changed);
    double share = -1.0;
    for (int i : ChangedSpheres(x, child))
    {
      for (int k = 3 * i; k < 3 * i + 3; ++k)
      {
        const double own = ShortestWay(x[k], child[k]) / ShortestWay(x[k], y[k]);
        share = share < 0.0 ? own : share;
        // The rounding of coordinates of 7, over ways that may be short
        EXPECT_NEAR(own, share, 1e-14 * Edge / std::abs(ShortestWay(x[k], y[k])) + 1e-10);
      }
    }
    shares.push_back(share);
  };
  ForManyChildren([&](RandomSequence& random)
    { return ruc::SimpleArithmeticCrossover(x, y, Edge, 3, random); },
    [&](const Chromosome& child) { check(child, 3); });
  ExpectMomentsOfUniform(shares);
  shares.clear();
  ForManyChildren([&](RandomSequence& random)
    { return ruc::WholeArithmeticCrossover(x, y, Edge, random); },
    [&](const Chromosome& child) { check(child, Spheres); });
  ExpectMomentsOfUniform(shares);
}

TEST(GeneticOperators, HeuristicCrossoverGoesOnOverTheBetterParent)
{
  const Chromosome better = Parent(1);
  // Near the better one, so that the way beyond it is the short one
  Chromosome worse = better;
  oracle::Uniform place(3);
  for (double& c : worse)
  {
    c = std::fmod(c + place(0.05, 0.24) * Edge, Edge);
  }
  std::vector<double> shares;
  ForManyChildren([&](RandomSequence& random)
    { return ruc::HeuristicCrossover(better, worse, Edge, random); },
    [&](const Chromosome& child)
    {
      const double share = ShortestWay(better[0], child[0]) / ShortestWay(worse[0], better[0]);
      shares.push_back(share);
      for (int k = 0; k < 3 * Spheres; ++k)
      {
        EXPECT_NEAR(
          ShortestWay(better[k], child[k]), share * ShortestWay(worse[k], better[k]), 1e-12 * Edge);
      }
    });
  ExpectMomentsOfUniform(shares);
}

TEST(AnnealedSelection, PenaltyGrowsFromZeroToOne)
{
  EXPECT_EQ(ruc::OverlapPenalty(0.0, 2.0), 0.0);
  EXPECT_EQ(ruc::OverlapPenalty(2.0, 2.0), 0.5);
  double last = 0.0;
  for (double percent = 1e-6; percent < 1e6; percent *= 2.0)
  {
    const double penalty = ruc::OverlapPenalty(percent, 2.0);
    EXPECT_GT(penalty, last);
    EXPECT_LT(penalty, 1.0);
    last = penalty;
  }
}

TEST(AnnealedSelection, RanksGoFromTheBestToTheWorst)
{
  EXPECT_EQ(ruc::RankByFitness({ 3.0, 1.0, 2.0, 1.0 }), (std::vector<int>{ 1, 3, 2, 0 }));
}

TEST(AnnealedSelection, TheRouletteHasTheSharesOfTheRanks)
{
  const std::vector<int> ranking = { 2, 0, 4, 1, 3 };
  for (double pressure : { 1.0, 1.5, 2.0 })
  {
    std::vector<int> counts(5, 0);
    constexpr int draws = 20000;
    for (int n = 0; n < draws; ++n)
    {
      RandomSequence random(1, ruc::RandomStream::MutationOperator, n);
      ++counts[ruc::DrawMatingPool(ranking, 1, pressure, random).at(0)];
    }
    for (int k = 0; k < 5; ++k)
    {
      ExpectShare(counts[ranking[k]], draws, (pressure - (pressure - 1.0) * k / 2.0) / 5.0);
    }
  }
}

TEST(AnnealedSelection, APoolHoldsDifferentMembers)
{
  for (double pressure : { 1.0, 2.0 })
  {
    for (int number = 1; number <= 5; ++number)
    {
      RandomSequence random(1, ruc::RandomStream::MutationOperator, number);
      const std::vector<int> pool =
        ruc::DrawMatingPool({ 4, 3, 2, 1, 0 }, number, pressure, random);
      EXPECT_EQ(std::set<int>(pool.begin(), pool.end()).size(), std::size_t(number));
    }
  }
}

TEST(AnnealedSelection, AcceptanceIsTheLogisticFunction)
{
  EXPECT_EQ(ruc::AcceptanceProbability(0.3, 0.3, 0.01), 0.5);
  EXPECT_NEAR(ruc::AcceptanceProbability(0.4, 0.3, 0.1), 1.0 / (1.0 + std::exp(1.0)), 1e-12);
  EXPECT_EQ(ruc::AcceptanceProbability(1.0, 0.0, 1e-6), 0.0);
  EXPECT_EQ(ruc::AcceptanceProbability(0.0, 1.0, 1e-6), 1.0);
  // With child and parent exchanged, the probabilities add up to 1
  EXPECT_NEAR(
    ruc::AcceptanceProbability(0.37, 0.3, 0.1) + ruc::AcceptanceProbability(0.3, 0.37, 0.1), 1.0,
    1e-15);
}
