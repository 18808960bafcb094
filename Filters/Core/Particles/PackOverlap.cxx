// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackOverlap.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Particles/Contacts.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
// Spheres closer than this many contacts are looked at for PackOverlap::Deepest
constexpr double Near = 1.01;

// Adds pairs of spheres up. The sum is in fixed point, and so the same in whatever order the pairs
// come. A sphere shares less than its own volume with each of its neighbours.
struct OverlapSum
{
  explicit OverlapSum(double totalVolume)
    : Scale(std::ldexp(1.0, 50 - std::ilogb(totalVolume)))
  {
  }
  void Add(double a, double b, double d)
  {
    this->Deepest = std::max(this->Deepest, (a + b - d) / (a + b));
    if (d < a + b)
    {
      ++this->Pairs;
      this->Shared +=
        RoundToFixedPoint(this->Scale * LensVolume(std::min(a, b), std::max(a, b), d));
    }
  }
  double Scale;
  double Deepest = -1.0;
  std::int64_t Pairs = 0, Shared = 0;
};
}

PackOverlap MeasureOverlap(const SpherePack& pack, const Window& window)
{
  SpherePack wrapped = pack;
  WrapIntoBox(wrapped, window);
  double total = 0.0;
  for (double radius : pack.Radius)
  {
    total += SphereVolume(radius);
  }
  OverlapSum sum(total);
  ForEachContact(wrapped, window, Near,
    [&](std::size_t i, std::size_t j, double, double, double, double d)
    { sum.Add(wrapped.Radius[i], wrapped.Radius[j], d); });
  return { sum.Shared / sum.Scale / total * 100.0, sum.Pairs, sum.Deepest };
}

PackOverlap MeasureOverlap(const PackShare& share, Communicator& ranks)
{
  const double total = std::accumulate(share.Volume.begin(), share.Volume.end(), 0.0);
  OverlapSum sum(total);
  const PairNeighbourhood pairs(share, SizeClasses(share.Own.Radius, 0.0, Near, ranks), ranks);
  pairs.ForEachPair(0, pairs.Size(),
    [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, double, double, double,
      double d2)
    {
      const double contact = share.Own.Radius[i] + part.Pack.Radius[j];
      if (d2 < Near * contact * (Near * contact))
      {
        sum.Add(share.Own.Radius[i], part.Pack.Radius[j], std::sqrt(d2));
      }
    });
  std::int64_t counts[2] = { sum.Pairs, sum.Shared };
  ranks.Sum(counts, 2);
  double nearest = -sum.Deepest;
  ranks.Minimum(&nearest, 1);
  return { counts[1] / sum.Scale / total * 100.0, counts[0], -nearest };
}
}
