// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <functional>

namespace ruc
{
/**
 * Takes the overlap out of a dense pack in which it is small, and moves the spheres no more than
 * that takes: radii are shrunk until nothing overlaps, and grown back by events (HardSpheres).
 * RemoveOverlap reaches less dense packs, and moves the spheres further.
 *
 * Returns whether nothing overlaps; if not, because the pack jams or `carryOn` returned false, it
 * is left as it was. The box must be long enough for HardSpheres.
 */
bool RemoveOverlapByEvents(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn);
}
