// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <tuple>

namespace ruc
{
/**
 * How far a cell's near neighbours and pores (NeighbourSums), its spectrum (PackSpectrum) and its
 * three-point functions around centres (NeighbourhoodMultipoles) are from the pack's: the mean
 * squares of the differences in the pack's standard errors. They are 1 for a cell that differs as
 * much as another pack of the same process would, and 0 where they are not looked at.
 */
struct NeighbourMisfits
{
  double Gaps = 0.0, Nearest = 0.0, Pores = 0.0, Spectrum = 0.0, ThirdOrder = 0.0;

  double Largest() const
  {
    return std::max({ this->Gaps, this->Nearest, this->Pores, this->Spectrum, this->ThirdOrder });
  }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Gaps, self.Nearest, self.Pores, self.Spectrum, self.ThirdOrder);
  }
};
}
