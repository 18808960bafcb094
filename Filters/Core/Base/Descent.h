// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <tuple>
#include <vector>

namespace ruc
{
/** The state of a descent: all that it needs to go on to the same end, bit by bit. */
struct DescentState
{
  std::vector<double> Place;
  std::vector<double> Gradient; // at Place; empty before the first evaluation
  double Value = 0.0;
  int Iterations = 0;
  /**
   * The last steps and the changes of the gradient over them, the oldest first. They approximate
   * the Hessian.
   */
  std::vector<std::vector<double>> Steps, GradientChanges;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(
      self.Place, self.Gradient, self.Value, self.Iterations, self.Steps, self.GradientChanges);
  }
};

/** Settings of a descent. */
struct DescentSettings
{
  std::size_t Memory = 20; // how many steps are remembered
  double FirstStep = 1.0;  // the length of the first step, before there is a Hessian
  int MaximumTrials = 40;  // the most evaluations along one line
};

/** Why a descent ended. */
enum class DescentEnd
{
  Told,     // `progress` returned false
  GivenUp,  // `evaluate` returned false
  NowhereTo // no lower value was found along the line, nor down the gradient itself
};

/**
 * Minimises a function with L-BFGS (Nocedal, Math. Comp. 35, 773, 1980), from where `state` stands
 * until it is told to stop. The state can be kept and resumed.
 *
 * The line search bisects for the weak Wolfe conditions, which suits functions with kinks, such as
 * F2 where one of its norms vanishes (Lewis, Overton, Math. Program. 141, 135, 2013).
 *
 * `evaluate(place, gradient, value)` fills in the gradient and the value, or returns false to give
 * up, which leaves the state as it was after the last iteration. `progress(state)` is called after
 * every iteration and returns whether to go on. The last evaluation before it is the one at the
 * state's place. The value never grows from one iteration to the next.
 */
DescentEnd Descend(DescentState& state, const DescentSettings& settings,
  const std::function<bool(const double* place, double* gradient, double& value)>& evaluate,
  const std::function<bool(const DescentState&)>& progress);
}
