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
/** A cell of a population with what its fitness is made of. */
struct Member
{
  Chromosome Centres;
  double Objective = 0.0;
  double OverlapPercent = 0.0;

  /** False for one that was given up. */
  bool IsMade() const { return !this->Centres.empty(); }
};

/** F2 over a population, as in Table I. */
struct ObjectiveRange
{
  double Minimum = 0.0, Mean = 0.0, Maximum = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Minimum, self.Mean, self.Maximum);
  }
};

/** All of a search between two generations: it resumes from it to the same end, bit by bit. */
struct PopulationState
{
  int Generation = 0;
  std::vector<Chromosome> Centres; // of every member, x, y, z of every sphere
  std::vector<double> Objective;   // F2
  std::vector<double> OverlapPercent;
  ObjectiveRange First; // of the first population; (15) divides by its maximum
  double Temperature = 0.0;
  int Stagnation = 0;                   // generations without a better best member
  std::vector<SearchState> Convergence; // of the best member
  // Of the hybrid: the descent of the best member
  int Descending = -1; // the member, or -1
  DescentState Descent;

  void Add(Member member);

  /** Equation (15). */
  std::vector<double> Fitness(double halfOverlap) const;
  /** The member with the best fitness. */
  int BestMember(double halfOverlap) const;
  /** F2 of the members there are, one at least. */
  ObjectiveRange Range() const;

  /** Throws std::invalid_argument unless this is a state of so many members with so many spheres,
   * between two generations. */
  void Require(std::size_t members, std::size_t spheres) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Generation, self.Centres, self.Objective, self.OverlapPercent, self.First,
      self.Temperature, self.Stagnation, self.Convergence, self.Descending, self.Descent);
  }
};
}
