// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
using Numbers = std::vector<double>;
using EvaluateFunction = std::function<bool(const double* place, double* gradient, double& value)>;

// The constants of the weak Wolfe conditions
constexpr double SufficientDecrease = 1e-4, SufficientFlattening = 0.9;

double Dot(const Numbers& a, const Numbers& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Adds t b to a
void AddScaled(Numbers& a, double t, const Numbers& b)
{
  std::transform(
    a.begin(), a.end(), b.begin(), a.begin(), [&](double x, double y) { return x + t * y; });
}

// The direction of the next step, by the two-loop recursion
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

struct Point
{
  Numbers Place, Gradient;
  double Value = 0.0;
};

// Whether `evaluate` gave up, and whether a point was found
struct LineEnd
{
  bool GivenUp = false, Found = false;
};

// Finds a point along the direction that meets the weak Wolfe conditions
LineEnd SearchLine(const DescentState& state, const Numbers& direction, int maximumTrials,
  const EvaluateFunction& evaluate, Point& point)
{
  const double slope = Dot(state.Gradient, direction);
  double low = 0.0, high = std::numeric_limits<double>::infinity(), length = 1.0;
  for (int trial = 0; slope < 0.0 && trial < maximumTrials; ++trial)
  {
    point.Place = state.Place;
    AddScaled(point.Place, length, direction);
    if (!evaluate(point.Place.data(), point.Gradient.data(), point.Value))
    {
      return { true, false };
    }
    if (!(point.Value <= state.Value + SufficientDecrease * length * slope))
    {
      high = length;
    }
    else if (Dot(point.Gradient, direction) < SufficientFlattening * slope)
    {
      low = length;
    }
    else
    {
      return { false, true };
    }
    length = std::isinf(high) ? 2.0 * low : 0.5 * (low + high);
  }
  return {};
}

void MoveTo(DescentState& state, Point point, std::size_t memory)
{
  Numbers step = point.Place, change = point.Gradient;
  AddScaled(step, -1.0, state.Place);
  AddScaled(change, -1.0, state.Gradient);
  Remember(state, std::move(step), std::move(change), memory);
  state.Place = std::move(point.Place);
  state.Gradient = std::move(point.Gradient);
  state.Value = point.Value;
  ++state.Iterations;
}
}

DescentEnd Descend(DescentState& state, const DescentSettings& settings,
  const EvaluateFunction& evaluate, const std::function<bool(const DescentState&)>& progress)
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
    Point point{ {}, Numbers(state.Place.size()) };
    const LineEnd line = SearchLine(
      state, Direction(state, settings.FirstStep), settings.MaximumTrials, evaluate, point);
    if (line.GivenUp)
    {
      return DescentEnd::GivenUp;
    }
    if (line.Found)
    {
      MoveTo(state, std::move(point), settings.Memory);
      if (!progress(state))
      {
        return DescentEnd::Told;
      }
    }
    else if (state.Steps.empty())
    {
      return DescentEnd::NowhereTo;
    }
    else // what is remembered of another place may mislead
    {
      state.Steps.clear();
      state.GradientChanges.clear();
    }
  }
}
}
