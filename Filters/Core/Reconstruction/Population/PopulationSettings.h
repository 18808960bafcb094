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
/**
 * Settings of SearchByPopulation. The defaults are the paper's (section IV B) where it names a
 * number. The ranges stand in VisitSearch and VisitEnd.
 */
struct PopulationSettings : SearchSettings
{
  /** N_i, the number of members. */
  int Population = 512;
  /** The share of the first population that is made at random; the others are deposited. */
  double RandomShare = 0.5;
  /** The degree of overlap that a deposition allows (DepositBallistically). */
  double DepositionDegree = DefaultDepositionDegree;
  /** m, the number of members in the mating pool, at most Population. */
  int MatingPool = 16;
  /** 0 gives the best of the first population. */
  int MaximumGenerations = 10000;
  /** The search ends after this many generations without a better best member. */
  int PatienceGenerations = 300;

  /** The pressure of DrawMatingPool. */
  double SelectionPressure = 1.5;
  /** The overlap in percent at which OverlapPenalty is 1/2. */
  double HalfOverlap = 1.0;

  /** How often each GeneticOperator is drawn, in units of their sum, which is > 0. */
  ruc::OperatorWeights OperatorWeights = { 1, 1, 1, 1, 1, 1, 1, 1 };
  /** The share of the spheres that an operator on some of them changes. */
  double MutatedShare = 0.01;
  /** b of the non-uniform mutations. */
  double MutationShape = 2.0;
  /** The longest non-uniform mutation, in half edges. */
  double MutationReach = 1.0;
  /** G of (1 - g / G)^b. It is not MaximumGenerations, so that a search that has ended can be
   * carried on. */
  int MutationGenerations = 10000;
  /** The probability that a child is moved by springs until it is free of overlap. */
  double MassSpringProbability = 0.9;

  /** The temperature of AcceptanceProbability at the start, in units of the fitness. */
  double InitialTemperature = 1e-3;
  /** The factor of the temperature from one generation to the next. */
  double CoolingFactor = 0.98;
  /** After this many generations without improvement the temperature is the initial one again. */
  int ReheatingGenerations = 100;

  /**
   * 0 means an annealed population. A larger number means a hybrid that takes this many steps of
   * L-BFGS on F2 at a time. In every generation the best member goes on downhill, and its Hessian
   * is kept; in the first generation it is member 0, the start of SearchByGradient. The mating pool
   * rests as long as that gains at the rate of LeastProgress (GradientSearch.h) or more; else its
   * children are refined as well.
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
 * The settings that the hybrid has of its own: few members, of which the best descends, and small
 * mutations. The names in VisitSearch are those that users see.
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
 * Returns the settings of a hybrid: its own, operators and selection that suit small mutations, and
 * the rest from those of the annealed population. Throws std::invalid_argument where its own are
 * out of range.
 */
PopulationSettings HybridOf(const PopulationSettings& annealed, const HybridSettings& own);

/** Throws std::invalid_argument for settings out of range. */
void CheckSettings(const PopulationSettings& settings);

/**
 * What SearchByPopulation takes if it runs to its last generation; for the hybrid, if every
 * generation descends.
 */
Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings);
}
