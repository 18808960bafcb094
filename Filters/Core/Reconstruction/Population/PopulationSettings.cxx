// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationSettings.h"

#include "ruc/Base/Require.h"
#include "ruc/Reconstruction/CellStart.h"

#include <omp.h>

#include <numeric>

namespace ruc
{
PopulationSettings HybridOf(const PopulationSettings& annealed, const HybridSettings& own)
{
  CheckRanges(own);
  Require(own.MatingPool <= own.Population, "HybridMatingPool",
    Text("1 <= HybridMatingPool <= HybridPopulation (", own.Population, ")"), own.MatingPool);
  PopulationSettings settings = annealed;
  settings.Population = own.Population;
  settings.MatingPool = own.MatingPool;
  settings.MutationReach = own.MutationReach;
  settings.RefinementSteps = own.RefinementSteps;
  settings.OperatorWeights = { 1, 0, 1, 1, 0, 0, 0, 0 };
  settings.SelectionPressure = 2.0;
  return settings;
}

void CheckSettings(const PopulationSettings& settings)
{
  CheckRanges(settings);
  Require(settings.MatingPool <= settings.Population, "MatingPool",
    Text("1 <= MatingPool <= Population (", settings.Population, ")"), settings.MatingPool);
  const double sum =
    std::accumulate(settings.OperatorWeights.begin(), settings.OperatorWeights.end(), 0.0);
  Require(sum > 0.0, "OperatorWeights", "a sum > 0", sum);
}

Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings)
{
  constexpr double SecondsPerChildSphere = 1.4e-5; // to free it from overlap by springs
  const double evaluation = EstimateEvaluation(cell, lags, false);
  const double member = cell.Spheres * SecondsPerStartedSphere + evaluation;
  const double child = cell.Spheres * SecondsPerChildSphere + evaluation;
  const double descent = settings.RefinementSteps * EstimateEvaluation(cell, lags, true);
  const double children = settings.RefinementSteps > 0 ? 0.0 : settings.MatingPool;
  return { settings.Population * member +
      static_cast<double>(settings.MaximumGenerations) * (children * child + descent),
    // Members are there once more while they are handed round; each rank has an objective, and one
    // for each thread
    (settings.Population * cell.Spheres * 48.0 +
      (1.0 + omp_get_max_threads()) * EstimateObjectiveBytes(cell, lags)) /
      BytesOfMegabyte,
    0.0 };
}
}
