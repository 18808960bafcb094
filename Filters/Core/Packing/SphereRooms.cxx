// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/SphereRooms.h"

#include "ruc/Base/Require.h"

#include <algorithm>
#include <limits>

namespace ruc
{
namespace
{
// In radii: more makes lists longer, less makes them anew more often
constexpr double RoomOfSphere = 0.25, RoomOfSmallest = 0.5;

double ShortestPeriod(const Window& box)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (int q = 0; q < 3; ++q)
  {
    shortest = box.Periodic[q] ? std::min(shortest, box.Size[q]) : shortest;
  }
  return shortest;
}
}

SphereRooms::SphereRooms(const SpherePack& pack, const Window& box, double largestGrowth)
  : Quarter(0.2499 * ShortestPeriod(box))
{
  const auto [least, greatest] = std::minmax_element(pack.Radius.begin(), pack.Radius.end());
  this->Least = *least * largestGrowth;
  this->Greatest = *greatest * largestGrowth;
  const double shortest = ShortestPeriod(box), needed = 2.0 * LeastEdgeInDiameters * this->Greatest;
  Require(needed < shortest, "A periodic box",
    Text("edges above ", LeastEdgeInDiameters, " diameters of the largest sphere, ", needed),
    shortest);
}

double SphereRooms::Of(double radius) const
{
  const double room = std::min(RoomOfSphere * radius, RoomOfSmallest * this->Least);
  return std::min(room, this->Quarter - radius);
}
}
