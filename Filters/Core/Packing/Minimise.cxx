// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/Minimise.h"

#include <lbfgs.h>

#include <algorithm>
#include <memory>
#include <new>

namespace ruc
{
namespace
{
struct Callbacks
{
  const std::function<double(const double*, double*)>& Evaluate;
  const std::function<bool(const double*, double, int)>& Progress;
  int Iterations = 0;
};

lbfgsfloatval_t EvaluateCallback(void* instance, const lbfgsfloatval_t* x,
  lbfgsfloatval_t* gradient, const int, const lbfgsfloatval_t)
{
  return static_cast<Callbacks*>(instance)->Evaluate(x, gradient);
}

int ProgressCallback(void* instance, const lbfgsfloatval_t* x, const lbfgsfloatval_t*,
  const lbfgsfloatval_t value, const lbfgsfloatval_t, const lbfgsfloatval_t, const lbfgsfloatval_t,
  int, int iteration, int)
{
  Callbacks* callbacks = static_cast<Callbacks*>(instance);
  callbacks->Iterations = iteration;
  return callbacks->Progress(x, value, iteration) ? 0 : 1;
}
}

int Minimise(std::vector<double>& x, const MinimiserSettings& settings,
  const std::function<double(const double* x, double* gradient)>& evaluate,
  const std::function<bool(const double* x, double value, int iteration)>& progress)
{
  lbfgs_parameter_t parameters;
  lbfgs_parameter_init(&parameters);
  parameters.m = settings.Memory;
  parameters.max_iterations = settings.MaximumIterations;
  parameters.epsilon =
    1e-12; // the callers decide; this only ends a minimisation that has nowhere to go
  parameters.max_linesearch = 40;

  // liblbfgs wants its vectors aligned, and a length that its vector loops divide
  const std::size_t length = (x.size() + 7) / 8 * 8;
  const std::unique_ptr<lbfgsfloatval_t, void (*)(lbfgsfloatval_t*)> work(
    lbfgs_malloc(static_cast<int>(length)), lbfgs_free);
  if (!work)
  {
    throw std::bad_alloc();
  }
  std::fill_n(work.get(), length, 0.0);
  std::copy(x.begin(), x.end(), work.get());
  const std::function<double(const double*, double*)> padded =
    [&](const double* place, double* gradient)
  {
    std::fill(gradient + x.size(), gradient + length, 0.0);
    return evaluate(place, gradient);
  };
  Callbacks called{ padded, progress };
  lbfgs(static_cast<int>(length), work.get(), nullptr, EvaluateCallback, ProgressCallback, &called,
    &parameters);
  std::copy_n(work.get(), x.size(), x.begin());
  return called.Iterations;
}
}
