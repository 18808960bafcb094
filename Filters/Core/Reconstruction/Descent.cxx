// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
using Numbers = std::vector<double>;

// Of the weak Wolfe conditions
constexpr double SufficientDecrease = 1e-4, SufficientFlattening = 0.9;

double Dot(const Numbers& a, const Numbers& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// a + t b
void AddScaled(Numbers& a, double t, const Numbers& b)
{
  std::transform(
    a.begin(), a.end(), b.begin(), a.begin(), [&](double x, double y) { return x + t * y; });
}

// The two-loop recursion
Numbers Direction(const DescentState& state, double firstStep)
{
  Numbers direction = state.Gradient;
  const std::size_t kept = state.Steps.size();
  if (kept == 0)
  {
    const double scale = -firstStep / std::sqrt(Dot(direction, direction));
    std::transform(
      direction.begin(), direction.end(), direction.begin(), [&](double g) { return scale * g; });
    return direction;
  }
  Numbers shares(kept), curvatures(kept);
  for (std::size_t n = kept; n-- > 0;)
  {
    curvatures[n] = Dot(state.Steps[n], state.GradientChanges[n]);
    shares[n] = Dot(state.Steps[n], direction) / curvatures[n];
    AddScaled(direction, -shares[n], state.GradientChanges[n]);
  }
  const Numbers& last = state.GradientChanges.back();
  const double scale = curvatures.back() / Dot(last, last);
  for (double& d : direction)
  {
    d *= scale;
  }
  for (std::size_t n = 0; n < kept; ++n)
  {
    const double share = Dot(state.GradientChanges[n], direction) / curvatures[n];
    AddScaled(direction, shares[n] - share, state.Steps[n]);
  }
  for (double& d : direction)
  {
    d = -d;
  }
  return direction;
}

void Remember(DescentState& state, Numbers step, Numbers change, std::size_t memory)
{
  if (!(Dot(step, change) > 0.0))
  {
    return;
  }
  if (state.Steps.size() == memory)
  {
    state.Steps.erase(state.Steps.begin());
    state.GradientChanges.erase(state.GradientChanges.begin());
  }
  state.Steps.push_back(std::move(step));
  state.GradientChanges.push_back(std::move(change));
}
}

DescentEnd Descend(DescentState& state, const DescentSettings& settings,
  const std::function<bool(const double* place, double* gradient, double& value)>& evaluate,
  const std::function<bool(const DescentState&)>& progress)
{
  if (state.Gradient.empty())
  {
    Numbers gradient(state.Place.size());
    if (!evaluate(state.Place.data(), gradient.data(), state.Value))
    {
      return DescentEnd::GivenUp;
    }
    state.Gradient = std::move(gradient);
  }
  while (true)
  {
    const Numbers direction = Direction(state, settings.FirstStep);
    const double slope = Dot(state.Gradient, direction);
    double low = 0.0, high = std::numeric_limits<double>::infinity(), length = 1.0;
    Numbers place, gradient(state.Place.size());
    double value = 0.0;
    bool found = false;
    for (int trial = 0; slope < 0.0 && trial < settings.MaximumTrials && !found; ++trial)
    {
      place = state.Place;
      AddScaled(place, length, direction);
      if (!evaluate(place.data(), gradient.data(), value))
      {
        return DescentEnd::GivenUp;
      }
      if (!(value <= state.Value + SufficientDecrease * length * slope))
      {
        high = length;
      }
      else if (Dot(gradient, direction) < SufficientFlattening * slope)
      {
        low = length;
      }
      else
      {
        found = true;
      }
      if (!found)
      {
        length = std::isinf(high) ? 2.0 * low : 0.5 * (low + high);
      }
    }
    if (!found && state.Steps.empty())
    {
      return DescentEnd::NowhereTo;
    }
    if (!found) // what is remembered of another place may mislead
    {
      state.Steps.clear();
      state.GradientChanges.clear();
      continue;
    }
    Numbers step = place, change = gradient;
    AddScaled(step, -1.0, state.Place);
    AddScaled(change, -1.0, state.Gradient);
    Remember(state, std::move(step), std::move(change), settings.Memory);
    state.Place = std::move(place);
    state.Gradient = std::move(gradient);
    state.Value = value;
    ++state.Iterations;
    if (!progress(state))
    {
      return DescentEnd::Told;
    }
  }
}
}
