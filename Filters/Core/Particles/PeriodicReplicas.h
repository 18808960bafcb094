// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <array>
#include <vector>

namespace ruc
{
/** A copy of sphere `Original` of a pack, moved by `Image` whole edges along each axis. */
struct Replica
{
  std::size_t Original;
  std::array<int, 3> Image;
};

/**
 * Returns the spheres of a periodic pack and those of their images that reach into the box. Each
 * face of the box that a sphere crosses, each edge that passes through it and each corner inside it
 * gives one copy: a sphere on a face appears twice in all, one on an edge four times, one in a
 * corner eight times. A sphere that only touches a face has no copy. `pack` must be wrapped into
 * the box. Originals come first, with Image 0.
 */
std::vector<Replica> BoundaryCopies(const SpherePack& pack, const Window& box);

/**
 * Returns the pack repeated tiles[0] x tiles[1] x tiles[2] times. Tile (0, 0, 0), the original,
 * comes first.
 */
std::vector<Replica> Tiling(const SpherePack& pack, const std::array<int, 3>& tiles);

/** Returns the centre of a replica. */
Vector3 CentreOf(const Replica& replica, const SpherePack& pack, const Window& box);

/**
 * Returns which spheres are mere periodic copies of another. Such a sphere lies outside the
 * half-open box along a periodic axis, and there is a sphere of the same radius inside at the same
 * place but for whole edges. As text has few digits, places may differ by 1e-5 of the longest edge,
 * but by no more than the largest radius, and radii by 1e-5.
 */
std::vector<bool> FindPeriodicCopies(const SpherePack& pack, const Window& box);
}
