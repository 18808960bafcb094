// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Window/Window.h"

#include <vector>

namespace ruc
{
/** What estimates have to know about a pack. Lengths are in its unit. */
struct PackFigures
{
  double Spheres = 0.0;
  Window Observed; // in which the centres lie
  double MeanRadius = 0.0;
  double MeanSquareRadius = 0.0;
  double LargestRadius = 0.0;
  double MeanDiameter = 0.0; // the volume mean
  int Modes = 1;
  int Types = 1;                       // the number of different pairs of mode and radius
  std::vector<double> ModeRadius = {}; // half the volume mean diameter of every known mode
  std::vector<double> ModeShare = {};  // of its spheres in all, in number

  /** The number of spheres per unit volume. */
  double Density() const { return this->Spheres / this->Observed.Volume(); }
  /**
   * The number of unordered pairs of centres up to `distance` apart. Where all axes are periodic,
   * images count. Any other window is taken for a cube of the same volume, and the distance for its
   * edge at most.
   */
  double PairsWithin(double distance) const;
  /** The number of spheres that a line of that length meets. */
  double HitsOn(double length) const;
};

/** What it takes to spread a pack over the ranks (SharePack) and to measure its overlap. */
Estimate EstimatePack(const PackFigures& pack);
}
