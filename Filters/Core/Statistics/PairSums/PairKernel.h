// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"

#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * How far apart the knots of a PairKernel may be, in units of the smaller radius. Knots divide the
 * lag spacing into the fewest equal parts of at most `Coarsest`, so that the kinks of g at d = a +
 * b + r_k fall on knots. Where the lag spacing is less than `Finest`, knots are as many lags apart
 * as fit into `Finest`.
 */
struct KnotResolution
{
  double Coarsest, Finest;
};

/** The resolution for sums with an error below 1e-6 c_r. */
constexpr KnotResolution ExactKnots = { 0.125, 0.0075 };
/**
 * The resolution for the objective of a search: F2 is within 1e-3 of its value, from tables of a
 * third of the size.
 */
constexpr KnotResolution SearchKnots = { 0.125, 0.125 };

/**
 * The orientation-averaged overlap g_ab(r_k; d) of one pair of radii, tabulated over the distance
 * d.
 *
 * Distances lie on knots d_m = First + m Spacing, m = 0 to Intervals, which reach from d <= 0 to
 * the cut-off of the pairs or beyond; g is 0 from r_K + a + b on. Between knots g is the cubic
 * Hermite interpolant of its exact values and slopes, so that it is continuous together with its
 * derivative. A function on the knots is an array of 2 (Intervals + 1) numbers: the value and
 * Spacing x slope of knot 0, of knot 1, and so on. The contact distance a + b is itself a knot.
 *
 * What is summed over many pairs is linear in g. Hence a histogram of Hermite weights over the
 * knots, in the same layout, is all that has to be known about their distances.
 */
class PairKernel
{
public:
  /** `cutoff` >= a + b is the largest distance of a pair. */
  PairKernel(double a, double b, const LagGrid& lags, double cutoff,
    const KnotResolution& resolution = ExactKnots);

  /** Returns the spacing of the knots for a pair whose smaller radius is this. */
  static double KnotSpacing(
    double smallerRadius, const LagGrid& lags, const KnotResolution& resolution = ExactKnots);

  /**
   * How many bytes the tables of a kernel take. They grow with the number of lags that fit into the
   * spheres.
   */
  static double TableBytes(
    double a, double b, const LagGrid& lags, const KnotResolution& resolution = ExactKnots);

  double First;
  double Spacing;
  int Intervals;
  std::size_t Size() const { return 2 * (static_cast<std::size_t>(this->Intervals) + 1); }

  /** Adds the sum over knots of weights x g(r_k) to sums[k], for k = 0 to K. */
  void AddOverlap(const double* weights, double* sums) const;

  /** Adds the sum over k of lambda[k] g(r_k; d), as a function on the knots, to `potential`. */
  void AddPotential(const double* lambda, double* potential) const;

  /**
   * Adds factor x (contact - d)+^2, the penalty of a pair that is nearer than `contact`, to
   * `potential`. The knots represent it exactly if the contact is a + b.
   */
  void AddOverlapPenalty(double factor, double contact, double* potential) const;

private:
  // 2 d r g = h(d - r) - h(d + r) depends on difference and sum alone. The knots fall into as many
  // phases as there are knots between two lags. In one phase d_m - r_k and d_m + r_k are Offset - n
  // LagSpacing for whole n, with Offset = First + phase x Spacing.
  struct Phase
  {
    int First;                         // n of the first entry
    std::vector<double> Moment, Slope; // h and Spacing x dh/dt; beyond them both are 0
  };
  // The factors of Moment and Slope with which a knot's value and slope enter 2 r g; at d = 0 in
  // the limit
  struct Factors
  {
    double ValueOfMoment, ValueOfSlope, SlopeOfMoment, SlopeOfSlope;
    bool Sum; // whether the term of d + r counts, as it does where the spheres overlap
  };
  Factors FactorsOf(double d) const;
  // Calls visit(lag, moment, slope, count, step) for stretches of lags. From `lag` on, the numbers
  // at 0, step, 2 step, … behind the two pointers stand for d - r (step 1) or for d + r (step -1),
  // the latter only if `sum`.
  template <class Visit>
  void ForEachStretch(int knot, bool sum, Visit&& visit) const;

  LagGrid Lags;
  double RadiusA, RadiusB;
  int ContactKnot;
  int LagsPerKnot = 0; // one of LagsPerKnot and KnotsPerLag is 0
  int KnotsPerLag = 0;
  std::vector<Phase> Phases;
};
}
