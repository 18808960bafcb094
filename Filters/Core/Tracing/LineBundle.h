// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/VoxelMask.h"
#include "ruc/Particles/SpherePack.h"

#include <array>
#include <vector>

namespace ruc
{
/**
 * A sphere that a line passes through: the positions at which the line enters and leaves it, and
 * its mode, counted from 0.
 */
struct SphereHit
{
  double In, Out;
  int Mode;
};

/** A line of a bundle: the points Start + t Direction with t in one of the ascending intervals. */
struct SampleLine
{
  Vector3 Start;
  std::vector<LineInterval> Inside;
};

/**
 * Parallel lines whose starts lie on a plane lattice, Origin + i AxisI + j AxisJ. Places of the
 * lattice may be without a line. Every sphere is projected along the lines onto the lattice, which
 * tells without a search which lines it meets.
 */
class LineBundle
{
public:
  Vector3 Direction; // of length 1
  std::vector<SampleLine> Lines;

  /**
   * Makes an empty bundle for the places first <= (i, j) < first + count.
   *
   * `box` holds the spheres. In a fully periodic box lines may be of any length, and the lattice
   * closes over the edges: AxisI and AxisJ must be two edges of the box divided by count[0] and
   * count[1], and `first` must be 0.
   */
  LineBundle(const Window& box, const Vector3& direction, const Vector3& origin,
    const Vector3& axisI, const Vector3& axisJ, const std::array<int, 2>& first,
    const std::array<int, 2>& count);

  Vector3 StartOf(int i, int j) const;
  /** Adds the line at a place of the lattice, with at least one interval. */
  void AddLine(int i, int j, std::vector<LineInterval> inside);

  /**
   * Appends to hits[n], in no particular order, every sphere of the pack that shares a stretch with
   * line n between the begin of its first interval and the end of its last. Images along periodic
   * axes are spheres of their own. The pack, with modes, must be wrapped into the box
   * (WrapIntoBox), whose periodic edges must be longer than its diameters. In and Out are those of
   * the whole sphere, and depend on sphere and line alone, bit by bit.
   */
  void FindHits(const SpherePack& pack, std::vector<std::vector<SphereHit>>& hits) const;

private:
  void FindHitsOf(const SpherePack& pack, std::size_t sphere, const std::array<int, 3>& image,
    std::vector<std::vector<SphereHit>>& hits) const;

  Window Box;
  bool Closed; // whether the lattice closes over the edges of the box
  Vector3 Origin, AxisI, AxisJ;
  std::array<int, 2> First, Count;
  std::vector<int> LineAt; // the line at each place, or -1
  // 1 for the axis of the box along which AxisI, or AxisJ, of a closed lattice lies, else 0
  std::array<int, 3> SpannedByI, SpannedByJ;
  // Position = Origin + (DualI . p) AxisI + (DualJ . p) AxisJ + (DualT . p) Direction
  Vector3 DualI, DualJ, DualT;
  double WidthI, WidthJ, WidthT; // the lengths of the duals
  double Longest = 0.0;          // where the longest line ends
};
}
