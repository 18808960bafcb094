// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SizeClasses.h"
#include "ruc/Particles/SpherePack.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * The centres of a pack sorted into grids of cells, one grid for each class of size. It finds every
 * pair of centres that are close enough to matter: closer than the reach of their classes
 * (SizeClasses).
 *
 * Along a periodic axis the images of a centre count as centres of their own. The reach may exceed
 * the box, in which case a sphere meets several images of another one, and of itself. Memory is
 * linear in the number of spheres; images are not stored.
 */
class CellList
{
public:
  /** The periodic axes of `pack` must be wrapped into `window` (WrapIntoBox). */
  CellList(const SpherePack& pack, const Window& window, const SizeClasses& classes);

  /** The same with one reach `cutoff` > 0 for all pairs, whatever the radii. */
  CellList(const SpherePack& pack, const Window& window, double cutoff);

  /**
   * The centres in sorted order: by class, the largest spheres first, and within a class by cell. A
   * place in these arrays is called a sorted place.
   */
  std::vector<double> X, Y, Z;
  /** The place in the pack of each of these centres. */
  std::vector<std::uint32_t> Index;

  std::size_t Size() const { return this->X.size(); }

  /**
   * The sorted places [Begin, End), which a centre at (X, Y, Z) has to be paired with. This is the
   * centre's own position less the periodic shift of the range. A pair matters if it is closer than
   * Reach.
   */
  struct Range
  {
    std::size_t Begin, End;
    double X, Y, Z;
    double Reach;
  };

  /**
   * Replaces `ranges` by the places that the i-th sorted centre has to be paired with. Over all i,
   * every unordered pair of a centre and an image of a centre closer than the reach appears in
   * exactly one range. A range also holds centres beyond the reach.
   */
  void FindRanges(std::size_t i, std::vector<Range>& ranges) const;

  /**
   * Calls visit(i, j, dx, dy, dz, d2) once for every pair of a centre and an image of a centre
   * closer than the reach. i and j are their places in the pack, (dx, dy, dz) leads from i to the
   * image of j, and d2 is its squared length. Loops that take whole ranges at a time use
   * FindRanges.
   */
  template <class Visit>
  void ForEachPair(Visit&& visit) const;

  /**
   * Does what FindRanges does for a point that is not in the list, as a centre of class
   * `sizeClass`: the ranges hold all centres closer to it than the reach, and others.
   */
  void FindRangesAround(const Vector3& point, int sizeClass, std::vector<Range>& ranges) const;

  /** The class of the i-th sorted centre. */
  int ClassOf(std::size_t i) const;

  /**
   * Calls visit(begin, end) for stretches of sorted places that hold all centres closer than
   * `reach` to a disc, and others. The disc has the given middle, normal (of length 1) and radius.
   * The list must have one class and no periodic axis.
   */
  template <class Visit>
  void ForEachNearDisc(
    const Vector3& middle, const Vector3& normal, double radius, double reach, Visit&& visit) const;

  /** An upper bound of how many others, images included, any centre has within the reach. */
  std::int64_t MostNeighbours() const;

private:
  struct Axis
  {
    double Origin, Edge, Width;
    int Count;
    bool Periodic;

    int CellOf(double c) const;
    // The first and last cell, images included, that the interval from c - reach to c + reach meets
    int FirstCell(double c, double reach) const;
    int LastCell(double c, double reach) const;
    // The distance from c to the slab of cell k
    double DistanceTo(double c, int k) const;
    // By how many edges the cell k lies outside the box
    int ImageOf(int k) const;
  };

  // The cells of a class, whose centres are at the sorted places from First on
  struct Grid
  {
    Axis Axes[3];
    std::size_t First = 0;
    std::vector<std::size_t> CellBegin; // the first sorted place of each cell, and the end

    std::size_t CellNumber(int cx, int cy, int cz) const;
    // An upper bound of the number of cells that a ball of radius `reach` meets
    double MostCells(double reach) const;
    std::size_t FullestCell() const;
  };

  // Sets up a grid whose cells suit the reach
  Grid MakeGrid(const SpherePack& pack, const std::vector<std::uint32_t>& members,
    const Window& window, double reach) const;
  // Appends the members to the sorted places
  void Sort(const SpherePack& pack, const std::vector<std::uint32_t>& members, Grid& grid);
  // Appends the ranges of a grid that a ball around the point meets. With `half` the point is the
  // centre at the place `after`, and of its own class only the centres that come after it count.
  static void AppendRanges(const Grid& grid, const Vector3& point, double reach, bool half,
    std::size_t after, std::vector<Range>& ranges);

  SizeClasses Classes;
  std::vector<Grid> Grids; // one for every class
};

template <class Visit>
void CellList::ForEachPair(Visit&& visit) const
{
  std::vector<Range> ranges;
  for (std::size_t i = 0; i < this->Size(); ++i)
  {
    this->FindRanges(i, ranges);
    for (const Range& range : ranges)
    {
      const double reach2 = range.Reach * range.Reach;
      for (std::size_t j = range.Begin; j < range.End; ++j)
      {
        const double dx = this->X[j] - range.X, dy = this->Y[j] - range.Y,
                     dz = this->Z[j] - range.Z;
        const double d2 = dx * dx + dy * dy + dz * dz;
        if (d2 < reach2)
        {
          visit(this->Index[i], this->Index[j], dx, dy, dz, d2);
        }
      }
    }
  }
}

template <class Visit>
void CellList::ForEachNearDisc(
  const Vector3& middle, const Vector3& normal, double radius, double reach, Visit&& visit) const
{
  const Grid& grid = this->Grids.front();
  const Axis &ax = grid.Axes[0], &ay = grid.Axes[1], &az = grid.Axes[2];
  // Centres were put into cells with rounding
  const double slack = 1e-12 * (radius + reach + ax.Edge + ay.Edge + az.Edge);
  const double thick = reach + slack, ball = radius + thick;
  const auto outside = [&](const Axis& axis, double c)
  { return c < axis.Origin - ball || c > axis.Origin + axis.Edge + ball; };
  if (outside(ax, middle[0]) || outside(ay, middle[1]) || outside(az, middle[2]))
  {
    return;
  }
  // Rows of cells along x, cut by the ball around the disc and by the slab around its plane
  const double halfRow = 0.5 * (std::abs(normal[1]) * ay.Width + std::abs(normal[2]) * az.Width);
  const int lastZ = az.LastCell(middle[2], ball);
  for (int kz = az.FirstCell(middle[2], ball); kz <= lastZ; ++kz)
  {
    const double dz = az.DistanceTo(middle[2], kz);
    const double ballY = std::sqrt(std::max(ball * ball - dz * dz, 0.0));
    const double heightZ = normal[2] * (az.Origin + (kz + 0.5) * az.Width - middle[2]);
    const int lastY = ay.LastCell(middle[1], ballY);
    for (int ky = ay.FirstCell(middle[1], ballY); ky <= lastY; ++ky)
    {
      const double dy = ay.DistanceTo(middle[1], ky);
      const double ballX = std::sqrt(std::max(ball * ball - dz * dz - dy * dy, 0.0));
      const double height = heightZ + normal[1] * (ay.Origin + (ky + 0.5) * ay.Width - middle[1]);
      double low = -ballX, high = ballX; // of x - middle
      const double room = thick + halfRow;
      if (std::abs(normal[0]) * ball > 1e-9 * room)
      {
        const double a = (-room - height) / normal[0], b = (room - height) / normal[0];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
      }
      else if (std::abs(height) > room * (1.0 + 1e-9))
      {
        continue;
      }
      const int firstX = ax.FirstCell(middle[0] + low - slack, 0.0);
      const int lastX = ax.LastCell(middle[0] + high + slack, 0.0);
      if (low <= high && firstX <= lastX)
      {
        const std::size_t begin = grid.CellBegin[grid.CellNumber(firstX, ky, kz)];
        const std::size_t end = grid.CellBegin[grid.CellNumber(lastX, ky, kz) + 1];
        if (begin < end)
        {
          visit(begin, end);
        }
      }
    }
  }
}
}
