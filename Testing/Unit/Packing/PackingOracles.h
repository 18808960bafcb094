// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Oracles.h"
#include "ruc/Packing/DensePack.h"

namespace oracle
{
// For a pack that nobody stops
inline const auto Always = [](const ruc::GrowthStep&, double) { return true; };

// Equal spheres of diameter 1
inline ruc::DensePackSettings Equal(int spheres, double fraction)
{
  ruc::DensePackSettings settings;
  settings.Radii.assign(spheres, 0.5);
  settings.Fraction = fraction;
  return settings;
}

// Calls visit(i, j, distance) for all pairs of nearest images in a periodic box
template <class Visit>
void ForEachPair(const ruc::SpherePack& pack, const ruc::Window& box, Visit&& visit)
{
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const ruc::Vector3 a = pack.Centre(i);
    for (std::size_t j = 0; j < i; ++j)
    {
      const ruc::Vector3 b = pack.Centre(j);
      double squares = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        double d = b[q] - a[q];
        d -= box.Size[q] * std::round(d / box.Size[q]);
        squares += d * d;
      }
      visit(i, j, std::sqrt(squares));
    }
  }
}

// The least of d - (a + b) over all pairs of nearest images, and of what walls leave, without any
// grid of cells
inline double LeastRoom(const ruc::SpherePack& pack, const ruc::Window& box)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const ruc::Vector3 a = pack.Centre(i);
    for (int q = 0; q < 3; ++q)
    {
      const double low = a[q] - box.Origin[q];
      if (!box.Periodic[q])
      {
        least = std::min({ least, low - pack.Radius[i], box.Size[q] - low - pack.Radius[i] });
      }
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      const ruc::Vector3 b = pack.Centre(j);
      double squares = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        double d = b[q] - a[q];
        d -= box.Periodic[q] ? box.Size[q] * std::round(d / box.Size[q]) : 0.0;
        squares += d * d;
      }
      least = std::min(least, std::sqrt(squares) - (pack.Radius[i] + pack.Radius[j]));
    }
  }
  return least;
}

inline double FractionOf(const ruc::SpherePack& pack, const ruc::Window& box)
{
  double volume = 0.0;
  for (double r : pack.Radius)
  {
    volume += 4.0 / 3.0 * Pi * r * r * r;
  }
  return volume / (box.Size[0] * box.Size[1] * box.Size[2]);
}
}
