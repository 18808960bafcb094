// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/SurfaceDistances.h"

#include "ruc/Base/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// Lowers the distances of points along a row, which lie at start, start + spacing, ... from the
// sphere's centre, at the distance whose square is `across` from that line
RUC_VECTOR_CLONES
void LowerRow(float* distance, std::int32_t* sphere, int count, float start, float spacing,
  float across, float radius, std::int32_t number)
{
  for (int k = 0; k < count; ++k)
  {
    const float along = start + static_cast<float>(k) * spacing;
    const float d = std::sqrt(across + along * along) - radius;
    const bool nearer = d < distance[k];
    distance[k] = nearer ? d : distance[k];
    sphere[k] = nearer ? number : sphere[k];
  }
}

// The points of an axis closer than `reach` to a place; along a periodic axis they may lie outside
// [0, Count)
struct Stretch
{
  int First, Last;
};
Stretch FindStretch(const PointLattice& lattice, int axis, double place, double reach)
{
  const double at = (place - lattice.Origin[axis]) / lattice.Spacing[axis];
  const double half = reach / lattice.Spacing[axis];
  const int first = static_cast<int>(std::ceil(at - half));
  const int last = static_cast<int>(std::floor(at + half));
  return lattice.Periodic[axis]
    ? Stretch{ first, last }
    : Stretch{ std::max(first, 0), std::min(last, lattice.Count[axis] - 1) };
}

int Wrapped(int place, int count)
{
  const int rest = place % count;
  return rest < 0 ? rest + count : rest;
}

// A sphere and the points of one plane
void LowerPlane(const SpherePack& pack, std::size_t s, const PointLattice& lattice, double most,
  double dx, float* distance, std::int32_t* sphere)
{
  const double reach = pack.Radius[s] + most;
  const double reachY = std::sqrt(std::max(reach * reach - dx * dx, 0.0));
  const Stretch y = FindStretch(lattice, 1, pack.Y[s], reachY);
  const int row = lattice.Count[2];
  for (int j = y.First; j <= y.Last; ++j)
  {
    const double dy = lattice.Origin[1] + j * lattice.Spacing[1] - pack.Y[s];
    const double across = dx * dx + dy * dy;
    const Stretch z =
      FindStretch(lattice, 2, pack.Z[s], std::sqrt(std::max(reach * reach - across, 0.0)));
    const std::size_t begin = static_cast<std::size_t>(Wrapped(j, lattice.Count[1])) * row;
    for (int k = z.First; k <= z.Last;)
    {
      // As far as the row goes without a period
      const int inRow = Wrapped(k, row);
      const int count = std::min(z.Last - k + 1, row - inRow);
      const double start = lattice.Origin[2] + k * lattice.Spacing[2] - pack.Z[s];
      LowerRow(&distance[begin + inRow], &sphere[begin + inRow], count, static_cast<float>(start),
        static_cast<float>(lattice.Spacing[2]), static_cast<float>(across),
        static_cast<float>(pack.Radius[s]), static_cast<std::int32_t>(s));
      k += count;
    }
  }
}
}

double LatticeSpacing(const Window& box, double finest, double most)
{
  double spacing = finest, excess = 1.0;
  do
  {
    double points = 1.0;
    for (double edge : box.Size)
    {
      points *= std::max(1.0, edge / spacing);
    }
    excess = points / most;
    spacing *= std::max(1.0, std::cbrt(excess));
  } while (excess > 1.01);
  return spacing;
}

SurfaceDistances FindSurfaceDistances(
  const SpherePack& pack, const PointLattice& lattice, double most, int first, int last)
{
  const std::size_t plane = lattice.PlaneSize();
  SurfaceDistances found;
  found.Distance.assign(plane * (last - first), static_cast<float>(most));
  found.Sphere.assign(plane * (last - first), -1);
  const double period = lattice.Count[0] * lattice.Spacing[0];
#pragma omp parallel for schedule(dynamic)
  for (int i = first; i < last; ++i)
  {
    const std::size_t begin = plane * (i - first);
    const double x = lattice.Origin[0] + i * lattice.Spacing[0];
    for (std::size_t s = 0; s < pack.Size(); ++s)
    {
      const double reach = pack.Radius[s] + most;
      double dx = x - pack.X[s];
      dx -= lattice.Periodic[0] ? period * std::nearbyint(dx / period) : 0.0;
      const int images = lattice.Periodic[0] ? 1 : 0;
      for (int n = -images; n <= images; ++n)
      {
        const double fromImage = dx + n * period;
        if (std::abs(fromImage) < reach)
        {
          LowerPlane(
            pack, s, lattice, most, fromImage, &found.Distance[begin], &found.Sphere[begin]);
        }
      }
    }
  }
  return found;
}
}
