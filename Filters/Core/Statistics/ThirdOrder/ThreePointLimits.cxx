// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThreePointLimits.h"

#include <algorithm>
#include <functional>

namespace ruc
{
double DegenerateLimit::Difference() const
{
  std::vector<double> difference(this->Values.size());
  std::transform(this->Values.begin(), this->Values.end(), this->Limit.begin(), difference.begin(),
    std::minus<>());
  return DiscreteNorm(difference);
}

double DegenerateLimit::StandardError() const
{
  return DiscreteNorm(this->Errors);
}

std::array<DegenerateLimit, 3> FindDegenerateLimits(
  const ThreePointProbability& probability, std::size_t triple, const TwoPointProbability& twoPoint)
{
  const PhaseTriple& phases = probability.GetTriples()[triple];
  const auto find = [&](const char* place, int along1, int along2, int other, bool degenerates)
  {
    DegenerateLimit limit;
    limit.Place = place;
    limit.Expected =
      degenerates ? "S_" + twoPoint.PhaseName(phases.R) + "_" + twoPoint.PhaseName(other) : "0";
    const std::vector<double>& expected = twoPoint.S(phases.R, other);
    for (int k = 0; k < probability.GetGrid().Points(); ++k)
    {
      limit.Values.push_back(probability.Value(triple, along1 * k, along2 * k, 0));
      limit.Errors.push_back(probability.Error(triple, along1 * k, along2 * k, 0));
      limit.Limit.push_back(degenerates ? expected[k] : 0.0);
    }
    return limit;
  };
  return { find("r1 axis", 1, 0, phases.S, phases.R == phases.Q),
    find("r2 axis", 0, 1, phases.Q, phases.R == phases.S),
    find("diagonal", 1, 1, phases.S, phases.S == phases.Q) };
}
}
