// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/PlaceGrid.h"

namespace ruc
{
PlaceGrid::PlaceGrid(const Window& box, std::size_t balls, double least, double greatest)
  : Box(box)
  , Least(least)
  , Radius(balls, 0.0)
  , LevelOf(balls, -1)
  , CellOf(balls, -1)
  , Next(balls, -1)
  , Previous(balls, -1)
  , Place(balls)
{
  // No more cells than some four for each ball
  const double finest = std::cbrt(box.Volume() / (4.0 * balls));
  for (int octave = this->OctaveOf(greatest); octave >= 0; --octave)
  {
    Level level;
    level.Largest = std::min(std::ldexp(least, octave + 1), greatest);
    const double width = std::max(2.0 * level.Largest, finest);
    std::size_t cells = 1;
    for (int q = 0; q < 3; ++q)
    {
      level.Cells[q] = std::max(1, static_cast<int>(std::floor(box.Size[q] / width)));
      cells *= level.Cells[q];
    }
    level.First.assign(cells, -1);
    this->Levels.insert(this->Levels.begin(), std::move(level));
  }
}

std::vector<int> PlaceGrid::GetOrder() const
{
  std::vector<int> order;
  for (const Level& level : this->Levels)
  {
    for (int first : level.First)
    {
      for (int ball = first; ball >= 0; ball = this->Next[ball])
      {
        order.push_back(ball);
      }
    }
  }
  std::reverse(order.begin(), order.end()); // the last one that was put is visited first
  return order;
}

int PlaceGrid::OctaveOf(double radius) const
{
  return std::max(0, std::ilogb(radius / this->Least));
}

void PlaceGrid::Put(int ball, const Vector3& place, double radius)
{
  const int from = this->CellOf[ball];
  if (from >= 0)
  {
    const int before = this->Previous[ball], after = this->Next[ball];
    (before >= 0 ? this->Next[before] : this->Levels[this->LevelOf[ball]].First[from]) = after;
    if (after >= 0)
    {
      this->Previous[after] = before;
    }
  }
  this->Radius[ball] = radius;
  this->LevelOf[ball] = this->OctaveOf(radius);
  Level& level = this->Levels[this->LevelOf[ball]];
  for (int q = 0; q < 3; ++q)
  {
    this->Place[ball][q] = this->Inside(place, q);
  }
  const Vector3& inside = this->Place[ball];
  const int to =
    (this->CellAlong(level, inside[2], 2) * level.Cells[1] + this->CellAlong(level, inside[1], 1)) *
      level.Cells[0] +
    this->CellAlong(level, inside[0], 0);
  const int after = level.First[to];
  this->CellOf[ball] = to;
  this->Previous[ball] = -1;
  this->Next[ball] = after;
  level.First[to] = ball;
  if (after >= 0)
  {
    this->Previous[after] = ball;
  }
}
}
