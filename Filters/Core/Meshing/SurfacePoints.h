// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/MeshBox.h"

#include <vector>

namespace ruc
{
/** Two spheres that nearly touch: `Direction`, of length 1, leads from this to the other one. */
struct NearSphere
{
  Vector3 Direction{};
  double Gap = 0.0;
  double Radius = 0.0; // of the other one
};

/** The near spheres of each sphere, whose gaps are below `reach`. */
std::vector<std::vector<NearSphere>> FindNearSpheres(const MeshCell& cell, double reach);

/**
 * Returns points on the surfaces of all spheres, about `size` apart: where edges of the box pierce
 * a sphere, along the circles in which planes of the box cut it, at the poles of shallow caps, on
 * rings around near contacts, and evenly (by a Fibonacci lattice) elsewhere. Rings on both sides of
 * a contact are turned against each other, so that no four points of them lie in one plane.
 *
 * No point lies inside any sphere, so each ball is an empty ball of their Delaunay tessellation.
 */
std::vector<CellPoint> MakeSurfacePoints(
  const MeshCell& cell, double size, const MeshSettings& settings);
}
