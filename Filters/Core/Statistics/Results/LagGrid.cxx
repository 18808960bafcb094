// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/LagGrid.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/Phases.h"

namespace ruc
{
void CheckNumberOfLags(int modes, const LagGrid& lags)
{
  Require(lags.Count >= 1 && lags.Count <= MostLags, "NumberOfLags",
    Text("1 <= NumberOfLags <= ", MostLags), lags.Count);
  constexpr double mostNumbers = 5e7; // in all functions, 400 MB
  const double pairs = PairsOfPhases(modes);
  Require(pairs * (lags.Count + 1.0) <= mostNumbers, "NumberOfLags",
    Text("at most ", static_cast<int>(mostNumbers / pairs), " lags for ", modes, " modes"),
    lags.Count);
}
}
