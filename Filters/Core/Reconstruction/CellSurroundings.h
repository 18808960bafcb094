// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/FixedPoint.h"
#include "ruc/Particles/CellList.h"
#include "ruc/Reconstruction/CellContents.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/**
 * Who is around whom in a cell, images included: all spheres whose centres are closer than one
 * reach. Every rank has the whole cell, so that spheres come in the same order on all of them.
 */
class CellSurroundings
{
public:
  /** `centres` holds x, y and z of each sphere, anywhere in space. */
  CellSurroundings(const CellContents& contents, const double* centres, double reach)
    : Pack(contents.MakePack(centres))
    , Cells(Pack, contents.MakeBox(), reach)
  {
  }

  std::int64_t Size() const { return static_cast<std::int64_t>(this->Cells.Size()); }
  /** The sphere whose centre is at a sorted place. */
  std::size_t SphereOf(std::size_t i) const { return this->Cells.Index[i]; }
  double RadiusOf(std::size_t sphere) const { return this->Pack.Radius[sphere]; }
  /** Its mode, from 1. */
  int ModeOf(std::size_t sphere) const { return this->Pack.Mode[sphere]; }
  /** An upper bound of how many spheres are around any. */
  std::int64_t MostNeighbours() const { return this->Cells.MostNeighbours(); }

  /**
   * Calls visit(j, dx, dy, dz, d2) for every sphere j around the centre at the sorted place i, its
   * own images included.
   */
  template <class Visit>
  void ForEachAround(std::size_t i, Visit&& visit) const
  {
    const CellList& cells = this->Cells;
    thread_local std::vector<CellList::Range> ranges;
    cells.FindRangesAround({ cells.X[i], cells.Y[i], cells.Z[i] }, 0, ranges);
    for (const CellList::Range& range : ranges)
    {
      const double reach2 = range.Reach * range.Reach;
      for (std::size_t j = range.Begin; j < range.End; ++j)
      {
        const double dx = cells.X[j] - range.X, dy = cells.Y[j] - range.Y,
                     dz = cells.Z[j] - range.Z;
        const double d2 = dx * dx + dy * dy + dz * dz;
        if (d2 < reach2 && d2 > 0.0) // not the centre itself
        {
          visit(cells.Index[j], dx, dy, dz, d2);
        }
      }
    }
  }

private:
  SpherePack Pack;
  CellList Cells;
};

/**
 * Returns the sums of what the passes over all centres of a cell add to a list of `count` integers,
 * over all threads and ranks. makePass(own) returns, for each thread, a function that is called
 * with the sorted places of this rank's centres. Collective.
 */
template <class MakePass>
std::vector<std::int64_t> SumOverCentres(
  const CellSurroundings& cell, std::size_t count, Communicator& ranks, MakePass&& makePass)
{
  std::vector<std::int64_t> total(count, 0);
#pragma omp parallel
  {
    std::vector<std::int64_t> own(count, 0);
    auto pass = makePass(own.data());
#pragma omp for schedule(dynamic, 8) nowait
    for (std::int64_t i = ranks.Rank(); i < cell.Size(); i += ranks.Size())
    {
      pass(static_cast<std::size_t>(i));
    }
#pragma omp critical
    std::transform(own.begin(), own.end(), total.begin(), total.begin(), std::plus<>());
  }
  ranks.Sum(total.data(), total.size());
  return total;
}

/**
 * Adds the forces of the centre `sphere` on the `spheres` around it, three numbers each in `pushes`
 * that are held to +-most, times `scale` to `forces`, and their opposites to its own force.
 */
inline void AddPushes(std::size_t sphere, const std::vector<std::size_t>& spheres,
  const std::vector<double>& pushes, double most, double scale, std::int64_t* forces)
{
  for (std::size_t n = 0; n < pushes.size(); ++n)
  {
    const std::int64_t push = RoundToFixedPoint(std::clamp(pushes[n], -most, most) * scale);
    forces[3 * spheres[n / 3] + n % 3] += push;
    forces[3 * sphere + n % 3] -= push;
  }
}
}
