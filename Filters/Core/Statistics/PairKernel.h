// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace ruc
{
/** The lags r_k = k Spacing, k = 0 to Count. */
struct LagGrid
{
  double Spacing;
  int Count;

  double Maximum() const { return this->Spacing * this->Count; }
};

/**
 * The orientation-averaged overlap g_ab(r_k; d) of one pair of radii, tabulated over the distance d.
 *
 * Distances lie on knots d_m = First + m Spacing, m = 0 to Intervals, which reach from d <= 0 to the
 * cut-off of the pairs or beyond; g is 0 from r_K + a + b on. Between knots g is the cubic Hermite interpolant of its exact values and slopes,
 * so it is continuous together with its derivative. A function on the knots is an array of 2 (Intervals + 1) numbers:
 * value and Spacing x slope of knot 0, of knot 1, … The contact distance a + b is itself a knot.
 *
 * What is summed over many pairs is linear in g; hence a histogram of Hermite weights over the knots, in the same
 * layout, is all that has to be known of their distances.
 */
class PairKernel
{
public:
  /** Knots are at most `resolution` times the smaller radius apart; no distance may exceed `cutoff` >= a + b. */
  PairKernel(double a, double b, const LagGrid& lags, double resolution, double cutoff);

  double First;
  double Spacing;
  int Intervals;
  std::size_t Size() const { return 2 * (static_cast<std::size_t>(this->Intervals) + 1); }

  /** Adds the sum over knots of weights x g(r_k) to sums[k], k = 0 to K. */
  void AddOverlap(const double* weights, double* sums) const;

  /** Adds the sum over k of lambda[k] g(r_k; d), as a function on the knots, to `potential`. */
  void AddPotential(const double* lambda, double* potential) const;

  /** Adds factor x (a + b - d)+^2, the penalty of an overlapping pair, which the knots represent exactly. */
  void AddOverlapPenalty(double factor, double* potential) const;

private:
  // For d >= a + b, 2 d r g(r; d) = h(d - r) depends on the difference alone. The knots fall into as many phases as
  // there are knots between two lags; in one phase d_m - r_k = Offset - n LagSpacing.
  struct Phase
  {
    int FirstDifference;
    std::vector<double> Moment, Slope; // h and Spacing x dh/dt at n = FirstDifference, …
  };
  // For d < a + b both terms of g count; value and Spacing x slope at r_0, r_1, …
  struct OverlappingKnot
  {
    std::vector<double> Value, Slope;
  };

  // The difference n = k - BaseLag of a knot, and its phase
  int BaseLag(int knot) const { return this->LagsPerKnot > 0 ? knot * this->LagsPerKnot : knot / this->KnotsPerLag; }
  int PhaseOf(int knot) const { return this->LagsPerKnot > 0 ? 0 : knot % this->KnotsPerLag; }

  LagGrid Lags;
  double Contact;
  int LagsPerKnot = 0; // one of these two is 0
  int KnotsPerLag = 0;
  std::vector<Phase> Phases;
  std::vector<OverlappingKnot> OverlappingKnots;
};
}
