// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

#include <array>
#include <vector>

namespace ruc
{
/**
 * A point on a grid. Its coordinates are whole numbers from 0 to 2^41, so that the difference of
 * two of them is exact.
 */
using GridPoint = Vector3;

/**
 * Rounds points to a grid with 2^41 cells along the longest edge of the box from `low` to `high`,
 * which must hold all of them. Points with one coordinate in common keep it in common.
 */
std::vector<GridPoint> RoundToGrid(
  const std::vector<Vector3>& points, const Vector3& low, const Vector3& high);

/**
 * Returns the sign, 1, 0 or -1, of the volume of the tetrahedron a b c d: of (b - a) x (c - a) .
 * (d - a). It is exact: numbers of 128 bits decide where doubles cannot.
 */
int Orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/**
 * Returns 1, 0 or -1 where e lies inside, on or outside the sphere through a, b, c and d, whose
 * Orientation must be 1. It is exact: sums of 256 bits decide where doubles cannot. The bound of
 * the rounding error is that of Shewchuk, Discrete & Computational Geometry 18, 305 (1997).
 */
int InSphere(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d,
  const GridPoint& e);
}
