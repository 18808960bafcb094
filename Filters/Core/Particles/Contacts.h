// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/CellList.h"
#include "ruc/Particles/SpherePack.h"

#include <cmath>
#include <cstddef>

namespace ruc
{
/**
 * Calls visit(i, j, dx, dy, dz, d) for every pair of spheres whose centres are closer than `reach`
 * times the sum of their radii. i and j are their places in the pack, which must be wrapped into
 * the window; (dx, dy, dz), of length d, leads from i to the image of j.
 */
template <class Visit>
void ForEachContact(const SpherePack& pack, const Window& window, double reach, Visit&& visit)
{
  const CellList cells(pack, window, SizeClasses(pack.Radius, 0.0, reach));
  cells.ForEachPair(
    [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d2)
    {
      const double contact = reach * (pack.Radius[i] + pack.Radius[j]);
      if (d2 < contact * contact)
      {
        visit(i, j, dx, dy, dz, std::sqrt(d2));
      }
    });
}
}
