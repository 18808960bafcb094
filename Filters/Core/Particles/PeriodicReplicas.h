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
 * The spheres of a periodic pack and those of their images that reach into the box: two spheres in
 * all of one that crosses a face, four of one that an edge of the box passes through, eight of one
 * with a corner of the box inside (three or seven where it crosses the faces beside an edge or
 * corner but does not hold that). A sphere that only touches a face has no copy. `pack` wrapped
 * into the box; originals come first, with Image 0.
 */
std::vector<Replica> BoundaryCopies(const SpherePack& pack, const Window& box);

/** The whole pack repeated tiles[0] x tiles[1] x tiles[2] times; tile (0, 0, 0), the original,
 * comes first. */
std::vector<Replica> Tiling(const SpherePack& pack, const std::array<int, 3>& tiles);

/** The centre of a replica. */
Vector3 CentreOf(const Replica& replica, const SpherePack& pack, const Window& box);

/**
 * Which spheres are mere periodic copies of another: outside the half-open box along a periodic
 * axis, with a sphere of the same radius inside at the same place, one or more edges away (to 1e-5
 * of an edge, as text has few digits).
 */
std::vector<bool> FindPeriodicCopies(const SpherePack& pack, const Window& box);
}
