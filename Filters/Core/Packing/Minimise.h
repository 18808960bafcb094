// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace ruc
{
/** How a minimisation is done and when it ends. */
struct MinimiserSettings
{
  int Memory = 20;           // pairs of vectors that approximate the Hessian
  int MaximumIterations = 0; // 0: no limit
};

/**
 * Minimises a function with L-BFGS (liblbfgs, which keeps its vectors as it is told here).
 *
 * `evaluate(x, gradient)` returns the value and fills the gradient. `progress(x, value, iteration)`
 * is called after every iteration and ends the minimisation when it returns false. `x` holds the
 * last iterate at the end. Returns the number of iterations.
 */
int Minimise(std::vector<double>& x, const MinimiserSettings& settings,
  const std::function<double(const double* x, double* gradient)>& evaluate,
  const std::function<bool(const double* x, double value, int iteration)>& progress);
}
