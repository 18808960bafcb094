// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PeriodicReplicas.h"

#include "ruc/Particles/CellList.h"

#include <algorithm>
#include <cmath>

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
    // An edge exceeds the diameter, so only the nearest images can reach into the box
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

namespace
{
// Whether each sphere lies outside the half-open box along a periodic axis
std::vector<bool> FindBeyond(const SpherePack& pack, const Window& box)
{
  std::vector<bool> beyond(pack.Size(), false);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int q = 0; q < 3; ++q)
    {
      const double c = pack.Centre(i)[q];
      beyond[i] =
        beyond[i] || (box.Periodic[q] && !(c >= box.Origin[q] && c < box.Origin[q] + box.Size[q]));
    }
  }
  return beyond;
}
}

std::vector<bool> FindPeriodicCopies(const SpherePack& pack, const Window& box)
{
  constexpr double tolerance = 1e-5;
  const std::vector<bool> outside = FindBeyond(pack, box);
  std::vector<bool> copy(pack.Size(), false);
  if (std::find(outside.begin(), outside.end(), true) == outside.end())
  {
    return copy;
  }
  SpherePack wrapped = pack;
  WrapIntoBox(wrapped, box);
  // In a box that is far longer than wide, the tolerance along would hold all spheres
  const auto [shortest, longest] = std::minmax_element(box.Size.begin(), box.Size.end());
  const double reach =
    std::min(tolerance * *longest, std::max(pack.LargestRadius(), tolerance * *shortest));
  const CellList cells(wrapped, box, reach);
  cells.ForEachPair(
    [&](std::size_t p, std::size_t q, double, double, double, double)
    {
      if (outside[p] != outside[q] &&
        std::abs(pack.Radius[p] - pack.Radius[q]) <= tolerance * pack.Radius[p])
      {
        copy[outside[p] ? p : q] = true;
      }
    });
  return copy;
}
}
