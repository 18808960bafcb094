// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/PairCounts.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"

#include <vector>

namespace ruc
{
/**
 * The penalty for spheres that overlap, a term of CellObjective:
 *
 *     w sum over overlapping pairs of ((a + b - d) / r)^2,
 *
 * where a and b are enlarged by the least gap of the cell, and r is the mean radius of its spheres,
 * weighted by volume. It is a fixed pair potential, which is tabulated once.
 */
class OverlapTerm
{
public:
  /** `classes` are the cell's own and must outlive the term. The weight w is 1 at first. */
  OverlapTerm(const CellContents& contents, const PairHistogram& classes);

  void SetWeight(double weight);

  /** Returns the penalty of all pairs. */
  double Evaluate(const PairCounts& pairs) const;

  /** Adds the penalty of a pair to `potential`, a function on the knots of all classes. */
  void AddPotential(std::vector<double>& potential) const;

private:
  const PairHistogram& Classes;
  LeastGap Gap;
  double MeanRadius;
  std::vector<double> Penalties; // the penalty of a pair, on the knots of all classes
};
}
