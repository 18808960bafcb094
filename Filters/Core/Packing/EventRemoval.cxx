// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/EventRemoval.h"

#include "ruc/Packing/HardSpheres.h"
#include "ruc/Particles/PackOverlap.h"

#include <algorithm>

namespace ruc
{
bool RemoveOverlapByEvents(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn)
{
  constexpr double Room = 1e-9, Rate = 0.03, MostShrinking = 0.5;
  const PackOverlap overlap = MeasureOverlap(pack, box);
  if (overlap.IsNone())
  {
    return true;
  }
  const double shrinking = 1.0 - overlap.Deepest * (1.0 + 1e-6) - Room;
  if (shrinking < MostShrinking)
  {
    return false;
  }
  SpherePack shrunk = pack;
  for (double& r : shrunk.Radius)
  {
    r *= shrinking;
  }
  const double growth = (1.0 + HardSpheres::Spare) / shrinking;
  HardSpheres spheres(shrunk, box, growth, { seed, false });
  if (spheres.Grow(growth, Rate, carryOn) != HardSpheres::End::Done)
  {
    return false;
  }
  SpherePack freed = spheres.GetPack();
  freed.Radius = pack.Radius;
  freed.Mode = pack.Mode;
  freed.Id = pack.Id;
  if (!MeasureOverlap(freed, box).IsNone())
  {
    return false;
  }
  pack = std::move(freed);
  return true;
}
}
