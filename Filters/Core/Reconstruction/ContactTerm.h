// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/NearPairs.h"
#include "ruc/Statistics/Neighbours/NeighbourSums.h"

#include <vector>

namespace ruc
{
/**
 * How far a cell's near neighbours are from the pack's (NeighbourSums): the misfit (FindMisfit) of
 * its gaps and that of its nearest gaps, in squares of the pack's standard errors. It is worked out
 * on every rank, in one order.
 */
class ContactTerm
{
public:
  /** `spheres` tells the radii of the cell. `sums` is kept as a reference. */
  ContactTerm(const SpherePack& spheres, const Window& box, const NeighbourSums& sums);

  struct Misfits
  {
    double Gaps = 0.0, Nearest = 0.0;
  };

  /**
   * Returns both misfits. Adds `factor` times the gradient of their sum to `gradient`, unless it is
   * null.
   */
  Misfits Evaluate(const double* centres, double factor, double* gradient);

private:
  double EvaluateGaps(const std::vector<NearPairs::Pair>& pairs, double factor, double* gradient);
  double EvaluateNearest(
    const std::vector<NearPairs::Pair>& pairs, double factor, double* gradient);

  const NeighbourSums& Sums;
  std::size_t Spheres;
  NearPairs Pairs;
};
}
