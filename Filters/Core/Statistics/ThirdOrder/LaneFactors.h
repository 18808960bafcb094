// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * What the sums of LocalMultipoles and their forces have in common: spheres side by side in the
 * lanes of vectors, and the factors by which their terms end at a cut-off. All is always inlined,
 * so that it is compiled for the instruction set of its caller.
 */

#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"

#include <algorithm>
#include <cstddef>

namespace ruc
{
constexpr int NumberOfLanes = 8;
// The alignment is stated, since that of GCC depends on the instruction set
using Lanes = double __attribute__((
  vector_size(NumberOfLanes * sizeof(double)), aligned(NumberOfLanes * sizeof(double))));

constexpr int LowestDegree = 2;
// The highest degree beyond the near cut-off. A_6m falls as r^-5.
constexpr int HighestOfFar = 6;

/** The share of a term that is left near a cut-off; `ratio` is r / cut-off. */
[[gnu::always_inline]] inline void FindSmoothEnd(const Lanes& ratio, Lanes& left)
{
  const Lanes zero = {};
  const Lanes raw = (ratio - 0.7) * (1.0 / 0.3);
  const Lanes low = raw < zero ? zero : raw;
  const Lanes t = low > zero + 1.0 ? zero + 1.0 : low;
  left = 1.0 - t * t * t * (10.0 - t * (15.0 - 6.0 * t));
}

/** Its slope by the ratio. */
[[gnu::always_inline]] inline void FindSmoothSlope(const Lanes& ratio, Lanes& slope)
{
  const Lanes zero = {};
  const Lanes raw = (ratio - 0.7) * (1.0 / 0.3);
  const Lanes low = raw < zero ? zero : raw;
  const Lanes t = low > zero + 1.0 ? zero + 1.0 : low;
  slope = t * t * (1.0 - t) * (1.0 - t) * (-30.0 / 0.3);
}

/** The spheres from the place `from` of a list on. Lanes without a sphere repeat one, without
 * volume. */
[[gnu::always_inline]] inline void LoadLanes(const LocalMultipoles::Neighbours::List& list,
  std::size_t from, Lanes& x, Lanes& y, Lanes& z, Lanes& radius)
{
  const std::size_t size = list.X.size();
  for (int k = 0; k < NumberOfLanes; ++k)
  {
    const std::size_t j = std::min(from + k, size - 1);
    x[k] = list.X[j];
    y[k] = list.Y[j];
    z[k] = list.Z[j];
    radius[k] = from + k < size ? list.Radius[j] : 0.0;
  }
}
}
