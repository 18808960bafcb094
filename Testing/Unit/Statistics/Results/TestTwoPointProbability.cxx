// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include "Oracles.h"

using ruc::LagGrid;
using ruc::TwoPointProbability;

TEST(TwoPointProbability, PairsAreNumberedThrough)
{
  const TwoPointProbability probability(4, { 1.0, 3 });
  EXPECT_EQ(probability.Phases(), 5);
  EXPECT_EQ(probability.Pairs(), 15);
  int expected = 0;
  for (int r = 0; r < 5; ++r)
  {
    for (int s = r; s < 5; ++s, ++expected)
    {
      EXPECT_EQ(probability.PairOf(r, s), expected);
      EXPECT_EQ(probability.PairOf(s, r), expected);
    }
  }
  EXPECT_EQ(probability.PhaseName(0), "1");
  EXPECT_EQ(probability.PhaseName(4), "m");
}

TEST(TwoPointProbability, MatrixCompletesTheSums)
{
  oracle::Uniform random(1);
  TwoPointProbability probability(3, { 0.5, 6 });
  for (std::vector<double>& values : probability.Values)
  {
    for (double& value : values)
    {
      value = random(0.0, 0.05);
    }
  }
  probability.Fractions = { 0.1, 0.2, 0.15, -99.0 };
  probability.CompleteMatrix();
  EXPECT_NEAR(probability.Fractions[3], 0.55, 1e-15);
  for (int r = 0; r < 4; ++r)
  {
    for (int k = 0; k <= 6; ++k)
    {
      double sum = 0.0;
      for (int s = 0; s < 4; ++s)
      {
        sum += probability.S(r, s)[k];
      }
      EXPECT_NEAR(sum, probability.Fractions[r], 1e-15); // rounding
    }
  }
}

TEST(TwoPointProbability, DifferenceIsTheSumOfNormsOverOrderedPairs)
{
  EXPECT_DOUBLE_EQ(
    ruc::DiscreteNorm({ 100.0, 3.0, 4.0 }), 5.0); // lag 0 does not count, no division by K
  oracle::Uniform random(2);
  TwoPointProbability a(2, { 0.5, 6 }), b = a;
  for (int p = 0; p < a.Pairs(); ++p)
  {
    for (int k = 0; k <= 6; ++k)
    {
      a.Values[p][k] = random();
      b.Values[p][k] = random();
    }
  }
  double expected = 0.0;
  for (int r = 0; r < 3; ++r)
  {
    for (int s = 0; s < 3; ++s)
    {
      double square = 0.0;
      for (int k = 1; k <= 6; ++k)
      {
        square += std::pow(a.S(r, s)[k] - b.S(r, s)[k], 2);
      }
      expected += std::sqrt(square);
    }
  }
  EXPECT_NEAR(ruc::TwoPointDifference(a, b), expected, 1e-14);
  EXPECT_EQ(ruc::TwoPointDifference(a, a), 0.0);
}
