// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/ThirdOrder/ThreePointGrid.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace ruc
{
/** Zeta and eta of a phase of a two-phase medium, each from 0 to 1. */
struct ThirdOrderParameters
{
  double Zeta, Eta;
};

/** What the parameters are made of: c, I_2 and I_4 of ThirdOrderRule. */
struct ThirdOrderIntegrals
{
  double Fraction, Second, Fourth;
};

/**
 * The three-point (third-order) parameters of a phase of fraction c from its S_3 = S_rrr,
 *
 *     zeta = 9 / (2 c (1 - c)) I_2,  eta = 5 zeta / 21 + 150 / (7 c (1 - c)) I_4,
 *     I_n = int dr1 / r1 int dr2 / r2 int dcos(theta) P_n(cos theta) [S_3 - S_2(r1) S_2(r2) / c]
 *
 * with the Legendre polynomials P_n and integrals over r1 and r2 from 0 to infinity, over
 * cos(theta) from -1 to 1 (S. Torquato, Random Heterogeneous Materials, Springer 2002, chapters 20
 * and 21; G. W. Milton, Phys. Rev. Lett. 46, 542, 1981). They enter the bounds on conductivity
 * (zeta) and on elastic moduli (both). All that is not the phase has 1 - zeta and 1 - eta.
 *
 * Here r1 and r2 end at the last lag R. What lies beyond falls as R^-3: for spheres of radius a it
 * is about 0.002 of zeta and 0.01 of eta at R = 8 a. The angles of a ThreePointGrid with an even
 * number of directions are the nodes of the Clenshaw-Curtis rule, which integrates P_2 and P_4 to
 * 0, so that the term with S_2 drops out. The error of 20 directions is as small for zeta at R = 8
 * a and grows beyond; eta of dense spheres is 2 % lower by them than by 40. Over
 * the lags, functions are bilinear. What that misses near r1 = r2 = 0, where S_3 has the kink of
 * |r1 u - r2 v|, is linear in the lag spacing, and is taken out by extrapolation from every lag and
 * every second lag. Spheres that nearly touch have features of the width of their gaps: of equal
 * spheres at 0.55, lags of 0.2, 0.1 and 0.05 radii give 0.47, 0.88 and 1.00 of zeta, and 0.86, 1.00
 * and 1.00 of eta.
 */
class ThirdOrderRule
{
public:
  /** The rule is valid if the number of directions is even and at least 8, and K >= 2. */
  explicit ThirdOrderRule(const ThreePointGrid& grid);

  bool IsValid() const { return !this->SecondWeights.empty(); }

  /**
   * Integrates S_3, which is `value(place)` at a place of the grid; `fraction` is c. I_2 and I_4
   * are NaN without a valid rule.
   */
  template <class Value>
  ThirdOrderIntegrals Integrate(double fraction, Value&& value) const;

  static ThirdOrderParameters Parameters(const ThirdOrderIntegrals& integrals);

  /**
   * Returns the standard errors of the parameters of `whole`, from the integrals of batches, to
   * first order in their scatter. They are NaN for fewer than two batches.
   */
  static ThirdOrderParameters StandardErrors(
    const ThirdOrderIntegrals& whole, const std::vector<ThirdOrderIntegrals>& batches);

private:
  std::vector<double> Fine, Coarse; // weights of the lags by every lag, and by every second one
  std::vector<double> SecondWeights, FourthWeights; // weights of the angles with P_2 and P_4
};

template <class Value>
ThirdOrderIntegrals ThirdOrderRule::Integrate(double fraction, Value&& value) const
{
  constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
  if (!this->IsValid())
  {
    return { fraction, notANumber, notANumber };
  }
  ThirdOrderIntegrals integrals = { fraction, 0.0, 0.0 };
  std::size_t place = 0;
  for (std::size_t t = 0; t < this->SecondWeights.size(); ++t)
  {
    double slice = 0.0;
    for (std::size_t k2 = 0; k2 < this->Fine.size(); ++k2)
    {
      double fine = 0.0, coarse = 0.0;
      for (std::size_t k1 = 0; k1 < this->Fine.size(); ++k1)
      {
        const double s = value(place++);
        fine += this->Fine[k1] * s;
        coarse += this->Coarse[k1] * s;
      }
      slice += 2.0 * this->Fine[k2] * fine - this->Coarse[k2] * coarse;
    }
    integrals.Second += this->SecondWeights[t] * slice;
    integrals.Fourth += this->FourthWeights[t] * slice;
  }
  return integrals;
}
}
