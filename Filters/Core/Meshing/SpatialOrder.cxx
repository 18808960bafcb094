// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/SpatialOrder.h"

#include "ruc/Base/Random.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ruc
{
namespace
{
constexpr int BitsOfCurve = 20; // along each axis, of the 41 of a coordinate
constexpr double CoordinateOfCurve = 1.0 / 2097152.0;
constexpr double ShareOfRound = 0.125;
constexpr int MostRounds = 12;

// The place of a point along a Hilbert curve (Skilling, AIP Conference Proceedings 707, 381 (2004))
std::uint64_t PlaceOnCurve(const GridPoint& point)
{
  constexpr std::uint32_t top = 1u << (BitsOfCurve - 1);
  std::uint32_t x[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    x[axis] = std::min(static_cast<std::uint32_t>(point[axis] * CoordinateOfCurve), 2 * top - 1);
  }
  for (std::uint32_t bit = top; bit > 1; bit >>= 1)
  {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& coordinate : x)
    {
      if (coordinate & bit)
      {
        x[0] ^= below;
      }
      else
      {
        const std::uint32_t swapped = (x[0] ^ coordinate) & below;
        x[0] ^= swapped;
        coordinate ^= swapped;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t flip = 0;
  for (std::uint32_t bit = top; bit > 1; bit >>= 1)
  {
    flip ^= x[2] & bit ? bit - 1 : 0;
  }
  std::uint64_t place = 0;
  for (int bit = BitsOfCurve - 1; bit >= 0; --bit)
  {
    for (const std::uint32_t coordinate : x)
    {
      place = place << 1 | (((coordinate ^ flip) >> bit) & 1);
    }
  }
  return place;
}

// The last round takes most of the points, the first ones few
int RoundOf(std::size_t point)
{
  RandomSequence draw(0, RandomStream::MeshOrder, point);
  int round = MostRounds;
  while (round > 0 && draw.Next() < ShareOfRound)
  {
    --round;
  }
  return round;
}
}

std::vector<int> InsertionOrder(const std::vector<GridPoint>& points)
{
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(points.size());
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const auto round = static_cast<std::uint64_t>(RoundOf(n));
    keys.emplace_back(round << (3 * BitsOfCurve) | PlaceOnCurve(points[n]), static_cast<int>(n));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(points.size());
  for (const auto& key : keys)
  {
    order.push_back(key.second);
  }
  return order;
}
}
