// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/Delaunay.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ruc
{
/** A periodic mesh as solvers take it: the elements lie in regions, which have materials. */
struct SolverMesh
{
  std::vector<Vector3> Points;
  /** The faces of the box that a point lies on (BoxFace), and the point that it is the copy of. */
  std::vector<std::uint8_t> Boundary;
  std::vector<std::int64_t> PeriodicOf;
  std::vector<Tetrahedron> Cells;
  /** The region of each tetrahedron, from 0, and the names of the regions. */
  std::vector<int> Region;
  std::vector<std::string> RegionNames;
  Vector3 Origin{}, Edge{}; // of the box
};

/** What the unknowns at the nodes are. */
enum class SolverPhysics
{
  Elasticity, // three displacements
  Conduction  // a temperature
};

/**
 * Throws std::invalid_argument where the mesh is no whole periodic one: a point that lies on a high
 * face is no copy of a point on low faces alone at the same place less the edges of the box, or a
 * tetrahedron has a corner or a region that there is not.
 */
void RequirePeriodic(const SolverMesh& mesh);

/**
 * Returns the name of the set of nodes with such a Boundary, all of which are disjoint: "FACE_X0",
 * "EDGE_X1Y0", "CORNER_X0Y0Z1" and so on, 0 for the low and 1 for the high face.
 */
std::string NameOfBoundary(std::uint8_t boundary);

/**
 * Returns the model data of an input deck of Abaqus or CalculiX, for a file that includes it:
 * nodes, elements C3D4, or DC3D4 for conduction, in a set for each region; the sets of nodes of
 * NameOfBoundary; and three nodes PERIOD_X, PERIOD_Y and PERIOD_Z, one set each, on which no
 * element is, whose displacement is the edge times the mean gradient along that axis. Every node on
 * a high face is tied straight to its low one, u(high) - u(low) - sum of u(PERIOD of the axes
 * crossed) = 0, with the high node first, so that no unknown is eliminated twice.
 */
std::string WriteAbaqusDeck(const SolverMesh& mesh, SolverPhysics physics);

/**
 * Returns a mesh of gmsh, format 4.1 in ASCII: the triangles of the six faces of the box as
 * physical surfaces x_min, x_max, y_min … with tags 1 to 6, the tetrahedra of each region as a
 * physical volume with a tag from 7 on, and $Periodic, which names the low node of each node on a
 * high face. Tags are unique over surfaces and volumes, and each entity has one physical tag, as
 * MOOSE wants it.
 */
std::string WriteGmshMesh(const SolverMesh& mesh);
}
