// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Intersection volume of two spheres and its average over directions, in closed form.
 *
 * Two spheres of radii a and b whose centres are t apart share the lens volume V_ab(t). If one of
 * them is moved by a lag r in a direction drawn at random, the expected shared volume is
 *
 *     g_ab(r; d) = [ h_ab(d - r) - h_ab(d + r) ] / (2 d r),
 *     h_ab(t)    = integral over u from |t| to infinity of u V_ab(u),
 *
 * with d the distance of the centres before the move; h_ab is even in t and zero for |t| >= a + b.
 * With s = a + b, q = |a - b| and (x)+ = max(x, 0)
 *
 *     h_ab(t) = pi/12 { 4 a b [(s-t)+^3 + (q-t)+^3] - s (s-t)+^4 + q (q-t)+^4
 *                      + [(s-t)+^5 - (q-t)+^5] / 5 },   t >= 0.
 *
 * Summed over the pairs of a pack of spheres that do not overlap, g is its two-point probability
 * function.
 */

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
/** Volume of a sphere. */
double SphereVolume(double radius);

/** V_ab(t): the volume shared by two spheres of radii a, b > 0 whose centres are t >= 0 apart. */
double LensVolume(double a, double b, double t);

/** h_ab(t) as defined above; it is even in t. */
double OverlapMoment(double a, double b, double t);

/** dh_ab/dt = -t V_ab(|t|); it is odd in t. */
double OverlapMomentSlope(double a, double b, double t);

/** g_ab(r; d) and its derivative with respect to the distance d. */
struct AveragedOverlap
{
  double Value;
  double Slope;
};

/**
 * Returns g_ab and dg_ab/dd for lag r >= 0 and centre distance d. g_ab is even in d, and the limits
 * r = 0 and d = 0 are taken exactly.
 */
AveragedOverlap OrientationAveragedOverlap(double a, double b, double r, double d);

/**
 * 12 / pi V_ab(t) without branches, for loops that are to become vector loops. t is moved into [|a
 * - b|, a + b], outside of which the volume is constant. The last digits may differ from
 * LensVolume.
 */
class LensFormula
{
public:
  LensFormula(double a, double b)
    : Contact(a + b)
    , Inside(std::max(std::abs(a - b), std::numeric_limits<double>::min()))
    , Product(3.0 * (a - b) * (a - b))
  {
  }
  double operator()(double t) const
  {
    const double u = std::min(std::max(t, this->Inside), this->Contact);
    const double depth = this->Contact - u;
    return depth * depth * (u + 2.0 * this->Contact - this->Product / u);
  }

  const double Contact;

private:
  double Inside, Product;
};

/** 12 / pi h_ab(t) for t >= 0, without branches as well. */
class MomentFormula
{
public:
  MomentFormula(double a, double b)
    : Contact(a + b)
    , Difference(std::abs(a - b))
    , Product(4.0 * a * b)
  {
  }
  double operator()(double t) const
  {
    const double u = std::max(this->Contact - t, 0.0);
    const double v = std::max(this->Difference - t, 0.0);
    return u * u * u * (this->Product - this->Contact * u + 0.2 * u * u) +
      v * v * v * (this->Product + this->Difference * v - 0.2 * v * v);
  }

private:
  double Contact, Difference, Product;
};
}
