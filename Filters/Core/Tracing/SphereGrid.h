// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * The spheres of a pack sorted into the cells of a grid over a box, for looking up points. Each
 * cell lists all spheres that reach into it. Along a periodic axis the images of the spheres count
 * as spheres of their own. Memory is linear in the number of spheres, about 100 bytes for each
 * beyond the pack, whatever their sizes.
 *
 * What a query returns depends on the spheres and the point alone, never on the grid. Queries may
 * run concurrently.
 */
class SphereGrid
{
public:
  /**
   * `pack`, with modes, may be empty. Along the periodic axes of `box` it must be wrapped
   * (WrapIntoBox), and the edges must be longer than its diameters. Along other axes spheres may
   * lie anywhere, and those that do not reach into the box are not found.
   */
  SphereGrid(const SpherePack& pack, const Window& box);

  /**
   * Returns the lowest mode, counted from 0, of the spheres that hold a point of the box, or `none`
   * where there is no such sphere.
   */
  int LowestModeAt(const Vector3& point, int none) const;

private:
  // A sphere, or its image by `Image` whole edges, that reaches into the box
  struct Copy
  {
    double X, Y, Z, Radius;
    int Mode;
    std::array<std::int8_t, 3> Image;
  };
  Vector3 CentreOf(const Copy& copy) const;
  // Whether the sphere, enlarged by the slack, reaches into the box between the corners lower and
  // upper
  bool ReachesInto(const Copy& copy, const Vector3& lower, const Vector3& upper) const;
  void ChooseCells();
  // The cell at a position along an axis, or the nearest one for positions outside the box
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
  std::vector<std::uint32_t> CellBegin; // where each cell begins in Places, and the end
  std::vector<std::uint32_t> Places;    // places in Copies, cell by cell
};
}
