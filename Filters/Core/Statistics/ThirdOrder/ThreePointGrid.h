// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"

#include <cstddef>

namespace ruc
{
/**
 * The grid on which S_rsq(r1, r2, theta) is known: r1 and r2 are the lags 0 to K, and theta = 360 t
 * / M degrees for t = 0 to M / 2, with M rays spaced evenly around a circle. In functions on the
 * grid r1 runs fastest and theta slowest.
 */
struct ThreePointGrid
{
  LagGrid Lags;
  int Directions; // M >= 2

  int Angles() const { return this->Directions / 2 + 1; }
  double Angle(int t) const { return 360.0 * t / this->Directions; } // in degrees

  int Points() const { return this->Lags.Count + 1; } // the number of r1, and of r2
  std::size_t SliceSize() const
  {
    return static_cast<std::size_t>(this->Points()) * this->Points();
  }
  std::size_t Size() const { return this->Angles() * this->SliceSize(); }
  std::size_t PlaceOf(int k1, int k2, int t) const
  {
    return t * this->SliceSize() + static_cast<std::size_t>(k2) * this->Points() + k1;
  }

  /** The number of ordered pairs of rays at an angle. */
  int RayPairs(int t) const
  {
    return t == 0 || 2 * t == this->Directions ? this->Directions : 2 * this->Directions;
  }
};
}
