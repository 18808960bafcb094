// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Voxels/RadialFit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ruc
{
std::vector<double> FitRadial(const std::vector<double>& lengths, const std::vector<double>& values,
  double atZero, const LagGrid& lags)
{
  const int count = lags.Count;
  // The normal equations, which are tridiagonal; that of r_0 is not used
  std::vector<double> diagonal(count + 1, 0.0), upper(count + 1, 0.0), right(count + 1, 0.0);
  for (std::size_t n = 0; n < lengths.size(); ++n)
  {
    if (!(lengths[n] > 0.0) || std::isnan(values[n]))
    {
      continue;
    }
    const double place = lengths[n] / lags.Spacing;
    const int k = std::clamp(static_cast<int>(place), 0, count - 1);
    const double b = std::min(place - k, 1.0), a = 1.0 - b;
    const double weight = 1.0 / (lengths[n] * lengths[n]);
    diagonal[k] += weight * a * a;
    diagonal[k + 1] += weight * b * b;
    upper[k] += weight * a * b;
    right[k] += weight * a * values[n];
    right[k + 1] += weight * b * values[n];
  }
  right[1] -= upper[0] * atZero;
  for (int k = 2; k <= count; ++k)
  {
    const double factor = upper[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * upper[k - 1];
    right[k] -= factor * right[k - 1];
  }
  std::vector<double> fitted(count + 1, atZero);
  for (int k = count; k >= 1; --k)
  {
    const double next = k < count ? upper[k] * fitted[k + 1] : 0.0;
    fitted[k] = (right[k] - next) / diagonal[k];
  }
  return fitted;
}
}
