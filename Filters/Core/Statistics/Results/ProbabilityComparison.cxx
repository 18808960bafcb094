// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/ProbabilityComparison.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace ruc
{
namespace
{
// Sets the mean, and returns the standard deviation
double MeanAndDeviation(const std::vector<double>& values, double& mean)
{
  const double count = static_cast<double>(values.size());
  mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0;
}
}

MeanProbability AverageProbabilities(const std::vector<TwoPointProbability>& probabilities)
{
  MeanProbability average = { probabilities.front(), {}, {} };
  average.FractionDeviations = average.Mean.Fractions;
  average.Deviations = average.Mean.Values;
  std::vector<double> values(probabilities.size());
  const auto over = [&](auto&& number)
  {
    std::transform(probabilities.begin(), probabilities.end(), values.begin(), number);
    return values;
  };
  for (std::size_t phase = 0; phase < average.Mean.Fractions.size(); ++phase)
  {
    average.FractionDeviations[phase] =
      MeanAndDeviation(over([&](const TwoPointProbability& one) { return one.Fractions[phase]; }),
        average.Mean.Fractions[phase]);
  }
  for (std::size_t pair = 0; pair < average.Mean.Values.size(); ++pair)
  {
    for (std::size_t k = 0; k < average.Mean.Values[pair].size(); ++k)
    {
      average.Deviations[pair][k] =
        MeanAndDeviation(over([&](const TwoPointProbability& one) { return one.Values[pair][k]; }),
          average.Mean.Values[pair][k]);
    }
  }
  return average;
}

double NormOfDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> difference(a.size());
  std::transform(a.begin(), a.end(), b.begin(), difference.begin(), std::minus<>());
  return DiscreteNorm(difference);
}

ProbabilityComparison CompareProbabilities(
  const TwoPointProbability& pack, const TwoPointProbability& cell)
{
  ProbabilityComparison comparison;
  const double particles =
    std::accumulate(pack.Fractions.begin(), pack.Fractions.begin() + pack.Modes, 0.0);
  for (int mode = 0; mode < pack.Modes; ++mode)
  {
    comparison.FractionPercent.push_back(
      std::abs(pack.Fractions[mode] - cell.Fractions[mode]) / particles * 100.0);
  }
  double norms = 0.0;
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = 0; s < pack.Phases(); ++s)
    {
      norms += 0.5 * (DiscreteNorm(pack.S(r, s)) + DiscreteNorm(cell.S(r, s)));
    }
  }
  comparison.Percent = TwoPointDifference(pack, cell) / norms * 100.0;
  return comparison;
}
}
