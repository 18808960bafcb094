// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/PeriodicMesh.h"

namespace ruc
{
/**
 * Returns how far a tetrahedron is from a flat one: the least, over its six angles θ between two
 * faces, of sin θ where θ is obtuse and of 2 sin θ, up to 1, where it is acute. It is -1 for one
 * without volume. Small angles count half, since narrow gaps have them anyway.
 */
double ShapeOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/**
 * Improves the worst tetrahedra of a mesh, in rounds, as long as there are some worse than an angle
 * of 162 degrees: their corners move to where the worst tetrahedron around them gets better,
 * freely, or along the sphere, plane, circle or edge that they lie on, with their copies. What is
 * connected stays so, and every volume above 0 stays above 0. The result depends on the mesh and
 * the seed alone.
 *
 * Source: Freitag and Ollivier-Gooch, Int. J. Numer. Meth. Engng. 40, 3979 (1997).
 */
void ImproveMesh(PeriodicMesh& mesh, int rounds, std::uint32_t seed);
}
