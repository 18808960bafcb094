// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Packing/Deposition.h"
#include "ruc/Reconstruction/CellObjective.h"

#include <array>
#include <cstdint>

namespace ruc
{
/** The operators of GeneticOperators.h, in the order of PopulationSettings::OperatorWeights. */
enum class GeneticOperator
{
  UniformMutation,
  BoundaryMutation,
  NonUniformMutation,
  MultiNonUniformMutation,
  SimpleCrossover,
  SimpleArithmeticCrossover,
  WholeArithmeticCrossover,
  HeuristicCrossover
};
constexpr int NumberOfGeneticOperators = 8;

/** Defaults are the paper's (section IV B) where it names a number. */
struct PopulationSettings
{
  std::uint32_t Seed = 1;
  int Population = 512;     // N_i >= 2
  double RandomShare = 0.5; // of the first population at random, the others by deposition
  double DepositionDegree = DefaultDepositionDegree; // of overlap allowed, in [0, 1]
  int MatingPool = 16;                               // m, 1 to Population
  int MaximumGenerations = 10000; // >= 0; 0 gives the best of the first population
  int PatienceGenerations = 300;  // >= 1; ends after as many without a better best member
  double TargetObjective = 0.0;   // ends when a best member without overlap has F2 at or below it

  double SelectionPressure = 1.5; // of DrawMatingPool, in [1, 2]
  double HalfOverlap = 1.0;       // of OverlapPenalty, in percent, > 0

  std::array<double, NumberOfGeneticOperators> OperatorWeights = { 1, 1, 1, 1, 1, 1, 1, 1 };
  double MutatedShare = 0.01; // of the spheres that an operator on some changes, in (0, 1]
  double MutationShape = 2.0; // b of the non-uniform mutations, >= 0
  double MutationReach = 1.0; // of half an edge, in (0, 1]
  /** G of (1 - g / G)^b, >= 1. Not the maximum, so that a search that has ended can be carried on.
   */
  int MutationGenerations = 10000;
  double MassSpringProbability = 0.9; // that a child is moved by springs until free of overlap

  double InitialTemperature = 1e-3; // of the fitness, > 0
  double CoolingFactor = 0.98;      // of the temperature, a generation, in (0, 1]
  int ReheatingGenerations = 100;   // >= 1; back to the initial after as many without improvement

  /**
   * 0: annealed population. More: hybrid, with so many steps of L-BFGS on F2 at a time. In every
   * generation the best member goes on downhill, its Hessian kept; in the first generation it is
   * member 0, the start of SearchByGradient. The mating pool rests as long as that gains
   * LeastProgress (GradientSearch.h) or more; else its children are refined as well.
   */
  int RefinementSteps = 0;
};

/** The settings of the hybrid: few members, of which the best descends, and small mutations. */
PopulationSettings HybridSettings();

/** Throws std::invalid_argument for settings out of range. */
void CheckSettings(const PopulationSettings& settings);

/** What SearchByPopulation takes to its last generation; of the hybrid with descents all along. */
Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings);
}
