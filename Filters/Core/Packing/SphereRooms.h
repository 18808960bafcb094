// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

namespace ruc
{
/**
 * How far spheres that move may go from where they were listed until they are listed again: less
 * than the distance at which two images of one sphere would be near, and no more for large spheres
 * than for small ones, which are as quick.
 */
class SphereRooms
{
public:
  static constexpr double LeastEdgeInDiameters = 2.05;

  /**
   * For the spheres of a pack in a box, whose radii grow to `largestGrowth` times what they are.
   * Throws std::invalid_argument unless every periodic edge is longer than LeastEdgeInDiameters
   * times the largest diameter they grow to.
   */
  SphereRooms(const SpherePack& pack, const Window& box, double largestGrowth);

  /** The way of a sphere that may grow to this radius. */
  double Of(double radius) const;

  /** The least and the greatest radius that spheres grow to. */
  double Least, Greatest;

private:
  double Quarter; // of the shortest period
};
}
