// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/ThirdOrderParameters.h"

#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

// Weights of int f(r) / r dr over the lags, f linear between them and 0 at 0
std::vector<double> RadialWeights(int lags)
{
  std::vector<double> weights(lags + 1, 0.0);
  weights[1] += 1.0;
  for (int k = 1; k < lags; ++k)
  {
    const double logarithm = std::log1p(1.0 / k);
    weights[k] += (k + 1) * logarithm - 1.0;
    weights[k + 1] += 1.0 - k * logarithm;
  }
  weights[0] = 0.0;
  return weights;
}

// Clenshaw-Curtis weights of the nodes cos(pi t / n), n even or odd
std::vector<double> AngularWeights(int n)
{
  std::vector<double> weights;
  for (int t = 0; t <= n; ++t)
  {
    double sum = 1.0;
    for (int j = 1; 2 * j <= n; ++j)
    {
      const double term = 2.0 / (4.0 * j * j - 1.0) * std::cos(2.0 * j * t * Pi / n);
      sum -= 2 * j == n ? 0.5 * term : term;
    }
    weights.push_back((t == 0 || t == n ? 1.0 : 2.0) * sum / n);
  }
  return weights;
}
}

ThirdOrderRule::ThirdOrderRule(const ThreePointGrid& grid)
  : Grid(grid)
{
  if (grid.Directions % 2 != 0 || grid.Directions < 8 || grid.Lags.Count < 1)
  {
    return;
  }
  this->Radial = RadialWeights(grid.Lags.Count);
  const std::vector<double> weights = AngularWeights(grid.Directions / 2);
  for (int t = 0; t < grid.Angles(); ++t)
  {
    const double weight = weights[t], x = std::cos(2.0 * Pi * t / grid.Directions);
    this->WeightsOfZeta.push_back(weight * 0.5 * (3.0 * x * x - 1.0));
    this->WeightsOfEta.push_back(weight * 0.125 * ((35.0 * x * x - 30.0) * x * x + 3.0));
  }
}

ThirdOrderParameters ThirdOrderRule::FromIntegrals(double fraction, double i2, double i4) const
{
  if (!this->IsValid())
  {
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    return { notANumber, notANumber };
  }
  const double both = fraction * (1.0 - fraction);
  const double zeta = 9.0 / (2.0 * both) * i2;
  return { zeta, 5.0 / 21.0 * zeta + 150.0 / (7.0 * both) * i4 };
}
}
