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
 * Unit masses, springs of unit stiffness at rest when the spheres touch (with a gap of 1e-4 of the
 * contact, so that rest is reached with room to spare). Motion by semi-implicit Euler steps with
 * the damping of FIRE (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006): velocities are turned
 * towards the forces, and set to 0 when they climb. Deterministic, on one thread. Centres end in
 * [origin, origin + size) of the periodic box.
 *
 * Returns the steps taken: fewer than `maximumSteps` only when no two spheres overlap any more
 * (PackOverlap::IsNone), or when `carryOn`, which is called every few steps, returned false.
 */
int MoveBySprings(
  SpherePack& pack, const Window& box, int maximumSteps,
  const std::function<bool()>& carryOn = []() { return true; });

/**
 * The same for as many steps as serve in general (2000), and what overlap is left then removed by
 * RemoveOverlap, which shakes a pack that jams. Returns whether nothing overlaps.
 */
bool MoveBySpringsUntilFree(
  SpherePack& pack, const Window& box, std::uint32_t seed,
  const std::function<bool()>& carryOn = []() { return true; });
}
