// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThirdOrderParameters.h"

#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// The weights of int f(r) / r dr over the lags 0 to `last`, where f is 0 at 0 and linear between
// every `step`-th lag
std::vector<double> RadialWeights(int last, int step)
{
  std::vector<double> weights(last + 1, 0.0);
  weights[std::min(step, last)] += 1.0;
  for (int k = step; k < last; k += step)
  {
    const int next = std::min(k + step, last);
    const double width = next - k, logarithm = std::log(static_cast<double>(next) / k);
    weights[k] += next / width * logarithm - 1.0;
    weights[next] += 1.0 - k / width * logarithm;
  }
  return weights;
}

// The Clenshaw-Curtis weights of the nodes cos(pi t / n), for n even or odd
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
{
  if (grid.Directions % 2 != 0 || grid.Directions < 8 || grid.Lags.Count < 2)
  {
    return;
  }
  this->Fine = RadialWeights(grid.Lags.Count, 1);
  this->Coarse = RadialWeights(grid.Lags.Count, 2);
  const std::vector<double> weights = AngularWeights(grid.Directions / 2);
  for (int t = 0; t < grid.Angles(); ++t)
  {
    const double weight = weights[t], x = std::cos(2.0 * Pi * t / grid.Directions);
    this->SecondWeights.push_back(weight * 0.5 * (3.0 * x * x - 1.0));
    this->FourthWeights.push_back(weight * 0.125 * ((35.0 * x * x - 30.0) * x * x + 3.0));
  }
}

ThirdOrderParameters ThirdOrderRule::Parameters(const ThirdOrderIntegrals& integrals)
{
  const double c = integrals.Fraction, both = c * (1.0 - c);
  const double zeta = 9.0 / (2.0 * both) * integrals.Second;
  return { zeta, 5.0 / 21.0 * zeta + 150.0 / (7.0 * both) * integrals.Fourth };
}

ThirdOrderParameters ThirdOrderRule::StandardErrors(
  const ThirdOrderIntegrals& whole, const std::vector<ThirdOrderIntegrals>& batches)
{
  // Both are (a combination of I_2 and I_4) / (c (1 - c))
  const double c = whole.Fraction, both = c * (1.0 - c);
  const ThirdOrderParameters parameters = Parameters(whole);
  double sums[2] = { 0.0, 0.0 }, squares[2] = { 0.0, 0.0 };
  for (const ThirdOrderIntegrals& batch : batches)
  {
    const double relative = (1.0 - 2.0 * c) * (batch.Fraction - c) / both;
    const double zeta = 9.0 / (2.0 * both) * (batch.Second - whole.Second);
    const double eta = 5.0 / 21.0 * zeta + 150.0 / (7.0 * both) * (batch.Fourth - whole.Fourth);
    const double changes[2] = { zeta - parameters.Zeta * relative,
      eta - parameters.Eta * relative };
    for (int n = 0; n < 2; ++n)
    {
      sums[n] += changes[n];
      squares[n] += changes[n] * changes[n];
    }
  }
  const double count = static_cast<double>(batches.size());
  const auto error = [&](int n)
  {
    return count > 1.0
      ? std::sqrt(std::max(squares[n] - sums[n] * sums[n] / count, 0.0) / (count * (count - 1.0)))
      : std::numeric_limits<double>::quiet_NaN();
  };
  return { error(0), error(1) };
}
}
