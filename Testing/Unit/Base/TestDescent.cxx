// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/Descent.h"

#include "Oracles.h"

namespace
{
using ruc::DescentEnd;
using ruc::DescentState;

// Rosenbrock's function of any even number of variables, whose least value is 0 at (1, …, 1)
bool Rosenbrock(const double* x, double* gradient, std::size_t n, double& value)
{
  value = 0.0;
  for (std::size_t i = 0; i < n; i += 2)
  {
    const double a = 1.0 - x[i], b = x[i + 1] - x[i] * x[i];
    value += a * a + 100.0 * b * b;
    gradient[i] = -2.0 * a - 400.0 * x[i] * b;
    gradient[i + 1] = 200.0 * b;
  }
  return true;
}

DescentState Start()
{
  DescentState state;
  for (int i = 0; i < 10; ++i)
  {
    state.Place.insert(state.Place.end(), { -1.2 + 0.1 * i, 1.0 });
  }
  return state;
}

DescentEnd Minimised(DescentState& state, int iterations, std::vector<double>* values = nullptr)
{
  return ruc::Descend(
    state, {}, [](const double* x, double* g, double& v) { return Rosenbrock(x, g, 20, v); },
    [&](const DescentState& now)
    {
      if (values)
      {
        values->push_back(now.Value);
      }
      return now.Iterations < iterations;
    });
}
}

TEST(Descent, FindsTheMinimum)
{
  DescentState state = Start();
  std::vector<double> values;
  EXPECT_EQ(Minimised(state, 10000, &values), DescentEnd::NowhereTo);
  for (double x : state.Place)
  {
    EXPECT_NEAR(x, 1.0, 1e-6);
  }
  for (std::size_t n = 1; n < values.size(); ++n)
  {
    EXPECT_LE(values[n], values[n - 1]);
  }
  EXPECT_LT(values.size(), 200u);
}

TEST(Descent, FollowsAKink)
{
  // |x| + 10 |y - x|: nowhere smooth where it is least
  DescentState state;
  state.Place = { 3.0, -2.0 };
  ruc::Descend(
    state, {},
    [](const double* x, double* g, double& value)
    {
      const double d = x[1] - x[0];
      value = std::abs(x[0]) + 10.0 * std::abs(d);
      g[1] = d > 0.0 ? 10.0 : -10.0;
      g[0] = (x[0] > 0.0 ? 1.0 : -1.0) - g[1];
      return true;
    },
    [](const DescentState& now) { return now.Iterations < 200; });
  EXPECT_LT(state.Value, 1e-3);
}

TEST(Descent, GoesOnFromItsStateToTheSameEnd)
{
  DescentState whole = Start();
  Minimised(whole, 30);
  for (int pause : { 1, 7, 25 })
  {
    DescentState state = Start();
    EXPECT_EQ(Minimised(state, pause), DescentEnd::Told);
    EXPECT_EQ(state.Iterations, pause);
    Minimised(state, 30);
    EXPECT_EQ(state.Place, whole.Place);
    EXPECT_EQ(state.Value, whole.Value);
  }
}

TEST(Descent, GivingUpLeavesTheLastIteration)
{
  DescentState whole = Start();
  Minimised(whole, 30);
  for (int evaluations : { 0, 1, 5, 12 })
  {
    DescentState state = Start();
    int left = evaluations;
    EXPECT_EQ(ruc::Descend(
                state, {},
                [&](const double* x, double* g, double& v)
                { return left-- > 0 && Rosenbrock(x, g, 20, v); },
                [](const DescentState&) { return true; }),
      DescentEnd::GivenUp);
    Minimised(state, 30);
    EXPECT_EQ(state.Place, whole.Place);
  }
}

TEST(Descent, TheFirstStepHasItsLength)
{
  DescentState state;
  state.Place = { 5.0, 5.0 };
  ruc::DescentSettings settings;
  settings.FirstStep = 0.25;
  ruc::Descend(
    state, settings,
    [](const double* x, double* g, double& value)
    {
      value = x[0] + x[1] + 0.5 * (x[0] * x[0] + x[1] * x[1]);
      g[0] = 1.0 + x[0];
      g[1] = 1.0 + x[1];
      return true;
    },
    [](const DescentState&) { return false; });
  // A bowl round (-1, -1), 6 sqrt(2) away. The slope falls to 0.9 of itself after 0.85; the first
  // step, 0.25, is doubled until then.
  EXPECT_NEAR(std::hypot(state.Place[0] - 5.0, state.Place[1] - 5.0), 1.0, 1e-12);
}
