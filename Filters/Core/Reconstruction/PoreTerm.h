// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Statistics/Neighbours/NeighbourSums.h"
#include "ruc/Statistics/Neighbours/SurfaceDistances.h"

namespace ruc
{
/**
 * How far a cell's pores are from the pack's (NeighbourSums): the misfit (FindMisfit) of the
 * distances from the points of a cubic lattice in the matrix to the nearest surface, in squares of
 * the pack's standard errors. The lattice is about as fine as a fifth of the mean spacing of the
 * centres. A descent would fit the points of one lattice better than the pores, so it is to be
 * moved now and then.
 *
 * The planes of the lattice are shared out over the ranks. All sums are integers, so that every
 * rank gets the same bits, whatever the number of ranks and threads.
 */
class PoreTerm
{
public:
  /** `sums` and `communicator` are kept as references. */
  PoreTerm(const CellContents& contents, const NeighbourSums& sums, Communicator& communicator);

  /** Moves the lattice to its n-th place, n >= 0. */
  void MoveLattice(int n);

  /**
   * Returns the misfit. Adds `factor` times its gradient to `gradient`, unless it is null.
   * Collective.
   */
  double Evaluate(const double* centres, double factor, double* gradient);

private:
  std::vector<double> FindValues(const SurfaceDistances& found);
  void AddGradient(const SpherePack& pack, const SurfaceDistances& found,
    const std::vector<double>& slopes, double factor, double* gradient);

  CellContents Contents;
  const NeighbourSums& Sums;
  Communicator& Ranks;
  PointLattice Lattice;
  int FirstPlane, LastPlane; // of this rank
};

/** What one evaluation with its gradient takes for a cell of so many spheres. */
Estimate EstimatePoreTerm(double spheres);
}
