// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

namespace ruc
{
/**
 * Returns the volume of the part x >= a, y >= b, z >= 0 of a ball of radius R around the origin,
 * where a, b >= 0. It is 0 where the edge x = a, y = b passes the ball. With z0^2 = R^2 - a^2 - b^2
 * it is, by the divergence theorem,
 *
 *     (R^3 atan2(R z0, a b) + a b z0) / 3 - a (R^2 - a^2/3) atan2(z0, b) / 2
 *       - b (R^2 - b^2/3) atan2(z0, a) / 2.
 */
double BallWedge(double a, double b, double radius);

/**
 * Returns the volume that a ball around the origin has in the box from the origin to (a, b, c),
 * with the sign of a b c. A box inside the ball has a b c; otherwise nothing of the ball is beyond
 * all three planes at once, so that the volume is, for a, b, c >= 0, that of an octant, less three
 * quarters of caps, plus three wedges in which two of these overlap:
 *
 *     4 pi R^3 / 24 - W(a, 0) - W(b, 0) - W(c, 0) + W(a, b) + W(b, c) + W(c, a), W = BallWedge.
 */
double BallInOctant(double a, double b, double c, double radius);

/**
 * Returns the volume that a ball around the origin has in a box, by the eight corners of the box.
 * Its rounding error is some 1e-15 of the volume of the part of the ball around the box's corners,
 * and so not small against a box that is far smaller than the ball.
 */
double BallInBox(const Vector3& lower, const Vector3& upper, double radius);
}
