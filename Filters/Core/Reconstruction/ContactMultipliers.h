// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace ruc
{
/** What the contacts of a dense cell remember between two iterations of a search. */
struct ContactState
{
  double Stiffness = 0.0; // mu; 0 in a search without multipliers
  int Round = 0;          // of multipliers; 0 in the soft stage before them
  double Deepest = 1.0;   // the deepest overlap at the end of the last round, in contacts
  /** The pairs of spheres that press on each other, with their multipliers, in order. */
  std::vector<std::int32_t> First, Second;
  std::vector<double> Multiplier;

  /** Whether the numbers of a state that was read can be those of a cell of so many spheres. */
  bool CanBe(int spheres) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(
      self.Stiffness, self.Round, self.Deepest, self.First, self.Second, self.Multiplier);
  }
};

/**
 * The contacts of a dense cell in a descent: an augmented Lagrangian (Nocedal, Wright, Numerical
 * Optimization, chapter 17), which reaches a minimum without overlap at a moderate stiffness, where
 * a penalty alone would have to become ever stiffer.
 *
 * For every pair with the contact a + b, c = d / (a + b) - 1 - Margin must not be below 0. The sum
 * of (max(0, lambda - mu c)^2 - lambda^2) / (2 mu) over all pairs is added to F2. At the end of a
 * round, Update sets every lambda to max(0, lambda - mu c); lambda then is the force, in units of
 * F2 for a relative displacement, with which the ban on overlap holds F2 up.
 *
 * Sums go over pairs in one order, so that they depend on the centres and the state alone.
 */
class ContactMultipliers
{
public:
  static constexpr double Margin = 1e-8;

  /** `spheres` is kept as a copy; `state` as a reference. */
  ContactMultipliers(const SpherePack& spheres, const Window& box, ContactState& state);

  /** Returns the sum at these centres and adds its gradient, unless that is null. */
  double Add(const double* centres, double* gradient);

  /** Ends a round: sets the multipliers, and returns the deepest overlap, -c, or 0. */
  double Update(const double* centres);

private:
  struct Pair
  {
    std::int32_t First, Second;
    double Multiplier;
  };

  void FindNear(const double* centres);
  template <class Visit>
  void ForEach(const double* centres, Visit&& visit);

  SpherePack Spheres;
  Window Box;
  ContactState& State;
  std::vector<Pair> Near;       // all that may touch before a sphere has gone too far
  std::vector<double> ListedAt; // the centres
};
}
