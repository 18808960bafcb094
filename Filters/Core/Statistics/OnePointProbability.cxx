// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/OnePointProbability.h"

#include "Geometry/SphereOverlap.h"

#include <numeric>

namespace ruc
{
std::vector<double> OnePointProbability(const SpherePack& pack, const Window& window)
{
  std::vector<double> fractions(pack.NumberOfModes(), 0.0);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    fractions[pack.Mode[i] - 1] += SphereVolume(pack.Radius[i]);
  }
  for (double& fraction : fractions)
  {
    fraction /= window.Volume();
  }
  fractions.push_back(1.0 - std::accumulate(fractions.begin(), fractions.end(), 0.0));
  return fractions;
}
}
