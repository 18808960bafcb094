// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/SpherePack.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/** A sphere that a line passes through: where it enters and leaves it, and its mode from 0. */
struct SphereHit
{
  double In, Out;
  int Mode;
};

/**
 * The spheres of a pack sorted into the cells of a grid over a box, each cell with all spheres that
 * reach into it, for tracing lines and looking points up. Along a periodic axis the images of the
 * spheres count as spheres of their own. Memory is linear in the number of spheres, about 100 bytes
 * each beyond the pack, whatever their sizes.
 *
 * What a query returns depends on the spheres and the line or point alone, bit by bit, never on the
 * grid: the queries of the shares of a pack add up to those of the whole. Queries may run
 * concurrently.
 */
class SphereGrid
{
public:
  /**
   * `pack`, with modes, may be empty. Along the periodic axes of `box` it must be wrapped
   * (WrapIntoBox), with edges longer than its diameters; elsewhere spheres may lie anywhere, and
   * what does not reach into the box is not found.
   */
  SphereGrid(const SpherePack& pack, const Window& box);

  /**
   * Appends to `hits`, in no particular order, every sphere that the part begin <= t <= end of the
   * line start + t direction (of length 1) has a common stretch with. In and Out are those of the
   * whole sphere, so they may lie before begin and beyond end. The part must lie in the box, within
   * rounding, unless all axes are periodic; it may then be of any length, begins in the box, and
   * meets every image of every sphere once.
   */
  void Trace(const Vector3& start, const Vector3& direction, double begin, double end,
    std::vector<SphereHit>& hits) const;

  /** The lowest mode, from 0, of the spheres that hold a point of the box, or `none`. */
  int LowestModeAt(const Vector3& point, int none) const;

private:
  // A sphere, or its image by so many edges, that reaches into the box
  struct Copy
  {
    double X, Y, Z, Radius;
    int Mode;
    std::array<std::int8_t, 3> Image;
  };
  Vector3 CentreOf(const Copy& copy) const;
  // Whether the sphere, enlarged by the slack, reaches into the box from lower to upper
  bool ReachesInto(const Copy& copy, const Vector3& lower, const Vector3& upper) const;
  void ChooseCells();
  // The nearest cell of the box
  int CellAlong(int axis, double position) const;
  std::size_t CellNumber(int x, int y, int z) const
  {
    return x +
      static_cast<std::size_t>(this->Count[0]) * (y + static_cast<std::size_t>(this->Count[1]) * z);
  }
  template <class Visit>
  void ForEachCellOf(const Copy& copy, Visit&& visit) const;

  Window Box;
  double Slack; // so that rounding loses no sphere
  std::array<int, 3> Count{};
  Vector3 Edge{};
  std::vector<Copy> Copies;
  std::vector<std::uint32_t> CellBegin; // first place of each cell, and the end
  std::vector<std::uint32_t> Places;    // in Copies
};
}
