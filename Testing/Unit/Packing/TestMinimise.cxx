// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/Minimise.h"

#include "Oracles.h"

namespace
{
// sum of w_i (x_i - i)^2 in any number of dimensions: liblbfgs itself asks for a multiple of 8 or
// 16
double Bowl(const double* x, double* gradient, int dimensions)
{
  double value = 0.0;
  for (int i = 0; i < dimensions; ++i)
  {
    const double weight = 1.0 + i % 7;
    value += weight * (x[i] - i) * (x[i] - i);
    gradient[i] = 2.0 * weight * (x[i] - i);
  }
  return value;
}
}

TEST(Minimise, FindsTheMinimumInAnyNumberOfDimensions)
{
  for (int dimensions : { 1, 3, 7, 8, 9, 30 })
  {
    std::vector<double> x(dimensions, 5.5);
    ruc::Minimise(
      x, {}, [&](const double* p, double* g) { return Bowl(p, g, dimensions); },
      [](const double*, double, int) { return true; });
    ASSERT_EQ(x.size(), std::size_t(dimensions));
    for (int i = 0; i < dimensions; ++i)
    {
      EXPECT_NEAR(x[i], i, 1e-7) << dimensions; // the root of the rounding of the value
    }
  }
}

TEST(Minimise, EndsWhenItIsTold)
{
  const auto rosenbrock = [](const double* p, double* g)
  {
    g[0] = -400.0 * p[0] * (p[1] - p[0] * p[0]) - 2.0 * (1.0 - p[0]);
    g[1] = 200.0 * (p[1] - p[0] * p[0]);
    return 100.0 * std::pow(p[1] - p[0] * p[0], 2) + std::pow(1.0 - p[0], 2);
  };
  std::vector<double> x = { -1.2, 1.0 };
  ruc::MinimiserSettings settings;
  settings.MaximumIterations = 5;
  EXPECT_EQ(
    ruc::Minimise(x, settings, rosenbrock, [](const double*, double, int) { return true; }), 5);

  x = { -1.2, 1.0 };
  double last = 24.2, told[2] = {};
  const int iterations = ruc::Minimise(x, {}, rosenbrock,
    [&](const double* p, double value, int iteration)
    {
      EXPECT_LT(value, last);
      last = value;
      told[0] = p[0];
      told[1] = p[1];
      return iteration < 8;
    });
  EXPECT_EQ(iterations, 8);
  EXPECT_EQ(x, (std::vector<double>{ told[0], told[1] })); // the last iterate

  x = { -1.2, 1.0 };
  ruc::Minimise(x, {}, rosenbrock, [](const double*, double, int) { return true; });
  EXPECT_NEAR(x[0], 1.0, 1e-6);
  EXPECT_NEAR(x[1], 1.0, 1e-6);
}
