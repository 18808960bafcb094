// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Descent.h"
#include "ruc/Reconstruction/Population/GeneticOperators.h"
#include "ruc/Reconstruction/SearchState.h"

#include <tuple>
#include <vector>

namespace ruc
{
/** A cell of a population, with the numbers that make up its fitness. */
struct Member
{
  Chromosome Centres;
  double Objective = 0.0; // F2
  double OverlapPercent = 0.0;

  /** Returns whether the member was made; false for one whose making was given up. */
  bool IsMade() const { return !this->Centres.empty(); }
};

/** The least, mean and greatest F2 of a population, as in Table I of the paper. */
struct ObjectiveRange
{
  double Minimum = 0.0, Mean = 0.0, Maximum = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Minimum, self.Mean, self.Maximum);
  }
};

/**
 * The whole state of a search between two generations, from which it resumes to the same end, bit
 * by bit.
 */
struct PopulationState
{
  int Generation = 0;
  // For every member x, y, z of every sphere, its F2 and its overlap
  std::vector<Chromosome> Centres;
  std::vector<double> Objective;
  std::vector<double> OverlapPercent;
  ObjectiveRange First; // of the first population; (15) divides by its maximum
  double Temperature = 0.0;
  int Stagnation = 0;                   // generations since the best member last became better
  std::vector<SearchState> Convergence; // the best member of every generation
  // The descent of the best member in the hybrid
  int Descending = -1; // the number of that member, or -1
  DescentState Descent;

  /** Appends a member. */
  void Add(Member member);

  /** Returns the fitness of every member, equation (15). */
  std::vector<double> Fitness(double halfOverlap) const;
  /** Returns the number of the member with the best fitness. */
  int BestMember(double halfOverlap) const;
  /** Returns the range of F2. There must be a member. */
  ObjectiveRange Range() const;

  /**
   * Throws std::invalid_argument unless this is a state between two generations with `members`
   * members of `spheres` spheres.
   */
  void Require(std::size_t members, std::size_t spheres) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Generation, self.Centres, self.Objective, self.OverlapPercent, self.First,
      self.Temperature, self.Stagnation, self.Convergence, self.Descending, self.Descent);
  }
};
}
