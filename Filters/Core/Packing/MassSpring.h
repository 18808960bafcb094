// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <functional>

namespace ruc
{
/**
 * The mass-spring dynamic mutation of the paper's reference [36]: between every two spheres that
 * overlap acts a compressed spring, and the spheres, as masses, move apart.
 *
 * All masses and stiffnesses are 1. A spring is at rest when its spheres touch, but for a gap of
 * 1e-4 of the contact, so that rest is reached with room to spare. The motion goes by semi-implicit
 * Euler steps with the damping of FIRE (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006):
 * velocities are turned towards the forces, and set to 0 when they lead uphill. It is deterministic
 * and runs on one thread. Centres end in [origin, origin + size) of the periodic box.
 *
 * Returns the number of steps taken. It is less than `maximumSteps` only when no two spheres
 * overlap any more (PackOverlap::IsNone), or when `carryOn`, which is called every few steps,
 * returned false.
 */
int MoveBySprings(
  SpherePack& pack, const Window& box, int maximumSteps,
  const std::function<bool()>& carryOn = []() { return true; });

/**
 * Takes as many steps as are enough in general (2000), and then removes what overlap is left by
 * RemoveOverlap, which shakes a pack that jams. Returns whether nothing overlaps.
 */
bool MoveBySpringsUntilFree(
  SpherePack& pack, const Window& box, std::uint32_t seed,
  const std::function<bool()>& carryOn = []() { return true; });
}
