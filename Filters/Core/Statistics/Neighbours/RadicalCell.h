// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

#include <memory>
#include <vector>

namespace ruc
{
/** A sphere as seen from another one. */
struct SphereAround
{
  Vector3 Offset; // from centre to centre
  double SquaredDistance;
  double Radius;
};

/**
 * The cell of a sphere in the radical (power, Laguerre) Voronoi tessellation: the points x with a
 * lesser |x - c|^2 - r^2 for this sphere than for any other. A sphere that no other overlaps lies
 * in its cell.
 */
struct RadicalCell
{
  /**
   * No sphere at this distance from the centre or farther can have a part in the cell, whatever its
   * radius up to the largest.
   */
  double NeededReach = 0.0;
  double Volume = 0.0; // 0 where nothing is left of the cell, as in a sphere within another one
  int Faces = 0;
  /**
   * The bond-orientational order, each face weighted by its area A (Mickel et al., J. Chem. Phys.
   * 138, 044501, 2013): q_l^2 = sum over faces f, g of A_f A_g P_l(cos(n_f, n_g)) / (sum of A)^2,
   * where n leads to the neighbour. 0 for a cell without volume.
   */
  double Q4 = 0.0, Q6 = 0.0;
};

/** Finds cells by Voro++. It is room to work in, and so of one thread. */
class RadicalCellFinder
{
public:
  /**
   * `scale` is about the distance of neighbours, which any unit of length may make very large or
   * small; `largestRadius` that of all spheres.
   */
  RadicalCellFinder(double scale, double largestRadius);
  ~RadicalCellFinder();

  /**
   * Finds the cell of a sphere among those around it, which come in the order of SquaredDistance,
   * and are all that are closer than `reach`. The cell is right where its NeededReach is at most
   * the reach; else its other numbers are 0.
   */
  RadicalCell Find(double radius, double reach, const std::vector<SphereAround>& around);

private:
  struct Workspace;
  std::unique_ptr<Workspace> Space;
  double Scale, LargestRadius;
};
}
