// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/PackShare.h"

#include <vector>

namespace ruc
{
/** What a cubic periodic cell is filled with, and its size. */
struct CellContents
{
  std::vector<int> Count;     // n_i of every mode
  std::vector<double> Radius; // r_i, half the volume mean diameter of the pack's mode
  double Edge = 0.0;          // h_c, equation (12)

  int NumberOfSpheres() const;
};

/**
 * The contents of the cell for a first guess h_0 of its edge: n_i = nearest whole number of N_i
 * h_0^3 / V, diameters d_i = (sum d^3 / N_i)^(1/3) over the pack's mode, and the edge h_c that
 * minimises F1 (11), the distance between the volume fractions of pack and cell.
 *
 * Throws std::invalid_argument when a mode would have no sphere in the cell, or when h_c leaves no
 * room for the largest.
 */
CellContents FindCellContents(const PackTotals& pack, double edge);

/** The same for a cell of `spheres` spheres in all; where rounding makes that number impossible, of
 * the next one above. */
CellContents FindCellContents(const PackTotals& pack, int spheres);

/** F1, equation (11), of a cell of the given edge. */
double OnePointDifference(
  const CellContents& contents, const std::vector<double>& packFractions, double edge);
}
