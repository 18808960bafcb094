// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"

#include <vector>

namespace ruc
{
/**
 * What the multipoles around one centre (LocalMultipoles) say about the field in its sphere, for an
 * unordered pair of phases s, t:
 *
 *     Second(l) = l (l - 1) sum over m of n_lm Re(conj q_lm^s q_lm^t),
 *     Fourth(l) = the same with A and B = q / (2l + 3), which is X_l below.
 *
 * The mean of Second(l) over the spheres, weighted by their volume, is the spectrum Z(l), and
 *
 *     X_l = 3 l (l-1)(l-2)(l-3)(2l-1)(2l-3) [A^2 + 2 (2l+3)/(2l-3) A B + (2l+3)^2/((2l-5)(2l-1))
 * B^2]
 *         + (48/7) (l+1) l (l-1)(l-2) (2l+3)/(2l-5) B^2,   l >= 3.
 */
class MultipoleProducts
{
public:
  explicit MultipoleProducts(const LocalMultipoles& multipoles);

  /** Second(l) of all degrees from 2 on, from the multipoles of one centre. */
  void Second(const double* sums, int s, int t, double* ofDegrees) const;
  /**
   * Adds the gradient of the sum over the degrees of mu times Second(l) by the numbers q of the
   * centre to `gradient`. `mu` has a number for every degree from 2 on.
   */
  void AddGradient(const double* sums, int s, int t, const double* mu, double* gradient) const;
  /** Fourth(l), summed over the degrees; 0 without A. */
  double Fourth(const double* sums, int s, int t) const;

private:
  double Product(const double* a, const double* b, int l) const;

  const LocalMultipoles& Multipoles;
  std::vector<double> Weights; // n_lm of every l, m
};

/** What the degrees above the highest add, from each neighbour with itself alone. */
struct MultipoleRest
{
  double Second = 0.0, Fourth = 0.0;
};

/**
 * The rest of a neighbour: with t the square of the centre's radius over the distance, and `ratio`
 * the neighbour's radius over the centre's, sum over l > degree of the terms above. The sum of
 * Second has a closed form. Spheres that overlap a little count as touching. 0 where it is below
 * 10^-9.
 */
MultipoleRest FindMultipoleRest(double t, double ratio, int degree, bool withFourth);
}
