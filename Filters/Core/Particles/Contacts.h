// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/CellList.h"
#include "ruc/Particles/SpherePack.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * Calls visit(i, j, dx, dy, dz, d) for every pair of spheres of a wrapped pack, i and j their
 * places in it, whose centres are closer than `reach` times the sum of their radii. (dx, dy, dz) of
 * length d leads from i to the image of j.
 */
template <class Visit>
void ForEachContact(const SpherePack& pack, const Window& window, double reach, Visit&& visit)
{
  const CellList cells(pack, window, 2.0 * reach * pack.LargestRadius());
  std::vector<CellList::Range> ranges;
  for (std::size_t i = 0; i < cells.Size(); ++i)
  {
    cells.FindRanges(i, ranges);
    for (const CellList::Range& range : ranges)
    {
      for (std::size_t j = range.Begin; j < range.End; ++j)
      {
        const double dx = cells.X[j] - range.X, dy = cells.Y[j] - range.Y,
                     dz = cells.Z[j] - range.Z;
        const double d2 = dx * dx + dy * dy + dz * dz;
        const std::size_t p = cells.Index[i], q = cells.Index[j];
        const double contact = reach * (pack.Radius[p] + pack.Radius[q]);
        if (d2 < contact * contact)
        {
          visit(p, q, dx, dy, dz, std::sqrt(d2));
        }
      }
    }
  }
}
}
