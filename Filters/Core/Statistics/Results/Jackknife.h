// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace ruc
{
/**
 * Returns the standard error of an estimate by the delete-one jackknife, from the estimates that
 * are left when one block of the data is left out at a time; NaN for fewer than two.
 */
inline double JackknifeError(const std::vector<double>& without)
{
  const double count = static_cast<double>(without.size());
  double mean = 0.0, squares = 0.0;
  for (const double estimate : without)
  {
    mean += estimate / count;
  }
  for (const double estimate : without)
  {
    squares += (estimate - mean) * (estimate - mean);
  }
  return count > 1.0 ? std::sqrt(squares * (count - 1.0) / count)
                     : std::numeric_limits<double>::quiet_NaN();
}
}
