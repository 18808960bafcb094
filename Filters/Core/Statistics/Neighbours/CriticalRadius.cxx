// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/CriticalRadius.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ruc
{
LatticeValues LatticeValues::Box(
  const std::array<int, 3>& from, const std::array<int, 3>& count) const
{
  return {
    &this->First[from[0] * this->Stride[0] + from[1] * this->Stride[1] + from[2] * this->Stride[2]],
    this->Stride, count, { false, false, false }
  };
}

namespace
{
using Winding = std::array<std::int8_t, 3>; // whole periods

// Clusters of points: a forest, in which each point knows by how many periods it is away from its
// parent, and the root which planes the cluster touches
class Clusters
{
public:
  explicit Clusters(const LatticeValues& values)
    : Values(values)
    , Parent(values.Size(), Absent)
    , Away(values.Size(), Winding{})
    , Planes(values.Size(), 0)
  {
  }

  // Adds a point and what it connects; sets a value where an axis is crossed for the first time
  void Add(std::uint32_t point, std::array<double, 3>& critical)
  {
    const auto& count = this->Values.Count;
    const std::uint32_t plane = static_cast<std::uint32_t>(count[1]) * count[2];
    const std::array<int, 3> at = { static_cast<int>(point / plane),
      static_cast<int>(point % plane / count[2]), static_cast<int>(point % count[2]) };
    const double value = this->Values.At(at[0], at[1], at[2]);
    this->Parent[point] = point;
    for (int q = 0; q < 3; ++q)
    {
      const int bits = (at[q] == 0 ? 1 : 0) | (at[q] == count[q] - 1 ? 2 : 0);
      this->Planes[point] |= this->Values.Periodic[q] ? 0 : bits << (2 * q);
    }
    this->SetCrossed(this->Planes[point], value, critical);
    for (int n = 0; n < 6; ++n)
    {
      std::array<int, 3> next = at;
      Winding away{};
      const int axis = n / 2;
      next[axis] += n % 2 == 0 ? -1 : 1;
      const bool isOutside = next[axis] < 0 || next[axis] >= count[axis];
      if (isOutside)
      {
        away[axis] = static_cast<std::int8_t>(next[axis] < 0 ? -1 : 1);
        next[axis] -= away[axis] * count[axis];
      }
      const bool inside = !isOutside || this->Values.Periodic[axis];
      const std::uint32_t other = next[0] * plane + next[1] * count[2] + next[2];
      if (inside && this->Parent[other] != Absent)
      {
        this->Join(point, other, away, value, critical);
      }
    }
  }

private:
  static constexpr std::uint32_t Absent = 0xffffffff;

  static Winding Sum(const Winding& a, const Winding& b, int sign)
  {
    Winding sum;
    for (int q = 0; q < 3; ++q)
    {
      sum[q] = static_cast<std::int8_t>(a[q] + sign * b[q]);
    }
    return sum;
  }

  // The root of a point, and by how many periods the point is away from it
  std::uint32_t RootOf(std::uint32_t point, Winding& away)
  {
    away = {};
    std::uint32_t root = point;
    while (this->Parent[root] != root)
    {
      away = Sum(away, this->Away[root], 1);
      root = this->Parent[root];
    }
    Winding rest = away;
    while (this->Parent[point] != root && point != root)
    {
      const std::uint32_t next = this->Parent[point];
      const Winding step = this->Away[point];
      this->Parent[point] = root;
      this->Away[point] = rest;
      rest = Sum(rest, step, -1);
      point = next;
    }
    return root;
  }

  void SetCrossed(int planes, double value, std::array<double, 3>& critical) const
  {
    for (int q = 0; q < 3; ++q)
    {
      if ((planes >> (2 * q) & 3) == 3 && critical[q] == 0.0)
      {
        critical[q] = value;
      }
    }
  }

  // The image of `other` that is `away` periods from where it lies is connected to the point
  void Join(std::uint32_t point, std::uint32_t other, const Winding& away, double value,
    std::array<double, 3>& critical)
  {
    Winding ofPoint, ofOther;
    const std::uint32_t a = this->RootOf(point, ofPoint), b = this->RootOf(other, ofOther);
    // From the root of the point to that of the other one
    const Winding between = Sum(Sum(ofPoint, away, 1), ofOther, -1);
    if (a == b)
    {
      for (int q = 0; q < 3; ++q)
      {
        if (between[q] != 0 && critical[q] == 0.0)
        {
          critical[q] = value;
        }
      }
      return;
    }
    this->Parent[b] = a;
    this->Away[b] = between;
    this->Planes[a] |= this->Planes[b];
    this->SetCrossed(this->Planes[a], value, critical);
  }

  const LatticeValues& Values;
  std::vector<std::uint32_t> Parent;
  std::vector<Winding> Away;
  std::vector<std::uint8_t> Planes;
};
}

std::array<double, 3> FindCriticalValues(const LatticeValues& values)
{
  std::array<double, 3> critical = { 0.0, 0.0, 0.0 };
  std::vector<float> all;
  std::vector<std::uint32_t> order;
  all.reserve(values.Size());
  for (int i = 0; i < values.Count[0]; ++i)
  {
    for (int j = 0; j < values.Count[1]; ++j)
    {
      for (int k = 0; k < values.Count[2]; ++k)
      {
        all.push_back(values.At(i, j, k));
        if (all.back() > 0.0F)
        {
          order.push_back(static_cast<std::uint32_t>(all.size() - 1));
        }
      }
    }
  }
  const auto first = [&](std::uint32_t a, std::uint32_t b)
  { return all[a] != all[b] ? all[a] > all[b] : a < b; };
  Clusters clusters(values);
  const auto isDone = [&]
  { return std::all_of(critical.begin(), critical.end(), [](double v) { return v > 0.0; }); };
  // The greatest values are sorted, and more only where these do not connect
  for (std::size_t begin = 0; begin < order.size() && !isDone();)
  {
    const std::size_t end = std::min(order.size(), begin + order.size() / 8 + 1);
    std::nth_element(order.begin() + begin, order.begin() + (end - 1), order.end(), first);
    std::sort(order.begin() + begin, order.begin() + end, first);
    for (; begin < end && !isDone(); ++begin)
    {
      clusters.Add(order[begin], critical);
    }
  }
  return critical;
}
}
