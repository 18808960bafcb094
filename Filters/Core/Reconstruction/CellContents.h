// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackShare.h"

#include <tuple>
#include <vector>

namespace ruc
{
/** What a medium holds of every mode. */
struct ModeAmounts
{
  std::vector<double> Number; // of spheres per unit volume
  std::vector<double> Radius; // half the volume mean diameter d_i = (sum d^3 / N_i)^(1/3)

  /** Of a pack in its window. */
  ModeAmounts(const PackTotals& pack);
  /**
   * Of volume fractions and diameters. Throws std::invalid_argument unless there are as many of
   * both (at least one of each), fractions are > 0 and add up to less than 1, and diameters are >
   * 0.
   */
  ModeAmounts(const std::vector<double>& fractions, const std::vector<double>& diameters);

  int NumberOfModes() const { return static_cast<int>(this->Number.size()); }
  /** c_i. */
  double Fraction(int mode) const;
  /** (sum of n_i d_i^3 / sum of n_i)^(1/3) over the modes. */
  double MeanDiameter() const;
};

/** What a cubic periodic cell is filled with, and its size. */
struct CellContents
{
  std::vector<int> Count;     // n_i of every mode
  std::vector<double> Radius; // r_i, half the volume mean diameter of the pack's mode
  double Edge = 0.0;          // h_c, equation (12)

  int NumberOfSpheres() const;

  /** The radius of every sphere, in the order of the modes. */
  std::vector<double> Radii() const;

  /** The periodic cube from 0 to the edge. */
  Window MakeBox() const;
  /** The spheres in the order of the modes, first all of mode 1, with these centres (x, y, z of
   * each, anywhere in space) wrapped into the box. */
  SpherePack MakePack(const double* centres) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Count, self.Radius, self.Edge);
  }
};

/**
 * The contents of the cell for a first guess h_0 of its edge: n_i = nearest whole number of the
 * spheres of a mode in h_0^3, all of the mode's volume mean diameter, and the edge h_c that
 * minimises F1 (11), the distance between the volume fractions of pack and cell.
 *
 * Throws std::invalid_argument when a mode would have no sphere in the cell, or when h_c leaves no
 * room for the largest.
 */
CellContents FindCellContents(const ModeAmounts& amounts, double edge);

/** The same for a cell of `spheres` spheres in all; where rounding makes that number impossible, of
 * the next one above. */
CellContents FindCellContents(const ModeAmounts& amounts, int spheres);

/** The same for given numbers of spheres of every mode. */
CellContents FindCellContents(const ModeAmounts& amounts, const std::vector<int>& counts);

/** F1, equation (11), of a cell of the given edge. */
double OnePointDifference(
  const CellContents& contents, const std::vector<double>& packFractions, double edge);
}
