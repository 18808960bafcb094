// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/ProbabilityComparison.h"

#include "Oracles.h"

namespace
{
constexpr int Lags = 5;

// One mode and the matrix, with any numbers
ruc::TwoPointProbability AnyNumbers(int seed)
{
  oracle::Uniform random(seed);
  ruc::TwoPointProbability probability(1, { 0.1, Lags });
  probability.Fractions = { random(0.1, 0.5), random(0.1, 0.5) };
  for (std::vector<double>& values : probability.Values)
  {
    for (double& value : values)
    {
      value = random(0.0, 1.0);
    }
  }
  return probability;
}
}

TEST(ProbabilityComparison, IsEquations16And17)
{
  const ruc::TwoPointProbability pack = AnyNumbers(1), cell = AnyNumbers(2);
  const ruc::ProbabilityComparison comparison = ruc::CompareProbabilities(pack, cell);
  ASSERT_EQ(comparison.FractionPercent.size(), 1u);
  // The only mode is all of the particles
  EXPECT_NEAR(comparison.FractionPercent[0],
    100.0 * std::abs(pack.Fractions[0] - cell.Fractions[0]) / pack.Fractions[0], 1e-12);
  double differences = 0.0, norms = 0.0;
  for (int r = 0; r < 2; ++r)
  {
    for (int s = 0; s < 2; ++s)
    {
      double squares[3] = {};
      for (int k = 1; k <= Lags; ++k)
      {
        const double a = pack.S(r, s)[k], b = cell.S(r, s)[k];
        squares[0] += (a - b) * (a - b);
        squares[1] += a * a;
        squares[2] += b * b;
      }
      differences += std::sqrt(squares[0]);
      norms += 0.5 * (std::sqrt(squares[1]) + std::sqrt(squares[2]));
    }
  }
  EXPECT_NEAR(comparison.Percent, 100.0 * differences / norms, 1e-12);
  EXPECT_EQ(ruc::CompareProbabilities(pack, pack).Percent, 0.0);
}

TEST(ProbabilityComparison, TheMeanAndItsScatter)
{
  // 1, 2, 6 have the mean 3 and the standard deviation sqrt((4 + 1 + 9) / 2)
  std::vector<ruc::TwoPointProbability> cells;
  for (double value : { 1.0, 2.0, 6.0 })
  {
    cells.emplace_back(1, ruc::LagGrid{ 0.1, Lags });
    cells.back().Fractions = { value, -value };
    cells.back().S(0, 1)[3] = 10.0 * value;
  }
  const ruc::MeanProbability mean = ruc::AverageProbabilities(cells);
  EXPECT_NEAR(mean.Mean.Fractions[0], 3.0, 1e-15);
  EXPECT_NEAR(mean.FractionDeviations[1], std::sqrt(7.0), 1e-14);
  EXPECT_NEAR(mean.Mean.S(0, 1)[3], 30.0, 1e-14);
  EXPECT_NEAR(mean.Deviations[mean.Mean.PairOf(0, 1)][3], 10.0 * std::sqrt(7.0), 1e-13);
  EXPECT_EQ(mean.Deviations[mean.Mean.PairOf(0, 0)][3], 0.0);
  // A single cell has no scatter
  const ruc::MeanProbability one = ruc::AverageProbabilities({ cells[2] });
  EXPECT_EQ(one.Mean.Values, cells[2].Values);
  EXPECT_EQ(one.FractionDeviations[0], 0.0);
}
