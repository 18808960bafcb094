// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ruc
{
/**
 * Balls around fixed places in a box, sorted into one grid of cells for each octave of their radii,
 * so that balls of very different sizes find each other quickly. A single ball may be put elsewhere
 * at any time, which takes the same time however many balls there are.
 */
class PlaceGrid
{
public:
  /**
   * Makes room for so many balls, with radii from `least` to `greatest`, below a quarter of every
   * periodic edge. The balls are nowhere until Put is called for each of them.
   */
  PlaceGrid(const Window& box, std::size_t balls, double least, double greatest);

  /** Puts a ball at a place, which may lie outside the box along periodic axes. */
  void Put(int ball, const Vector3& place, double radius);

  /**
   * Returns all balls in an order in which, when they are put anew, ForEachNear visits them as it
   * does now.
   */
  std::vector<int> GetOrder() const;

  /**
   * Calls visit(other) once for each other ball that meets the ball, and for others nearby. The
   * order is that of cells.
   */
  template <class Visit>
  void ForEachNear(int ball, Visit&& visit) const;

private:
  struct Level
  {
    double Largest; // radius
    std::array<int, 3> Cells;
    std::vector<int> First; // the first ball of every cell, or -1
  };

  int OctaveOf(double radius) const;
  // The coordinate in the box, from 0
  double Inside(const Vector3& place, int axis) const
  {
    const double c = place[axis] - this->Box.Origin[axis], edge = this->Box.Size[axis];
    return this->Box.Periodic[axis] ? c - edge * std::floor(c / edge) : c;
  }
  int CellAlong(const Level& level, double c, int axis) const
  {
    const int cells = level.Cells[axis];
    return std::clamp(static_cast<int>(c / this->Box.Size[axis] * cells), 0, cells - 1);
  }

  Window Box;
  double Least;
  std::vector<double> Radius;
  std::vector<int> LevelOf, CellOf, Next, Previous;
  std::vector<Vector3> Place; // in the box
  std::vector<Level> Levels;
};

template <class Visit>
void PlaceGrid::ForEachNear(int ball, Visit&& visit) const
{
  for (const Level& level : this->Levels)
  {
    const double reach = this->Radius[ball] + level.Largest;
    std::array<int, 3> from{}, to{};
    for (int q = 0; q < 3; ++q)
    {
      const double cells = level.Cells[q], scale = cells / this->Box.Size[q];
      const double c = this->Place[ball][q];
      from[q] = static_cast<int>(std::floor((c - reach) * scale));
      to[q] = static_cast<int>(std::floor((c + reach) * scale));
      if (!this->Box.Periodic[q])
      {
        from[q] = std::max(from[q], 0);
        to[q] = std::min(to[q], level.Cells[q] - 1);
      }
      else if (to[q] - from[q] >= level.Cells[q])
      {
        from[q] = 0;
        to[q] = level.Cells[q] - 1;
      }
    }
    const auto wrap = [](int c, int count) {
      return c < 0 ? c + count : c >= count ? c - count : c;
    };
    for (int z = from[2]; z <= to[2]; ++z)
    {
      for (int y = from[1]; y <= to[1]; ++y)
      {
        const int row =
          (wrap(z, level.Cells[2]) * level.Cells[1] + wrap(y, level.Cells[1])) * level.Cells[0];
        for (int x = from[0]; x <= to[0]; ++x)
        {
          for (int other = level.First[row + wrap(x, level.Cells[0])]; other >= 0;
               other = this->Next[other])
          {
            if (other != ball)
            {
              visit(other);
            }
          }
        }
      }
    }
  }
}
}
