// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackFigures.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr double SecondsPerSphere = 1e-6; // for sharing, sorting and overlap
constexpr double BytesPerSphere = 250.0;

// The share of all pairs of points, spread evenly over a cube of edge 1, that are closer than r <=
// 1
double CubePairShare(double r)
{
  return r * r * r * (4.0 / 3.0 * Pi + r * (-1.5 * Pi + r * (1.6 - r / 6.0)));
}
}

double PackFigures::PairsWithin(double distance) const
{
  const double all = 0.5 * this->Spheres * this->Spheres;
  const double volume = this->Observed.Volume();
  if (this->Observed.IsFullyPeriodic())
  {
    return all * 4.0 / 3.0 * Pi * (distance * distance * distance) / volume;
  }
  return all * CubePairShare(std::min(distance / std::cbrt(volume), 1.0));
}

double PackFigures::HitsOn(double length) const
{
  return this->Density() * Pi * this->MeanSquareRadius * length;
}

Estimate EstimatePack(const PackFigures& pack)
{
  return { pack.Spheres * SecondsPerSphere, 0.0, pack.Spheres * BytesPerSphere / BytesOfMegabyte };
}
}
