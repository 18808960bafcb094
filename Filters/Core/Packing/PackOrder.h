// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <cstdint>

namespace ruc
{
/** How the spheres of a pack touch, and how far they are from a crystal. */
struct PackOrder
{
  /** The contacts of a sphere, walls included, on average over the spheres that are no rattlers. */
  double CoordinationNumber = 0.0;
  /**
   * The percentage of spheres that are not held by their neighbours: those with fewer than four
   * contacts with spheres that are held themselves.
   */
  double RattlerPercent = 0.0;
  /**
   * The bond-orientational order of all neighbours closer than 1.2 (a + b), Q_6 of Steinhardt,
   * Nelson and Ronchetti (Phys. Rev. B 28, 784, 1983): 0.57 for a face-centred cubic crystal, near
   * 0 for a random pack.
   */
  double Q6 = 0.0;
  /** The pairs of such neighbours. */
  std::int64_t Neighbours = 0;

  /** Above this Q6 a pack of many spheres is none at random. */
  static constexpr double MostQ6 = 0.1;

  /** Whether Q6 is above MostQ6, and above what so few pairs have by chance. */
  bool IsCrystalline() const;
};

/**
 * Measures the order of a pack in a box, whose faces that are not periodic are walls. Two spheres
 * touch where their distance is below (1 + `tolerance`) (a + b).
 */
PackOrder MeasureOrder(const SpherePack& pack, const Window& box, double tolerance);
}
