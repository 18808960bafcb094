// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackShare.h"

#include <tuple>
#include <vector>

namespace ruc
{
/** How much of every mode a medium holds. */
struct ModeAmounts
{
  std::vector<double> Number; // spheres per unit volume
  std::vector<double> Radius; // half the volume mean diameter d_i = (sum d^3 / N_i)^(1/3)

  /** The amounts of a pack in its window. */
  ModeAmounts(const PackTotals& pack);
  /**
   * The amounts for given volume fractions and diameters. Throws std::invalid_argument unless there
   * are as many fractions as diameters (at least one), fractions are > 0 and add up to less than 1,
   * and diameters are finite and > 0.
   */
  ModeAmounts(const std::vector<double>& fractions, const std::vector<double>& diameters);

  int NumberOfModes() const { return static_cast<int>(this->Number.size()); }
  /** The volume fraction c_i of a mode, counted from 0. */
  double Fraction(int mode) const;
  /**
   * The volume mean diameter of all spheres: (sum of n_i d_i^3 / sum of n_i)^(1/3) over the modes.
   */
  double MeanDiameter() const;
};

/** The least distance of two surfaces in a cell; both parts count together. */
struct LeastGap
{
  double Length = 0.0; // >= 0
  double Share = 0.0;  // >= 0, of the sum of both radii

  bool IsNone() const { return this->Length == 0.0 && this->Share == 0.0; }
  /** Spheres with such radii touch where the gap of the spheres themselves is the least one. */
  double Enlarged(double radius) const { return radius * (1.0 + this->Share) + 0.5 * this->Length; }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Length, self.Share);
  }
};

/**
 * What a cubic periodic cell is filled with, and its size. Its spheres have types: each mode has
 * one, or several diameters (DivideModes). Types are in the order of their modes.
 */
struct CellContents
{
  std::vector<int> Count;     // n_i, the spheres of every type
  std::vector<double> Radius; // r_i, half the volume mean diameter of what it stands for
  double Edge = 0.0;          // h_c, equation (12)
  std::vector<int> Mode = {}; // of every type, from 1; empty where types are modes
  LeastGap Gap = {};

  int NumberOfSpheres() const;
  int NumberOfModes() const;
  int ModeOf(int type) const { return this->Mode.empty() ? type + 1 : this->Mode[type]; }

  /** The part of the cell that its spheres fill. */
  double Fraction() const;

  /** The radius of every sphere, in the order of the types. */
  std::vector<double> Radii() const;

  /** The same cell of spheres enlarged by the least gap, which must not overlap. */
  CellContents Enlarged() const;

  /** The periodic cube from 0 to the edge. */
  Window MakeBox() const;
  /**
   * Returns the spheres in the order of the types, first all of mode 1. `centres` holds x, y, z of
   * each, anywhere in space; they are wrapped into the box.
   */
  SpherePack MakePack(const double* centres) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Count, self.Radius, self.Edge, self.Mode, self.Gap);
  }
};

/**
 * Returns the contents of the cell for a first guess h_0 of its edge. n_i is the nearest whole
 * number of spheres of mode i in h_0^3, all with the mode's volume mean diameter, and the edge is
 * h_c, which minimises F1 (11), the distance between the volume fractions of pack and cell.
 *
 * Throws std::invalid_argument when a mode would have no sphere in the cell, or when h_c leaves no
 * room for the largest sphere.
 */
CellContents FindCellContents(const ModeAmounts& amounts, double edge);

/**
 * The same for a cell of `spheres` spheres in all, or, where rounding makes that number impossible,
 * of the next possible number above.
 */
CellContents FindCellContents(const ModeAmounts& amounts, int spheres);

/** The same for given numbers of spheres of every mode. */
CellContents FindCellContents(const ModeAmounts& amounts, const std::vector<int>& counts);

/**
 * Returns contents with up to `diameters` >= 1 sizes in every mode in place of one, each of about
 * as many spheres of the cell. The k-th size is the volume mean of as large a part of the pack's
 * spheres of that mode in the order of their size; all are scaled a little, so that the volume of
 * the mode stays. 0 means one size for each sphere of the cell. Every rank holds all radii of one
 * mode of the pack for a while. Collective.
 */
CellContents DivideModes(
  const CellContents& contents, int diameters, const PackShare& pack, Communicator& ranks);

/** F1, equation (11), of a cell of the given edge. */
double OnePointDifference(
  const CellContents& contents, const std::vector<double>& packFractions, double edge);
}
