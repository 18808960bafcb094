// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/AnnealedSelection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
double OverlapPenalty(double percent, double half)
{
  return percent / (percent + half);
}

double Fitness(double objective, double worst, double overlapPercent, double half)
{
  return objective / worst + OverlapPenalty(overlapPercent, half);
}

std::vector<int> RankByFitness(const std::vector<double>& fitness)
{
  std::vector<int> ranking(fitness.size());
  std::iota(ranking.begin(), ranking.end(), 0);
  std::stable_sort(
    ranking.begin(), ranking.end(), [&](int a, int b) { return fitness[a] < fitness[b]; });
  return ranking;
}

std::vector<int> DrawMatingPool(
  const std::vector<int>& ranking, int number, double pressure, RandomSequence& random)
{
  const double last = std::max<double>(ranking.size() - 1.0, 1.0);
  std::vector<double> shares(ranking.size());
  for (std::size_t k = 0; k < shares.size(); ++k)
  {
    shares[k] = pressure - 2.0 * (pressure - 1.0) * (k / last);
  }
  std::vector<bool> drawn(ranking.size(), false);
  std::vector<int> pool;
  while (static_cast<int>(pool.size()) < number)
  {
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    double rest = random.Next() * total;
    // Rounding, and shares of 0, may leave the wheel at its end; then the last member on it is
    // taken
    std::size_t place = 0;
    for (std::size_t k = 0; k < shares.size(); ++k)
    {
      if (!drawn[k])
      {
        place = k;
        if (rest < shares[k])
        {
          break;
        }
        rest -= shares[k];
      }
    }
    pool.push_back(ranking[place]);
    drawn[place] = true;
    shares[place] = 0.0;
  }
  return pool;
}

double AcceptanceProbability(double child, double parent, double temperature)
{
  return 1.0 / (1.0 + std::exp((child - parent) / temperature));
}
}
