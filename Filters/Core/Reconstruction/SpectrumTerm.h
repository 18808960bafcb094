// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/CellObjective.h"
#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"
#include "ruc/Statistics/ThirdOrder/MultipoleProducts.h"
#include "ruc/Statistics/ThirdOrder/PackSpectrum.h"

#include <cstddef>
#include <vector>

namespace ruc
{
class CellSurroundings;

/**
 * How far the spectrum of a cell is from the pack's (PackSpectrum): the mean over the degrees of
 * the squared difference in the pack's standard errors. Its sum is zeta, the three-point parameter
 * of conductivity. Spheres may overlap a little.
 *
 * The centres are shared out over the ranks. Sums over centres are integers, so that every rank
 * gets the same bits, whatever the number of ranks and threads.
 */
class SpectrumTerm
{
public:
  /** `pack` and `communicator` are kept as references. */
  SpectrumTerm(const CellContents& contents, const PackSpectrum& pack, Communicator& communicator);

  /**
   * Returns the misfit. Adds `factor` times its gradient to `gradient`, unless it is null.
   * Collective.
   */
  double Evaluate(const double* centres, double factor, double* gradient);

private:
  std::vector<double> FindSpectrum(const CellSurroundings& cell);
  void AddGradient(const CellSurroundings& cell, const std::vector<double>& slopes, double factor,
    double* gradient);

  CellContents Contents;
  const PackSpectrum& Pack;
  Communicator& Ranks;
  LocalMultipoles Multipoles;
  MultipoleProducts Products;
  std::vector<double> Share; // of every sphere in the volume of the spheres, over 2 (1 - c)
  std::vector<double> Sums;  // the multipoles around every sphere of this rank
};

/** What one evaluation with its gradient takes. */
Estimate EstimateSpectrumTerm(const CellFigures& cell);
}
