// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Meshing/Delaunay.h"
#include "ruc/Meshing/MeshBox.h"
#include "ruc/Particles/PackFigures.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ruc
{
/** The faces of the box, as bits of PeriodicMesh::Boundary. */
enum BoxFace : std::uint8_t
{
  LowX = 1,
  HighX = 2,
  LowY = 4,
  HighY = 8,
  LowZ = 16,
  HighZ = 32
};

/**
 * Tetrahedra that fill a box and whose faces are equal on opposite faces of it. Each tetrahedron
 * lies in one sphere, whose surface is a polyhedron with its corners on the sphere, or in the
 * matrix between them. The box has one corner at 0.
 */
struct PeriodicMesh
{
  Vector3 Edge{};
  std::vector<Vector3> Points;
  /** The faces of the box that a point lies on, from BoxFace. */
  std::vector<std::uint8_t> Boundary;
  /** The point of which this is the periodic copy: on no high face; itself where it is on none. */
  std::vector<int> PeriodicOf;
  /** The part on whose surface the point lies, -1 elsewhere. */
  std::vector<int> Surface;
  /** The sphere's centre of each part of a sphere that the box cuts out of it, and its radius. */
  std::vector<Vector3> PartCentre;
  std::vector<double> PartRadius;

  std::vector<Tetrahedron> Cells;
  /** The sphere that each tetrahedron lies in, -1 in the matrix. */
  std::vector<int> Particle;

  /** The displacement of the box, its margin (ShiftedCell), and what was taken. */
  Vector3 Shift{};
  double Margin = 0.0;
  double ElementSize = 0.0;
  CellGaps Gaps;

  double VolumeOf(std::size_t cell) const;
};

/**
 * Meshes a periodic cell of spheres that do not touch. Points lie on the spheres and none inside,
 * so each ball is an empty ball of their Delaunay tessellation, and the polyhedron of its points is
 * made of cells of that tessellation: it needs no recovery of surfaces, however narrow the gaps.
 * The part of a sphere in the box is convex and is tessellated with points of its own inside. The
 * faces of the box carry the plane Delaunay tessellation of their points, which is the same on
 * opposite faces because the points are.
 *
 * Throws std::invalid_argument as ShiftCell, CheckGaps and FindElementSize do, and unless the box
 * is periodic along its three axes; also where several attempts with different random numbers
 * all have a fault (FindFault).
 */
PeriodicMesh MakePeriodicMesh(
  const SpherePack& pack, const Window& window, const MeshSettings& settings);

/** Tells the time of one core and the memory that MakePeriodicMesh takes. */
Estimate EstimatePeriodicMesh(const PackFigures& pack, const MeshSettings& settings);

/**
 * Returns what is wrong with a mesh, or an empty text: a tetrahedron without volume, a face that is
 * neither shared by two tetrahedra nor on the box, faces on opposite sides that differ, copies of
 * points at other places, or volumes that do not add up to the box to 1e-12.
 */
std::string FindFault(const PeriodicMesh& mesh);
}
