// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * Sums of many piecewise linear functions on the lags k = 0…K, in units of their spacing. They are
 * kept as second differences: K + 2 numbers, of which a kink changes two.
 */

namespace ruc
{
/** Adds `value` for all k. */
inline void AddConstant(double value, double* differences)
{
  differences[0] += value;
  differences[1] -= value;
}

/** Adds slope (k - from)+, where 0 <= from <= K. */
inline void AddRamp(double slope, double from, double* differences)
{
  int next = static_cast<int>(from);
  next += next < from;
  differences[next] += slope * (next - from);
  differences[next + 1] += slope * (1.0 + from - next);
}

/** Turns the differences into `unit` times the function. */
inline void Integrate(double unit, int lags, double* differences)
{
  double slope = 0.0, value = 0.0;
  for (int k = 0; k <= lags; ++k)
  {
    slope += differences[k];
    value += slope;
    differences[k] = unit * value;
  }
}
}
