// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PairNeighbourhood.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace ruc
{
namespace
{
using Edges = std::array<int, 3>;
// Spheres, by the whole edges that they are to be displaced by
using Halo = std::map<Edges, SpherePack>;
// Slack for the rounding of a displacement, so that a pair at exactly the cut-off is not missed
constexpr double Slack = 1.0 + 1e-12;

struct Bounds
{
  Vector3 Low, High;
  bool Empty() const { return this->Low[0] > this->High[0]; }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Low, self.High);
  }
};

struct HaloPart
{
  Edges By;
  SpherePack Pack;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.By, self.Pack);
  }
};

// The bounds of the centres of every class on every rank
std::vector<std::vector<Bounds>> FindBounds(
  const SpherePack& own, const SizeClasses& classes, Communicator& ranks)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Bounds none = { { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
  std::vector<Bounds> bounds(classes.Count(), none);
  for (std::size_t i = 0; i < own.Size(); ++i)
  {
    const Vector3 centre = own.Centre(i);
    Bounds& ofClass = bounds[classes.ClassOf(own.Radius[i])];
    for (int q = 0; q < 3; ++q)
    {
      ofClass.Low[q] = std::min(ofClass.Low[q], centre[q]);
      ofClass.High[q] = std::max(ofClass.High[q], centre[q]);
    }
  }
  return ranks.AllGather(bounds);
}

// Calls visit(edges) for every displacement of `centre` by whole edges that brings it closer to
// `bounds` than the cut-off
template <class Visit>
void ForEachImageNear(
  const Vector3& centre, const Bounds& bounds, const Window& window, double cutoff, Visit&& visit)
{
  const double cutoff2 = cutoff * cutoff;
  const auto distance2 = [&](int q, int n)
  {
    const double c = centre[q] + n * window.Size[q];
    const double d = std::max({ bounds.Low[q] - c, c - bounds.High[q], 0.0 });
    return d * d;
  };
  int first[3] = { 0, 0, 0 }, last[3] = { 0, 0, 0 };
  for (int q = 0; q < 3; ++q)
  {
    if (window.Periodic[q])
    {
      const double edge = window.Size[q];
      first[q] = static_cast<int>(std::ceil((bounds.Low[q] - cutoff - centre[q]) / edge));
      last[q] = static_cast<int>(std::floor((bounds.High[q] + cutoff - centre[q]) / edge));
    }
  }
  for (int nx = first[0]; nx <= last[0]; ++nx)
  {
    const double x2 = distance2(0, nx);
    for (int ny = first[1]; x2 < cutoff2 && ny <= last[1]; ++ny)
    {
      const double xy2 = x2 + distance2(1, ny);
      for (int nz = first[2]; xy2 < cutoff2 && nz <= last[2]; ++nz)
      {
        if (xy2 + distance2(2, nz) < cutoff2)
        {
          visit(Edges{ nx, ny, nz });
        }
      }
    }
  }
}

// The displacements by whole edges that bring a sphere near to the centres of a rank, each once
std::vector<Edges> EdgesTo(const PackShare& share, std::size_t i, const std::vector<Bounds>& bounds,
  const SizeClasses& classes)
{
  std::vector<Edges> found;
  const int own = classes.ClassOf(share.Own.Radius[i]);
  for (int c = 0; c < classes.Count(); ++c)
  {
    if (!bounds[c].Empty())
    {
      ForEachImageNear(share.Own.Centre(i), bounds[c], share.Observed,
        classes.Reach(own, c) * Slack, [&](const Edges& edges) { found.push_back(edges); });
    }
  }
  if (classes.Count() > 1)
  {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }
  return found;
}

// Whether a pair is met from one of its spheres, or from both
enum class Met
{
  Once,
  FromBoth
};

// The spheres of this rank that belong to the surroundings of another rank's centres, or of its own
// by periodic images, for those pairs that are for that rank to meet
Halo HaloOf(int rank, const PackShare& share, const std::vector<Bounds>& bounds,
  const SizeClasses& classes, Met met, int own)
{
  const Edges none = { 0, 0, 0 };
  Halo halo;
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    for (const Edges& edges : EdgesTo(share, i, bounds, classes))
    {
      if (met == Met::FromBoth ? edges != none || rank != own
                               : edges > none || (edges == none && rank < own))
      {
        halo[edges].Append(share.Own, i);
      }
    }
  }
  return halo;
}

// Receives what the other ranks, and this one along periodic axes, have around this rank's centres
Halo ExchangeHalos(const PackShare& share, const SizeClasses& classes, Met met, Communicator& ranks)
{
  const std::vector<std::vector<Bounds>> bounds = FindBounds(share.Own, classes, ranks);
  std::vector<std::vector<HaloPart>> outgoing(ranks.Size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    for (auto& [edges, pack] : HaloOf(rank, share, bounds[rank], classes, met, ranks.Rank()))
    {
      outgoing[rank].push_back({ edges, std::move(pack) });
    }
  }
  Halo halo;
  for (std::vector<HaloPart>& parts : ranks.AllToAll(std::move(outgoing)))
  {
    for (HaloPart& part : parts)
    {
      halo[part.By].Append(std::exchange(part.Pack, {}));
    }
  }
  return halo;
}

// The share's own spheres and those around them
std::vector<PairNeighbourhood::Part> FindParts(
  const PackShare& share, const SizeClasses& classes, Met met, Communicator& ranks)
{
  const Window unbounded = Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { false, false, false });
  Halo halo = ExchangeHalos(share, classes, met, ranks);
  std::vector<PairNeighbourhood::Part> parts;
  parts.push_back({ share.Own, CellList(share.Own, unbounded, classes), { 0.0, 0.0, 0.0 } });
  for (auto& [edges, pack] : halo)
  {
    const Vector3& size = share.Observed.Size;
    CellList cells(pack, unbounded, classes);
    parts.push_back({ std::move(pack), std::move(cells),
      { edges[0] * size[0], edges[1] * size[1], edges[2] * size[2] } });
  }
  return parts;
}
}

PairNeighbourhood::PairNeighbourhood(const PackShare& share, double cutoff, Communicator& ranks)
  : PairNeighbourhood(share, SizeClasses(cutoff), ranks)
{
}

PairNeighbourhood::PairNeighbourhood(
  const PackShare& share, const SizeClasses& classes, Communicator& ranks)
  : Parts(FindParts(share, classes, Met::Once, ranks))
  , Classes(classes)
{
}

void PairNeighbourhood::FindRanges(std::size_t i, std::vector<Range>& ranges) const
{
  ranges.clear();
  const CellList& own = this->Own();
  thread_local std::vector<CellList::Range> found;
  own.FindRanges(i, found);
  const int sizeClass = own.ClassOf(i);
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    if (part > 0)
    {
      const Vector3& shift = this->Parts[part].Shift;
      this->Parts[part].Cells.FindRangesAround(
        { own.X[i] - shift[0], own.Y[i] - shift[1], own.Z[i] - shift[2] }, sizeClass, found);
    }
    for (const CellList::Range& range : found)
    {
      ranges.push_back({ part, range.Begin, range.End, range.Reach });
    }
  }
}

std::int64_t PairNeighbourhood::MostNeighbours() const
{
  std::int64_t most = 0;
  for (const Part& part : this->Parts)
  {
    most += part.Cells.MostNeighbours();
  }
  return most;
}

Surroundings::Surroundings(const PackShare& share, double reach, Communicator& ranks)
  : Reach2(reach * reach)
  , Parts(FindParts(share, SizeClasses(reach), Met::FromBoth, ranks))
{
}
}
