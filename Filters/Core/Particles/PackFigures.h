// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Window/Window.h"

namespace ruc
{
/** What estimates have to know of a pack. */
struct PackFigures
{
  double Spheres = 0.0;
  Window Observed; // of the centres
  double MeanRadius = 0.0;
  double MeanSquareRadius = 0.0;
  double LargestRadius = 0.0;
  double MeanDiameter = 0.0; // volume mean
  int Modes = 1;
  int Types = 1; // of spheres: mode and radius

  double Density() const { return this->Spheres / this->Observed.Volume(); }
  /** Of centres up to `distance` apart; periodic images count. In a window that of a cube of the
   * same volume, up to its edge. */
  double PairsWithin(double distance) const;
  /** Spheres on a line of that length. */
  double HitsOn(double length) const;
};

/** A pack spread over the ranks (SharePack), and its overlap. */
Estimate EstimatePack(const PackFigures& pack);
}
