// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/MeshBox.h"

#include "ruc/Base/Random.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/CellList.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr int Shifts = 1500;
constexpr double WeightOfEdges =
  0.7; // a sphere near an edge is harder to mesh than one near a plane
constexpr double FinestShareOfEdge = 1e-3;

constexpr double NarrowGap = 0.02;

double MeanRadius(const SpherePack& pack)
{
  return std::accumulate(pack.Radius.begin(), pack.Radius.end(), 0.0) /
    static_cast<double>(pack.Radius.size());
}

double Wrapped(double x, double edge)
{
  const double wrapped = x - edge * std::floor(x / edge);
  return wrapped < edge ? wrapped : 0.0;
}

MeshCell CellAt(const SpherePack& pack, const Window& window, const Vector3& shift)
{
  MeshCell cell;
  cell.Edge = window.Size;
  cell.Radius = pack.Radius;
  for (std::size_t i = 0; i < pack.Radius.size(); ++i)
  {
    Vector3 centre = pack.Centre(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] = Wrapped(centre[axis] - window.Origin[axis] - shift[axis], window.Size[axis]);
    }
    cell.Centre.push_back(centre);
  }
  return cell;
}

double MarginOf(const MeshCell& cell, double enough)
{
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.Size() && margin > enough; ++i)
  {
    const double radius = cell.Radius[i];
    Vector3 near{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = cell.Centre[i][axis];
      near[axis] = std::min(x, cell.Edge[axis] - x);
      margin = std::min(margin, std::abs(near[axis] - radius) / radius);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double toEdge = std::hypot(near[(axis + 1) % 3], near[(axis + 2) % 3]);
      margin = std::min(margin, WeightOfEdges * std::abs(toEdge - radius) / radius);
    }
    margin = std::min(margin, (Length(near) - radius) / radius);
  }
  return margin;
}
}

ShiftedCell ShiftCell(const SpherePack& pack, const Window& window, const MeshSettings& settings)
{
  ShiftedCell best;
  best.Cell = CellAt(pack, window, best.Shift);
  best.Margin = MarginOf(best.Cell, -std::numeric_limits<double>::infinity());
  for (int n = 0; settings.ShiftOrigin && n < Shifts; ++n)
  {
    Vector3 shift = UniformTriple(settings.Seed, RandomStream::MeshPoints, n);
    for (int axis = 0; axis < 3; ++axis)
    {
      shift[axis] *= window.Size[axis];
    }
    MeshCell cell = CellAt(pack, window, shift);
    const double margin = MarginOf(cell, best.Margin);
    if (margin > best.Margin)
    {
      best = { std::move(cell), shift, margin };
    }
  }
  if (best.Margin <= 0.0)
  {
    throw std::invalid_argument(settings.ShiftOrigin
        ? "No origin keeps the corner of the box in the matrix, which the mesh requires; spheres "
          "fill all of it."
        : "ShiftOrigin must be on: the corner of the box lies in a sphere, and the mesh requires "
          "it "
          "in the matrix.");
  }
  return best;
}

CellGaps CheckGaps(const SpherePack& pack, const Window& window, const MeshSettings& settings)
{
  CellGaps gaps;
  gaps.Least = MeanRadius(pack);
  const double narrow = NarrowGap * gaps.Least;
  std::size_t first = 0, second = 0;
  const CellList cells(pack, window, SizeClasses(pack.Radius, gaps.Least, 1.0));
  cells.ForEachPair(
    [&](std::size_t i, std::size_t j, double, double, double, double d2)
    {
      const double gap = std::sqrt(d2) - pack.Radius[i] - pack.Radius[j];
      gaps.Narrow += gap < narrow;
      if (gap < gaps.Least)
      {
        gaps.Least = gap;
        first = std::min(i, j);
        second = std::max(i, j);
      }
    });
  const auto id = [&](std::size_t i)
  { return pack.Id.empty() ? static_cast<std::int64_t>(i) : pack.Id[i]; };
  if (gaps.Least <= 0.0)
  {
    throw std::invalid_argument(
      Text("Periodic Mesh requires spheres that do not touch, got spheres ", id(first), " and ",
        id(second), ", which overlap by ", -gaps.Least,
        "; set MinimumGap of Unit Cell Reconstruction."));
  }
  if (gaps.Least < settings.LeastGap)
  {
    throw std::invalid_argument(Text("LeastGap requires gaps >= ", settings.LeastGap, ", got ",
      gaps.Least, " between spheres ", id(first), " and ", id(second),
      "; set MinimumGap of Unit Cell Reconstruction."));
  }
  return gaps;
}

double FindElementSize(const SpherePack& pack, const Window& window, const MeshSettings& settings)
{
  const double shortest = window.ShortestEdge();
  const double size = settings.ElementSize == 0.0 ? std::min(0.5 * MeanRadius(pack), 0.5 * shortest)
                                                  : settings.ElementSize;
  Require(std::isfinite(size) && size >= FinestShareOfEdge * shortest && size <= 0.5 * shortest,
    "ElementSize",
    Text(
      "0 or a length from ", FinestShareOfEdge * shortest, " to ", 0.5 * shortest, " in this cell"),
    size);
  return size;
}
}
