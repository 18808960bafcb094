// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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

/** A value with its standard error. Either is NaN where it is not known. */
struct ValueWithError
{
  double Value, Error;
};

/**
 * Returns sum / norm of all blocks of the data, with its standard error by the delete-one jackknife
 * over the blocks whose norm is above 0.
 */
inline ValueWithError JackknifeRatio(
  const std::vector<double>& sums, const std::vector<double>& norms)
{
  const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
  const double norm = std::accumulate(norms.begin(), norms.end(), 0.0);
  std::vector<double> without;
  for (std::size_t n = 0; n < sums.size(); ++n)
  {
    if (norms[n] > 0.0 && norms[n] < norm)
    {
      without.push_back((sum - sums[n]) / (norm - norms[n]));
    }
  }
  return { norm > 0.0 ? sum / norm : std::numeric_limits<double>::quiet_NaN(),
    JackknifeError(without) };
}
}
