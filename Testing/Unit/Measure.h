// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/PairSums/ExactPairSum.h"

/** The exact two-point probability of a pack, in one call. */
inline ruc::TwoPointProbability Measure(
  ruc::SpherePack pack, const ruc::Window& box, const ruc::LagGrid& lags)
{
  ruc::SortCanonically(pack);
  const ruc::ExactPairSum sum(pack, box, lags);
  std::vector<std::int64_t> sums(sum.SumsSize(), 0);
  sum.AddChunks(0, 1, sums.data());
  return sum.Result(sums);
}
