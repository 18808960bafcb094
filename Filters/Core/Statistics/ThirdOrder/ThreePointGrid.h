// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"

#include <cstddef>

namespace ruc
{
/**
 * Where S_rsq(r1, r2, theta) is known: r1 and r2 on the lags 0 to K, theta = 360 t / M degrees for
 * t = 0 to M / 2, with M rays evenly around a circle. Functions on it have r1 running fastest,
 * theta slowest.
 */
struct ThreePointGrid
{
  LagGrid Lags;
  int Directions; // M >= 2

  int Angles() const { return this->Directions / 2 + 1; }
  double Angle(int t) const { return 360.0 * t / this->Directions; } // degrees

  int Points() const { return this->Lags.Count + 1; } // of r1, or r2
  std::size_t SliceSize() const
  {
    return static_cast<std::size_t>(this->Points()) * this->Points();
  }
  std::size_t Size() const { return this->Angles() * this->SliceSize(); }
  std::size_t PlaceOf(int k1, int k2, int t) const
  {
    return t * this->SliceSize() + static_cast<std::size_t>(k2) * this->Points() + k1;
  }

  /** Ordered pairs of rays at an angle. */
  int RayPairs(int t) const
  {
    return t == 0 || 2 * t == this->Directions ? this->Directions : 2 * this->Directions;
  }
};
}
