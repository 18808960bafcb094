// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/PeriodicMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ruc
{
/** How good the tetrahedra of a phase are: the angles between two faces, of which each has six. */
struct MeshQuality
{
  static constexpr int Bins = 36; // of 5 degrees

  std::int64_t Cells = 0;
  double Volume = 0.0;
  /** How many angles lie in each bin. */
  std::array<std::int64_t, Bins> Angles{};
  double LeastAngle = 180.0, LargestAngle = 0.0; // in degrees
  /** Tetrahedra with an angle below 5 degrees, above 170 and above 175 degrees. */
  std::int64_t Below5 = 0, Above170 = 0, Above175 = 0;
};

/** Returns the angles in degrees between the faces of a tetrahedron, in no particular order. */
std::array<double, 6> DihedralAngles(
  const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/** Returns the quality of the matrix and of the particles. */
std::array<MeshQuality, 2> MeasureQuality(const PeriodicMesh& mesh);

/** A triangle of the surface of a particle, whose normal leads out of it. */
struct SurfaceTriangle
{
  std::array<int, 3> Corners{};
  int Particle = -1;
};

/** Returns the triangles between particles and matrix, in the order of the particles' tetrahedra.
 */
std::vector<SurfaceTriangle> FindSurfaces(const PeriodicMesh& mesh);
}
