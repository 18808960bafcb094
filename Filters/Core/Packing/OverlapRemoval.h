// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackOverlap.h"

#include <cstdint>
#include <functional>

namespace ruc
{
/**
 * Moves the centres of a pack in a box apart until no two spheres overlap. Faces of the box that
 * are not periodic are walls, which spheres do not overlap either. It minimises the sum of the
 * squares of a + b - d over the pairs that overlap, with L-BFGS; radii are enlarged a little, so
 * that the minimum is reached with room to spare. A pack that jams is shaken, by random numbers of
 * the seed, and tried again.
 *
 * Returns whether nothing overlaps. `carryOn` is called every few steps and
 * stops the work when it returns false; `pack` then holds what was reached.
 */
bool RemoveOverlap(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn);
}
