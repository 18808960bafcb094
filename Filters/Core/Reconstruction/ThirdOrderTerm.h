// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Statistics/ThirdOrder/NeighbourhoodMultipoles.h"

#include <vector>

namespace ruc
{
class CellSurroundings;

/**
 * How far the three-point functions around the centres of a cell are from the pack's
 * (NeighbourhoodMultipoles): the mean over all T of the squared difference in the pack's standard
 * errors. A T of which the pack has no scatter does not count. Spheres may overlap a little.
 *
 * The centres are shared out over the ranks. Sums over centres are integers, so that every rank
 * gets the same bits, whatever the number of ranks and threads.
 */
class ThirdOrderTerm
{
public:
  /** So many multipoles of a rank, 256 MB, are kept at most from the value to the gradient. */
  static constexpr std::size_t MostKept = std::size_t(1) << 25;

  /**
   * `pack` and `communicator` are kept as references. Where the multipoles around all centres of a
   * rank are more than `mostKept`, they are summed up twice; the result is the same.
   */
  ThirdOrderTerm(const CellContents& contents, const NeighbourhoodMultipoles& pack,
    Communicator& communicator, std::size_t mostKept = MostKept);

  /**
   * Returns the misfit. Adds `factor` times its gradient to `gradient`, unless it is null.
   * Collective.
   */
  double Evaluate(const double* centres, double factor, double* gradient);

private:
  int ClassOf(const CellSurroundings& cell, std::size_t sphere) const;
  void Gather(const CellSurroundings& cell, std::size_t i,
    std::vector<ShellMultipoles::Neighbour>& around, std::vector<std::size_t>& spheres) const;
  double* KeptOf(std::size_t i);
  std::vector<double> FindValues(const CellSurroundings& cell, bool keeps);
  void AddGradient(const CellSurroundings& cell, const std::vector<double>& slopes, double factor,
    double* gradient);

  CellContents Contents;
  const NeighbourhoodMultipoles& Pack;
  Communicator& Ranks;
  ShellMultipoles Shells;
  std::vector<double> Centres; // of the cell, of each class
  std::size_t KeptAtMost;
  AlignedNumbers Kept; // the multipoles around every centre of this rank
};

/** What one evaluation with its gradient takes. */
Estimate EstimateThirdOrderTerm(const CellFigures& cell, const NeighbourhoodSettings& settings);
}
