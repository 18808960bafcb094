// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/GridPredicates.h"

#include <array>
#include <vector>

namespace ruc
{
/** The four corners of a tetrahedron, whose volume (b - a) x (c - a) . (d - a) / 6 is > 0. */
using Tetrahedron = std::array<int, 4>;

/**
 * Returns the Delaunay tessellation of points: tetrahedra that fill their convex hull, with no
 * point inside the sphere through the corners of any of them. All decisions are exact, so it holds
 * for any points of the grid, and no tetrahedron is flat on the grid. Where more than four points
 * lie on one empty sphere, the order of the points decides between the tessellations that they
 * have. Time is about 3 µs and memory 500 bytes a point.
 *
 * There are none where all points lie in one plane. Throws std::invalid_argument where two points
 * are equal.
 *
 * Source: Bowyer, The Computer Journal 24, 162; Watson, The Computer Journal 24, 167 (1981).
 */
std::vector<Tetrahedron> DelaunayTetrahedra(const std::vector<GridPoint>& points);
}
