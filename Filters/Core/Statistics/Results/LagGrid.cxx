// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/LagGrid.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/Phases.h"

#include <stdexcept>

namespace ruc
{
void CheckNumberOfLags(int modes, const LagGrid& lags)
{
  if (lags.Count < 1 || lags.Count > MostLags)
  {
    throw std::invalid_argument(
      Text("NumberOfLags requires 1 <= NumberOfLags <= ", MostLags, ", got ", lags.Count, "."));
  }
  constexpr double mostNumbers = 5e7; // in all functions, 400 MB
  const double pairs = PairsOfPhases(modes);
  if (pairs * (lags.Count + 1.0) > mostNumbers)
  {
    throw std::invalid_argument(Text("NumberOfLags requires at most ",
      static_cast<int>(mostNumbers / pairs), " lags for ", modes, " modes, got ", lags.Count, "."));
  }
}
}
