// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SeamOverlap.h"

#include "ruc/Particles/CellList.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr double DeepOverlap = 0.2; // lesser radii
constexpr int FewestPairs = 5;

// The spheres that may reach over a periodic face, or touch one that does
SpherePack TakeSeams(const SpherePack& pack, const Window& box)
{
  const double width = 2.0 * pack.LargestRadius();
  SpherePack seams;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const Vector3 centre = pack.Centre(i);
    bool near = false;
    for (int q = 0; q < 3; ++q)
    {
      const double from = centre[q] - box.Origin[q];
      near = near || (box.Periodic[q] && (from < width || from > box.Size[q] - width));
    }
    if (near && pack.Radius[i] > 0.0)
    {
      seams.Append(pack, i);
    }
  }
  return seams;
}
}

bool OverlapsAcrossSeams(const SpherePack& pack, const Window& box)
{
  SpherePack seams = TakeSeams(pack, box);
  if (seams.Empty())
  {
    return false;
  }
  WrapIntoBox(seams, box);
  std::int64_t across = 0, within = 0;
  const CellList cells(seams, box, SizeClasses(seams.Radius, 0.0, 1.0));
  cells.ForEachPair(
    [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d2)
    {
      const double a = seams.Radius[i], b = seams.Radius[j];
      if (a + b - std::sqrt(d2) > DeepOverlap * std::min(a, b))
      {
        const Vector3 ends = { seams.X[j] - seams.X[i] - dx, seams.Y[j] - seams.Y[i] - dy,
          seams.Z[j] - seams.Z[i] - dz };
        ++(Length(ends) > a + b ? across : within);
      }
    });
  return across >= FewestPairs && across > within;
}
}
