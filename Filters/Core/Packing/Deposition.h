// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/** A periodic cube filled by ballistic deposition. */
struct BallisticDeposition
{
  /** x, y, z of every sphere in [0, edge)^3, in the order in which the radii were given. */
  std::vector<double> Centres;
  /**
   * The largest degree of overlap (a + b - d) / (a + b) of all pairs with radii a and b and centre
   * distance d, images included; 0 where none overlaps.
   */
  double Degree = 0.0;
};

/** With this degree every sphere finds its place at once up to volume fractions of 0.63. */
constexpr double DefaultDepositionDegree = 0.25;

/**
 * Puts spheres of these radii into the periodic cube from 0 to `edge`, one after another, the
 * largest first. Each place is drawn uniformly, and drawn again until the sphere overlaps none that
 * is there by more than `degree`, in [0, 1], of (a + b - d) / (a + b). The result depends on the
 * arguments alone; `number` tells the individuals of a population apart.
 *
 * A sphere that finds no place in 10 000 draws takes the one of them that exceeds the degree least,
 * so that the deposition always ends. Then, and only then, BallisticDeposition::Degree is above
 * `degree`. `carryOn` is called every thousand draws; when it returns false, the deposition is
 * given up and has no centres. Throws std::invalid_argument for a degree out of range.
 */
BallisticDeposition DepositBallistically(
  const std::vector<double>& radii, double edge, std::uint32_t seed, std::uint32_t number,
  double degree, const std::function<bool()>& carryOn = []() { return true; });
}
