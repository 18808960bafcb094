// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/PopulationSettings.h"

#include "Oracles.h"

#include <functional>
#include <limits>

using ruc::PopulationSettings;

TEST(PopulationSettings, OutOfRangeAreRefused)
{
  const double nan = std::nan("");
  const auto expect = [](const char* wanted, auto&& change)
  {
    PopulationSettings settings;
    change(settings);
    EXPECT_SAYS(ruc::CheckSettings(settings), wanted);
  };
  for (int population : { 0, 1, -5 })
  {
    expect("Population requires Population >= 2, got",
      [&](PopulationSettings& s) { s.Population = population; });
  }
  expect("MatingPool requires 1 <= MatingPool <= Population (512), got 513.",
    [](PopulationSettings& s) { s.MatingPool = 513; });
  expect("MatingPool requires", [](PopulationSettings& s) { s.MatingPool = 0; });
  expect("MaximumGenerations requires", [](PopulationSettings& s) { s.MaximumGenerations = -1; });
  expect("PatienceGenerations requires", [](PopulationSettings& s) { s.PatienceGenerations = 0; });
  expect("MutationGenerations requires", [](PopulationSettings& s) { s.MutationGenerations = 0; });
  expect(
    "ReheatingGenerations requires", [](PopulationSettings& s) { s.ReheatingGenerations = 0; });
  expect("RefinementSteps requires", [](PopulationSettings& s) { s.RefinementSteps = -1; });
  expect("a sum > 0", [](PopulationSettings& s) { s.OperatorWeights.fill(0.0); });
  expect("OperatorWeights requires OperatorWeights >= 0, got -1.",
    [](PopulationSettings& s) { s.OperatorWeights[3] = -1.0; });
  for (double target : { nan, -1.0 })
  {
    expect("TargetObjective requires TargetObjective >= 0, got",
      [&](PopulationSettings& s) { s.TargetObjective = target; });
  }
  const std::pair<const char*, double PopulationSettings::*> numbers[] = {
    { "RandomShare", &PopulationSettings::RandomShare },
    { "DepositionDegree", &PopulationSettings::DepositionDegree },
    { "SelectionPressure", &PopulationSettings::SelectionPressure },
    { "HalfOverlap", &PopulationSettings::HalfOverlap },
    { "MutatedShare", &PopulationSettings::MutatedShare },
    { "MutationShape", &PopulationSettings::MutationShape },
    { "MutationReach", &PopulationSettings::MutationReach },
    { "MassSpringProbability", &PopulationSettings::MassSpringProbability },
    { "InitialTemperature", &PopulationSettings::InitialTemperature },
    { "CoolingFactor", &PopulationSettings::CoolingFactor },
  };
  for (const auto& [name, member] : numbers)
  {
    for (double value : { nan, -1.0 })
    {
      expect((std::string(name) + " requires ").c_str(),
        [&, number = member](PopulationSettings& s) { s.*number = value; });
    }
  }
}
