// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ruc
{
/**
 * The pairs of a cell as the terms of its objective see them: its whole PairHistogram, in fixed
 * point.
 */
struct PairCounts
{
  const std::int64_t* Sums; // PairHistogram::Size() numbers
  double Scale;             // the weight of a pair in them
};
}
