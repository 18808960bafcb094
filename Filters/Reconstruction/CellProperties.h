// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Range.h"
#include "ruc/Reconstruction/CellContents.h"

#include <functional>
#include <vector>

/**
 * What a user says of the size of a cell, its spheres and the lags at which it is compared. All
 * lengths are in the unit of the pack or table.
 */
struct CellProperties
{
  int NumberOfParticles = 0; // 0 means the number that CellSize gives
  double CellSize = 0.0;     // the first guess h_0 of the edge; 0 means twice the saturation length
  double MaximumLag = 0.0;   // 0 means half the edge
  int NumberOfLags = 277;    // K
  double SaturationTolerance = 0.0005; // an absolute probability
  std::vector<double> ModeDiameters;   // take the place of those of the input
  std::vector<int> ModeCounts;         // take the place of CellSize and NumberOfParticles
  int DiametersPerMode = 1;            // sizes of spheres in a mode; 0 means one for each sphere
  ruc::LeastGap Gap;                   // between the surfaces of any two spheres

  /** See ruc::SearchSettings. The ranges of MaximumLag and NumberOfLags come from ruc::LagLimit. */
  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    visit("NumberOfParticles", self.NumberOfParticles, ruc::Range::AtLeast(0));
    visit("CellSize", self.CellSize, ruc::Range::AtLeast(0));
    visit("SaturationTolerance", self.SaturationTolerance, ruc::Range::Above(0));
    visit("DiametersPerMode", self.DiametersPerMode, ruc::Range::AtLeast(0));
    visit("MinimumGap", self.Gap.Length, ruc::Range::AtLeast(0));
    visit("MinimumGapShare", self.Gap.Share, ruc::Range::AtLeast(0));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self&, Visit&&)
  {
  }

  /** Throws std::invalid_argument for values that are out of range or contradict each other. */
  void Check() const;

  /**
   * Returns whether no number of spheres is given, so that CellSize or the input gives the size.
   */
  bool HasNoCounts() const { return this->NumberOfParticles == 0 && this->ModeCounts.empty(); }

  /** Returns the amounts of the input, with the ModeDiameters if they are given. */
  ruc::ModeAmounts FindAmounts(const ruc::ModeAmounts& ofInput) const;

  /**
   * Returns the contents of the cell. `findEdge` is called if nothing else gives its size, and
   * returns the first guess of the edge.
   */
  ruc::CellContents FindContents(
    const ruc::ModeAmounts& amounts, const std::function<double()>& findEdge) const;
};
