// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

namespace ruc
{
/** The largest number of lags. */
constexpr int MostLags = 100000;

/** The lags r_k = k Spacing for k = 0 to Count. The paper's K is Count. */
struct LagGrid
{
  double Spacing;
  int Count;

  double Maximum() const { return this->Spacing * this->Count; }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Spacing, self.Count);
  }
};

/**
 * Throws std::invalid_argument unless the number of lags is from 1 to MostLags and all functions
 * S_rs together have at most 5e7 numbers.
 */
void CheckNumberOfLags(int modes, const LagGrid& lags);
}
