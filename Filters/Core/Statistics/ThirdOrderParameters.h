// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/ThreePointGrid.h"

#include <cstddef>
#include <vector>

namespace ruc
{
/** Zeta and eta of a phase of a two-phase medium, each from 0 to 1. */
struct ThirdOrderParameters
{
  double Zeta, Eta;
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
 * Here r1 and r2 end at the last lag, beyond which S_3 must not depend on theta any more; in
 * between functions are linear over a lag spacing. The angles of a ThreePointGrid with an even
 * number of directions are the nodes of the Clenshaw-Curtis rule, which integrates P_2 and P_4 to
 * 0, so the term with S_2 drops out.
 */
class ThirdOrderRule
{
public:
  /** Not everything is a number unless the directions are even and at least 8, and K >= 1. */
  explicit ThirdOrderRule(const ThreePointGrid& grid);

  bool IsValid() const { return !this->WeightsOfZeta.empty(); }

  /** `value(place)` is S_3 at that place of the grid; `fraction` is c. */
  template <class Value>
  ThirdOrderParameters Evaluate(double fraction, Value&& value) const;

private:
  ThirdOrderParameters FromIntegrals(double fraction, double i2, double i4) const;

  ThreePointGrid Grid;
  std::vector<double> Radial;                      // of every lag
  std::vector<double> WeightsOfZeta, WeightsOfEta; // P_2 and P_4 with the rule's, of every angle
};

template <class Value>
ThirdOrderParameters ThirdOrderRule::Evaluate(double fraction, Value&& value) const
{
  double i2 = 0.0, i4 = 0.0;
  std::size_t place = 0;
  for (std::size_t t = 0; t < this->WeightsOfZeta.size(); ++t)
  {
    double slice = 0.0;
    for (double outer : this->Radial)
    {
      double row = 0.0;
      for (double inner : this->Radial)
      {
        row += inner * value(place++);
      }
      slice += outer * row;
    }
    i2 += this->WeightsOfZeta[t] * slice;
    i4 += this->WeightsOfEta[t] * slice;
  }
  return this->FromIntegrals(fraction, i2, i4);
}
}
