// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/VoxelMask.h"
#include "ruc/Particles/SpherePack.h"

#include <array>
#include <vector>

namespace ruc
{
/** A sphere that a line passes through: where it enters and leaves it, and its mode from 0. */
struct SphereHit
{
  double In, Out;
  int Mode;
};

/** The points Start + t Direction of a bundle with t in one of the ascending intervals. */
struct SampleLine
{
  Vector3 Start;
  std::vector<LineInterval> Inside;
};

/**
 * Parallel lines whose starts lie on a plane lattice, Origin + i AxisI + j AxisJ; places of the
 * lattice may be without a line. Along the lines every sphere is projected onto the lattice, which
 * tells the lines it meets without a search.
 */
class LineBundle
{
public:
  Vector3 Direction; // of length 1
  std::vector<SampleLine> Lines;

  /**
   * An empty bundle for places first <= (i, j) < first + count. `box` holds the spheres; in a fully
   * periodic one lines may be of any length and the lattice closes over the edges: AxisI and AxisJ
   * are whole parts, by the counts, of two edges, first is 0.
   */
  LineBundle(const Window& box, const Vector3& direction, const Vector3& origin,
    const Vector3& axisI, const Vector3& axisJ, const std::array<int, 2>& first,
    const std::array<int, 2>& count);

  Vector3 StartOf(int i, int j) const;
  void AddLine(int i, int j, std::vector<LineInterval> inside);

  /**
   * Appends to hits[n], in no particular order, every sphere of the pack that has a common stretch
   * with line n between the begin of its first interval and the end of its last; images along
   * periodic axes are spheres of their own. The pack, with modes, is wrapped into the box
   * (WrapIntoBox), whose periodic edges are longer than its diameters. In and Out are those of the
   * whole sphere and depend on sphere and line alone, bit by bit.
   */
  void FindHits(const SpherePack& pack, std::vector<std::vector<SphereHit>>& hits) const;

private:
  void FindHitsOf(const SpherePack& pack, std::size_t sphere, const std::array<int, 3>& image,
    std::vector<std::vector<SphereHit>>& hits) const;

  Window Box;
  bool Closed; // the lattice over the edges of the box
  Vector3 Origin, AxisI, AxisJ;
  std::array<int, 2> First, Count;
  std::vector<int> LineAt; // by place; -1 for none
  // Of a closed lattice the axis along which each of its own axes lies: 1 there, else 0
  std::array<int, 3> SpannedByI, SpannedByJ;
  // Position = Origin + (DualI . p) AxisI + (DualJ . p) AxisJ + (DualT . p) Direction
  Vector3 DualI, DualJ, DualT;
  double WidthI, WidthJ, WidthT; // lengths of the duals
  double Longest = 0.0;          // end of the longest line
};
}
