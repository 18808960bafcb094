// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reconstruction/OverlapRemoval.h"

#include "FixedPoint.h"
#include "Geometry/CellList.h"
#include "Geometry/PairNeighbourhood.h"
#include "Geometry/SphereOverlap.h"
#include "Random.h"
#include "Reconstruction/Minimise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
// Calls visit(i, j, dx, dy, dz, d) for every pair, as places in the pack, whose centres are closer
// than reach x (a + b)
template <class Visit>
void ForEachContact(const SpherePack& pack, const Window& window, double reach, Visit&& visit)
{
  const CellList cells(pack, window, 2.0 * reach * pack.LargestRadius());
  std::vector<CellList::Range> ranges;
  for (std::size_t i = 0; i < cells.Size(); ++i)
  {
    cells.FindRanges(i, ranges);
    for (const CellList::Range& range : ranges)
    {
      for (std::size_t j = range.Begin; j < range.End; ++j)
      {
        const double dx = cells.X[j] - range.X, dy = cells.Y[j] - range.Y,
                     dz = cells.Z[j] - range.Z;
        const double d2 = dx * dx + dy * dy + dz * dz;
        const std::size_t p = cells.Index[i], q = cells.Index[j];
        const double contact = reach * (pack.Radius[p] + pack.Radius[q]);
        if (d2 < contact * contact)
        {
          visit(p, q, dx, dy, dz, std::sqrt(d2));
        }
      }
    }
  }
}
}

namespace
{
// Spheres so close are looked at for PackOverlap::Deepest
constexpr double Near = 1.01;

// Adds pairs of spheres up. A sphere shares less than its own volume with each of its neighbours;
// in fixed point the sum is the same in whatever order the pairs come.
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
  const PairNeighbourhood pairs(share, 2.0 * Near * share.LargestRadius, ranks);
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

bool RemoveOverlap(
  SpherePack& pack, const Window& box, std::uint32_t seed, const std::function<bool()>& carryOn)
{
  WrapIntoBox(pack, box);
  // Enlarged contacts end the search at a point where the true ones are free; near jamming there is
  // room for less
  constexpr double Enlargements[] = { 1e-4, 1e-5, 1e-6, 1e-4, 1e-5, 1e-6, 1e-5, 1e-6, 1e-5, 1e-6 };
  constexpr int MaximumIterations = 4000;
  const double smallest =
    pack.Empty() ? 0.0 : *std::min_element(pack.Radius.begin(), pack.Radius.end());
  bool stopped = false;
  std::uint32_t attempt = 0;
  for (double enlargement : Enlargements)
  {
    if (MeasureOverlap(pack, box).IsNone())
    {
      return true;
    }
    if (stopped)
    {
      return false;
    }
    if (attempt >= 3) // jammed: shake
    {
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        const std::array<double, 3> u = UniformTriple(seed, 0x5ba4e000u + attempt, i);
        pack.X[i] += smallest * (u[0] - 0.5);
        pack.Y[i] += smallest * (u[1] - 0.5);
        pack.Z[i] += smallest * (u[2] - 0.5);
      }
      WrapIntoBox(pack, box);
    }
    ++attempt;

    std::vector<double> centres = CentresOf(pack);
    const double reach = 1.0 + enlargement;
    bool free = false;
    const auto evaluate = [&](const double* x, double* gradient)
    {
      SetCentres(pack, box, x);
      std::fill_n(gradient, centres.size(), 0.0);
      double energy = 0.0;
      free = true;
      ForEachContact(pack, box, reach,
        [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d)
        {
          const double contact = pack.Radius[i] + pack.Radius[j];
          const double overlap = reach * contact - d;
          free = free && d >= contact;
          energy += overlap * overlap;
          const double pull = 2.0 * overlap / std::max(d, std::numeric_limits<double>::min());
          const double difference[3] = { dx, dy, dz };
          for (int q = 0; q < 3; ++q)
          {
            gradient[3 * i + q] += pull * difference[q];
            gradient[3 * j + q] -= pull * difference[q];
          }
        });
      return energy;
    };
    MinimiserSettings settings;
    settings.MaximumIterations = MaximumIterations;
    Minimise(centres, settings, evaluate,
      [&](const double*, double, int iteration)
      {
        stopped = iteration % 10 == 0 && !carryOn();
        return !free && !stopped;
      });
    SetCentres(pack, box, centres.data());
  }
  return MeasureOverlap(pack, box).IsNone();
}
}
