// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationSettings.h"

#include "ruc/Base/Text.h"
#include "ruc/Reconstruction/CellStart.h"

#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
void Require(bool condition, const char* name, const char* range, double value)
{
  if (!condition)
  {
    throw std::invalid_argument(Text(name, " requires ", range, ", got ", value, "."));
  }
}
}

PopulationSettings HybridSettings()
{
  PopulationSettings settings;
  settings.Population = 16;
  settings.MatingPool = 1;
  settings.RefinementSteps = 100;
  settings.OperatorWeights = { 1, 0, 1, 1, 0, 0, 0, 0 };
  settings.MutationReach = 0.1;
  settings.SelectionPressure = 2.0;
  return settings;
}

void CheckSettings(const PopulationSettings& s)
{
  Require(s.Population >= 2, "Population", "Population >= 2", s.Population);
  Require(s.RandomShare >= 0.0 && s.RandomShare <= 1.0, "RandomShare", "0 <= RandomShare <= 1",
    s.RandomShare);
  Require(s.DepositionDegree >= 0.0 && s.DepositionDegree <= 1.0, "DepositionDegree",
    "0 <= DepositionDegree <= 1", s.DepositionDegree);
  Require(s.MatingPool >= 1 && s.MatingPool <= s.Population, "MatingPool",
    Text("1 <= MatingPool <= Population (", s.Population, ")").c_str(), s.MatingPool);
  Require(s.MaximumGenerations >= 0, "MaximumGenerations", "MaximumGenerations >= 0",
    s.MaximumGenerations);
  Require(s.PatienceGenerations >= 1, "PatienceGenerations", "PatienceGenerations >= 1",
    s.PatienceGenerations);
  Require(!std::isnan(s.TargetObjective), "TargetObjective", "a number", s.TargetObjective);
  Require(s.SelectionPressure >= 1.0 && s.SelectionPressure <= 2.0, "SelectionPressure",
    "1 <= SelectionPressure <= 2", s.SelectionPressure);
  Require(s.HalfOverlap > 0.0 && std::isfinite(s.HalfOverlap), "HalfOverlap", "HalfOverlap > 0",
    s.HalfOverlap);
  double sum = 0.0;
  for (double weight : s.OperatorWeights)
  {
    Require(weight >= 0.0 && std::isfinite(weight), "OperatorWeights", "every weight >= 0", weight);
    sum += weight;
  }
  Require(sum > 0.0, "OperatorWeights", "a sum > 0", sum);
  Require(s.MutatedShare > 0.0 && s.MutatedShare <= 1.0, "MutatedShare", "0 < MutatedShare <= 1",
    s.MutatedShare);
  Require(s.MutationShape >= 0.0 && std::isfinite(s.MutationShape), "MutationShape",
    "MutationShape >= 0", s.MutationShape);
  Require(s.MutationReach > 0.0 && s.MutationReach <= 1.0, "MutationReach",
    "0 < MutationReach <= 1", s.MutationReach);
  Require(s.MutationGenerations >= 1, "MutationGenerations", "MutationGenerations >= 1",
    s.MutationGenerations);
  Require(s.MassSpringProbability >= 0.0 && s.MassSpringProbability <= 1.0, "MassSpringProbability",
    "0 <= MassSpringProbability <= 1", s.MassSpringProbability);
  Require(s.InitialTemperature > 0.0 && std::isfinite(s.InitialTemperature), "InitialTemperature",
    "InitialTemperature > 0", s.InitialTemperature);
  Require(s.CoolingFactor > 0.0 && s.CoolingFactor <= 1.0, "CoolingFactor",
    "0 < CoolingFactor <= 1", s.CoolingFactor);
  Require(s.ReheatingGenerations >= 1, "ReheatingGenerations", "ReheatingGenerations >= 1",
    s.ReheatingGenerations);
  Require(s.RefinementSteps >= 0, "RefinementSteps", "RefinementSteps >= 0", s.RefinementSteps);
}

Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings)
{
  constexpr double SecondsPerChildSphere = 1.4e-5; // freed from overlap by springs
  const double evaluation = EstimateEvaluation(cell, lags, false);
  const double member = cell.Spheres * SecondsPerStartedSphere + evaluation;
  const double child = cell.Spheres * SecondsPerChildSphere + evaluation;
  const double descent = settings.RefinementSteps * EstimateEvaluation(cell, lags, true);
  const double children = settings.RefinementSteps > 0 ? 0.0 : settings.MatingPool;
  return { settings.Population * member +
      static_cast<double>(settings.MaximumGenerations) * (children * child + descent),
    settings.Population * cell.Spheres * 24.0 / BytesOfMegabyte, 0.0 };
}
}
