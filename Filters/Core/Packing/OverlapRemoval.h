// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackOverlap.h"

#include <cstdint>
#include <functional>

namespace ruc
{
/**
 * Moves the centres of a pack in a periodic box apart until no two spheres overlap, by minimising
 * the sum of (a + b - d)+^2 with L-BFGS, the radii a little enlarged so that the minimum is reached
 * with room to spare. A pack that jams is shaken (seeded, reproducible) and tried again.
 *
 * Returns whether nothing overlaps (PackOverlap::IsNone). `carryOn` is called every few steps and
 * stops the work when it returns false; what is reached by then stays in `pack`.
 */
bool RemoveOverlap(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn);
}
