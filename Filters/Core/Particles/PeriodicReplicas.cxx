// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PeriodicReplicas.h"

#include <algorithm>

namespace ruc
{
namespace
{
bool ReachesInto(const Replica& replica, const SpherePack& pack, const Window& box)
{
  const Vector3 centre = CentreOf(replica, pack, box);
  double distance2 = 0.0;
  for (int q = 0; q < 3; ++q)
  {
    const double out =
      std::max({ box.Origin[q] - centre[q], centre[q] - box.Origin[q] - box.Size[q], 0.0 });
    distance2 += out * out;
  }
  return distance2 < pack.Radius[replica.Original] * pack.Radius[replica.Original];
}
}

std::vector<Replica> BoundaryCopies(const SpherePack& pack, const Window& box)
{
  std::vector<Replica> replicas;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    replicas.push_back({ i, { 0, 0, 0 } });
  }
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    // An edge exceeds the diameter, so no image further away than the next can reach into the box.
    const auto last = [&](int q) { return box.Periodic[q] ? 1 : 0; };
    for (int z = -last(2); z <= last(2); ++z)
    {
      for (int y = -last(1); y <= last(1); ++y)
      {
        for (int x = -last(0); x <= last(0); ++x)
        {
          const Replica replica = { i, { x, y, z } };
          if ((x != 0 || y != 0 || z != 0) && ReachesInto(replica, pack, box))
          {
            replicas.push_back(replica);
          }
        }
      }
    }
  }
  return replicas;
}

std::vector<Replica> Tiling(const SpherePack& pack, const std::array<int, 3>& tiles)
{
  std::vector<Replica> replicas;
  for (int z = 0; z < tiles[2]; ++z)
  {
    for (int y = 0; y < tiles[1]; ++y)
    {
      for (int x = 0; x < tiles[0]; ++x)
      {
        for (std::size_t i = 0; i < pack.Size(); ++i)
        {
          replicas.push_back({ i, { x, y, z } });
        }
      }
    }
  }
  return replicas;
}

Vector3 CentreOf(const Replica& replica, const SpherePack& pack, const Window& box)
{
  Vector3 centre = pack.Centre(replica.Original);
  for (int q = 0; q < 3; ++q)
  {
    centre[q] += replica.Image[q] * box.Size[q];
  }
  return centre;
}
}
