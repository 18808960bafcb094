// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/MaximumFraction.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace ruc
{
namespace
{
constexpr int Rods = 20000;
constexpr double GapOfRod = 0.7654; // times its length

// A line meets a sphere in proportion to the square of its radius, and cuts a chord 2 r sqrt(u)
// with a uniform u
std::vector<double> ChordsOf(std::vector<double> radii)
{
  std::sort(radii.begin(), radii.end());
  double total = 0.0;
  for (double r : radii)
  {
    total += r * r;
  }
  std::vector<double> chords;
  double passed = 0.0;
  std::size_t sphere = 0;
  for (int n = 0; n < Rods; ++n)
  {
    const double wanted = (n + 0.5) / Rods * total;
    while (sphere + 1 < radii.size() && passed + radii[sphere] * radii[sphere] < wanted)
    {
      passed += radii[sphere] * radii[sphere];
      ++sphere;
    }
    // Multiples of the golden ratio are spread evenly, however many of them one sphere gets
    const double turns = (n + 0.5) * 0.6180339887498949;
    chords.push_back(2.0 * radii[sphere] * std::sqrt(turns - std::floor(turns)));
  }
  std::sort(chords.begin(), chords.end(), std::greater<>());
  return chords;
}
}

double MaximumRandomFraction(const std::vector<double>& radii)
{
  const std::vector<double> chords = ChordsOf(radii);
  std::priority_queue<double> gaps;
  double length = 0.0, gapLength = 0.0;
  for (double chord : chords)
  {
    const double room = GapOfRod * chord;
    length += chord;
    if (gaps.empty())
    {
      gaps.push(room);
      gapLength += room;
      continue;
    }
    const double gap = gaps.top(), rest = std::max(room, gap - chord - room);
    gaps.pop();
    gaps.push(room);
    gaps.push(rest);
    gapLength += room + rest - gap;
  }
  return length / (length + gapLength);
}
}
