// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tuple>

namespace ruc
{
/** More lags than this are refused. */
constexpr int MostLags = 100000;

/** The lags r_k = k Spacing, k = 0 to Count. */
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

/** Throws std::invalid_argument for a number of lags, or of all numbers of S_rs, out of range. */
void CheckNumberOfLags(int modes, const LagGrid& lags);
}
