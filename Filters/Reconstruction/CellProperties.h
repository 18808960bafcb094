// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Range.h"
#include "ruc/Reconstruction/CellContents.h"

#include <functional>
#include <vector>

/** What a user says of a cell's size, its spheres and the lags at which it is compared. */
struct CellProperties
{
  int NumberOfParticles = 0; // 0: from CellSize
  double CellSize = 0.0;     // first guess h_0 of the edge; 0: twice the saturation length
  double MaximumLag = 0.0;   // 0: half the edge
  int NumberOfLags = 277;    // K
  double SaturationTolerance = 0.0005;
  std::vector<double> ModeDiameters; // in place of those of the input
  std::vector<int> ModeCounts;       // in place of CellSize and NumberOfParticles

  /** As of ruc::SearchSettings. The lags have their ranges from ruc::LagLimit. */
  template <class Self, class Visit>
  static void VisitSearch(Self& self, Visit&& visit)
  {
    visit("NumberOfParticles", self.NumberOfParticles, ruc::Range::AtLeast(0));
    visit("CellSize", self.CellSize, ruc::Range::AtLeast(0));
    visit("SaturationTolerance", self.SaturationTolerance, ruc::Range::Above(0));
  }
  template <class Self, class Visit>
  static void VisitEnd(Self&, Visit&&)
  {
  }

  /** Throws std::invalid_argument for what is out of range or contradicts itself. */
  void Check() const;

  /** Whether the size is left to the input: no number of spheres is given. */
  bool HasNoCounts() const { return this->NumberOfParticles == 0 && this->ModeCounts.empty(); }

  /** The amounts of the input, with the ModeDiameters where they are given. */
  ruc::ModeAmounts FindAmounts(const ruc::ModeAmounts& ofInput) const;

  /** `findEdge` is called where nothing else tells the size. */
  ruc::CellContents FindContents(
    const ruc::ModeAmounts& amounts, const std::function<double()>& findEdge) const;
};
