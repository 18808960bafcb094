// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/OnePointProbability.h"

#include <numeric>

namespace ruc
{
std::vector<double> OnePointProbability(const PackTotals& pack)
{
  std::vector<double> fractions;
  for (double volume : pack.Volume)
  {
    fractions.push_back(volume / pack.Observed.Volume());
  }
  fractions.push_back(1.0 - std::accumulate(fractions.begin(), fractions.end(), 0.0));
  return fractions;
}
}
