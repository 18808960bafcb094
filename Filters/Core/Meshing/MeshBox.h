// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"
#include "ruc/Particles/SpherePack.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ruc
{
/** How a periodic cell of spheres is meshed. Lengths are in the pack's unit. */
struct MeshSettings
{
  /** The length of an edge of a tetrahedron; 0 stands for half the mean radius. */
  double ElementSize = 0.0;
  /** Whether points lie on rings around the places where spheres nearly touch. */
  bool ContactRings = true;
  /** Whether the corner of the box is moved to where no plane nearly touches a sphere. */
  bool ShiftOrigin = true;
  /** The least gap between surfaces that is taken, >= 0. */
  double LeastGap = 0.0;
  /** Rounds of moving points and turning edges against flat tetrahedra, 0 to 1000. */
  int ImprovementRounds = 10;
  /** The seed of the shifts, of turns and of small displacements of points. */
  std::uint32_t Seed = 0;
};

/**
 * The spheres of a periodic cell in a box with one corner at 0: centres from 0 to less than the
 * edges.
 */
struct MeshCell
{
  Vector3 Edge{};
  std::vector<Vector3> Centre;
  std::vector<double> Radius;

  std::size_t Size() const { return this->Radius.size(); }
};

/**
 * A point of the cell before its periodic copies are made. A coordinate on a face of the box is
 * exactly 0, any other lies between 0 and the edge.
 */
struct CellPoint
{
  Vector3 Place{};
  /** Whether the point lies on the planes across x, y and z. */
  std::array<bool, 3> OnPlane{};
  /** The sphere on whose surface it lies, or in which it lies; -1 in the matrix. */
  int Sphere = -1;
  bool IsInside = false;
  /** By how many edges the copy of the sphere that it belongs to is displaced. */
  std::array<int, 3> Image{};
};

/** The cell after a shift, and how far from tangency its planes and edges are. */
struct ShiftedCell
{
  MeshCell Cell;
  /** The displacement of the box against the window's, >= 0 and below the edges. */
  Vector3 Shift{};
  /**
   * The least distance, in radii, of the planes from touching a sphere, of the edges (times 0.7)
   * and of the corner from a surface. The corner lies in a sphere where it is < 0.
   */
  double Margin = 0.0;
};

/**
 * Returns the cell in the box, displaced to the best of many random shifts where wanted. Throws
 * std::invalid_argument "No origin keeps the corner in the matrix…" where none does.
 */
ShiftedCell ShiftCell(const SpherePack& pack, const Window& window, const MeshSettings& settings);

/** The gaps between the surfaces of spheres, of which a sphere and its own image may be two. */
struct CellGaps
{
  double Least = 0.0;
  /** How many are below a fiftieth of the mean radius, where angles of tetrahedra get worse. */
  std::int64_t Narrow = 0;
};

/**
 * Returns the gaps of a pack; the least one is at most a mean radius. Throws std::invalid_argument
 * that names the spheres where two overlap or touch, or where the least gap is below LeastGap.
 */
CellGaps CheckGaps(const SpherePack& pack, const Window& window, const MeshSettings& settings);

/**
 * Returns the element size of the settings, or that for which 0 stands. Throws
 * std::invalid_argument unless it is at least a thousandth and at most half of the shortest edge.
 */
double FindElementSize(const SpherePack& pack, const Window& window, const MeshSettings& settings);
}
