// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Packing/Deposition.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Reconstruction/Population/GeneticOperators.h"
#include "ruc/Reconstruction/SearchSettings.h"

namespace ruc
{
/** Defaults are the paper's (section IV B) where it names a number. */
struct PopulationSettings : SearchSettings
{
  int Population = 512;     // N_i, the members
  double RandomShare = 0.5; // of the first population at random, the others by deposition
  double DepositionDegree = DefaultDepositionDegree; // of overlap that a deposition allows
  int MatingPool = 16;                               // m, at most Population
  int MaximumGenerations = 10000;                    // 0 gives the best of the first population
  int PatienceGenerations = 300; // the search ends after as many without a better best member

  double SelectionPressure = 1.5; // of DrawMatingPool
  double HalfOverlap = 1.0;       // of OverlapPenalty, in percent

  ruc::OperatorWeights OperatorWeights = { 1, 1, 1, 1, 1, 1, 1, 1 };
  double MutatedShare = 0.01; // of the spheres that an operator on some changes
  double MutationShape = 2.0; // b of the non-uniform mutations
  double MutationReach = 1.0; // the longest non-uniform mutation, in half edges
  /** G of (1 - g / G)^b. It is not the maximum, so that a search that has ended can be carried on.
   */
  int MutationGenerations = 10000;
  double MassSpringProbability = 0.9; // that a child is moved by springs until free of overlap

  double InitialTemperature = 1e-3; // of the acceptance, in units of the fitness
  double CoolingFactor = 0.98;      // of the temperature, a generation
  int ReheatingGenerations = 100;   // back to the initial after as many without improvement

  /**
   * 0: annealed population. More: hybrid, with so many steps of L-BFGS on F2 at a time. In every
   * generation the best member goes on downhill, its Hessian kept; in the first generation it is
   * member 0, the start of SearchByGradient. The mating pool rests as long as that gains
   * LeastProgress (GradientSearch.h) or more; else its children are refined as well.
   */
  int RefinementSteps = 0;

  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    SearchSettings::VisitSearch(self, visit);
    visit("Population", self.Population, Range::AtLeast(2));
    visit("RandomShare", self.RandomShare, Range::From(0, 1));
    visit("DepositionDegree", self.DepositionDegree, Range::From(0, 1));
    visit("MatingPool", self.MatingPool, Range::AtLeast(1));
    visit("SelectionPressure", self.SelectionPressure, Range::From(1, 2));
    visit("HalfOverlap", self.HalfOverlap, Range::Above(0));
    for (auto& weight : self.OperatorWeights)
    {
      visit("OperatorWeights", weight, Range::AtLeast(0));
    }
    visit("MutatedShare", self.MutatedShare, Range::Above(0, 1));
    visit("MutationShape", self.MutationShape, Range::AtLeast(0));
    visit("MutationReach", self.MutationReach, Range::Above(0, 1));
    visit("MutationGenerations", self.MutationGenerations, Range::AtLeast(1));
    visit("MassSpringProbability", self.MassSpringProbability, Range::From(0, 1));
    visit("InitialTemperature", self.InitialTemperature, Range::Above(0));
    visit("CoolingFactor", self.CoolingFactor, Range::Above(0, 1));
    visit("ReheatingGenerations", self.ReheatingGenerations, Range::AtLeast(1));
    visit("RefinementSteps", self.RefinementSteps, Range::AtLeast(0));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self& self, Visit&& visit)
  {
    SearchSettings::VisitEnd(self, visit);
    visit("MaximumGenerations", self.MaximumGenerations, Range::AtLeast(0));
    visit("PatienceGenerations", self.PatienceGenerations, Range::AtLeast(1));
  }
};

/**
 * What the hybrid has of its own: few members, of which the best descends, and small mutations.
 * The names are those that users see.
 */
struct HybridSettings
{
  int Population = 16;
  int MatingPool = 1;
  double MutationReach = 0.1;
  int RefinementSteps = 100;

  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    visit("HybridPopulation", self.Population, Range::AtLeast(2));
    visit("HybridMatingPool", self.MatingPool, Range::AtLeast(1));
    visit("HybridMutationReach", self.MutationReach, Range::Above(0, 1));
    visit("RefinementSteps", self.RefinementSteps, Range::AtLeast(1));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self&, Visit&&)
  {
  }
};

/**
 * The settings of a hybrid: its own, operators and selection that go with small mutations, and the
 * rest from those of the annealed population. Throws std::invalid_argument for those of its own
 * that are out of range.
 */
PopulationSettings HybridOf(const PopulationSettings& annealed, const HybridSettings& own);

/** Throws std::invalid_argument for settings out of range. */
void CheckSettings(const PopulationSettings& settings);

/** What SearchByPopulation takes to its last generation; of the hybrid with descents all along. */
Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings);
}
