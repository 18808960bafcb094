// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/PoreThroats.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
// A sphere, relative to another one
struct PoreThroats::Around
{
  Vector3 Centre;
  double Radius;

  double DistanceFrom(const Vector3& x) const
  {
    return Length({ x[0] - this->Centre[0], x[1] - this->Centre[1], x[2] - this->Centre[2] }) -
      this->Radius;
  }
  // The gradient of the distance
  Vector3 DirectionTo(const Vector3& x) const
  {
    const Vector3 d = { x[0] - this->Centre[0], x[1] - this->Centre[1], x[2] - this->Centre[2] };
    const double length = Length(d);
    return { d[0] / length, d[1] / length, d[2] / length };
  }
};

PoreThroats::PoreThroats(
  const PackShare& share, const PointLattice& lattice, double widest, Communicator& ranks)
  : Share(share)
  , Lattice(lattice)
  , Widest(widest)
  , Farthest(0.5 * Length(lattice.Spacing))
  , Spheres(share, 2.0 * (share.LargestRadius + widest + Farthest), ranks)
  , SortedPlace(share.Own.Size())
{
  for (std::size_t i = 0; i < this->Spheres.Size(); ++i)
  {
    this->SortedPlace[this->Spheres.PlaceOf(i)] = i;
  }
}

void PoreThroats::Gather(std::size_t sphere, std::vector<Around>& around) const
{
  around.assign(1, { { 0.0, 0.0, 0.0 }, this->Share.Own.Radius[sphere] });
  this->Spheres.ForEachAround(this->SortedPlace[sphere],
    [&](const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz, double)
    {
      around.push_back({ { dx, dy, dz }, part.Pack.Radius[j] });
    });
}

Vector3 PoreThroats::FromCentre(const Vector3& point, std::size_t sphere) const
{
  const Vector3 centre = this->Share.Own.Centre(sphere);
  Vector3 from;
  for (int q = 0; q < 3; ++q)
  {
    from[q] = point[q] - centre[q];
    const double edge = this->Share.Observed.Size[q];
    from[q] -= this->Lattice.Periodic[q] ? edge * std::nearbyint(from[q] / edge) : 0.0;
  }
  return from;
}

double PoreThroats::RaiseOne(
  const Vector3& point, double distance, const std::vector<Around>& around) const
{
  // The three that are nearest
  const Around* nearest[3] = { nullptr, nullptr, nullptr };
  double least[3] = { 1e300, 1e300, 1e300 };
  for (const Around& sphere : around)
  {
    double d = sphere.DistanceFrom(point);
    const Around* one = &sphere;
    for (int n = 0; n < 3; ++n)
    {
      if (d < least[n])
      {
        std::swap(d, least[n]);
        std::swap(one, nearest[n]);
      }
    }
  }
  if (!(least[2] - least[0] < 2.0 * this->Farthest))
  {
    return distance;
  }
  Vector3 x = point;
  for (int iteration = 0; iteration < 4; ++iteration)
  {
    const double d = nearest[0]->DistanceFrom(x);
    const Vector3 first = nearest[0]->DirectionTo(x);
    Vector3 across[2];
    double excess[2];
    for (int n = 0; n < 2; ++n)
    {
      const Vector3 direction = nearest[n + 1]->DirectionTo(x);
      excess[n] = nearest[n + 1]->DistanceFrom(x) - d;
      for (int q = 0; q < 3; ++q)
      {
        across[n][q] = first[q] - direction[q];
      }
    }
    const double aa = Dot(across[0], across[0]), ab = Dot(across[0], across[1]),
                 bb = Dot(across[1], across[1]);
    const double determinant = aa * bb - ab * ab;
    if (!(determinant > 1e-6))
    {
      return distance;
    }
    const double s = (bb * excess[0] - ab * excess[1]) / determinant;
    const double t = (aa * excess[1] - ab * excess[0]) / determinant;
    for (int q = 0; q < 3; ++q)
    {
      x[q] += s * across[0][q] + t * across[1][q];
    }
    if (!(Length({ x[0] - point[0], x[1] - point[1], x[2] - point[2] }) <= this->Farthest))
    {
      return distance;
    }
  }
  double raised = 1e300;
  for (const Around& sphere : around)
  {
    raised = std::min(raised, sphere.DistanceFrom(x));
  }
  return std::max(raised, distance);
}

std::vector<double> PoreThroats::Raise(const SurfaceDistances& own,
  const std::vector<double>& nearest, int first, Communicator& ranks) const
{
  std::vector<double> raised(nearest.size());
  const std::int64_t rows = static_cast<std::int64_t>(nearest.size()) / this->Lattice.Count[2];
#pragma omp parallel
  {
    std::vector<Around> around;
    std::int32_t gathered = -1;
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t row = 0; row < rows; ++row)
    {
      const int i = first + static_cast<int>(row / this->Lattice.Count[1]);
      const int j = static_cast<int>(row % this->Lattice.Count[1]);
      for (int k = 0; k < this->Lattice.Count[2]; ++k)
      {
        const std::size_t n = row * this->Lattice.Count[2] + k;
        const std::int32_t sphere = own.Sphere[n];
        // By the rank of the nearest sphere; less than 0, for the least of all ranks to be found
        raised[n] = -nearest[n];
        if (sphere >= 0 && own.Distance[n] == nearest[n] && nearest[n] > 0.0 &&
          nearest[n] < this->Widest)
        {
          if (sphere != gathered)
          {
            this->Gather(sphere, around);
            gathered = sphere;
          }
          const Vector3 from = this->FromCentre(this->Lattice.PointAt(i, j, k), sphere);
          // As exact as a float, so that the sphere that it is relative to makes no difference
          raised[n] = -static_cast<float>(this->RaiseOne(from, nearest[n], around));
        }
      }
    }
  }
  ranks.Minimum(raised.data(), raised.size());
  for (double& distance : raised)
  {
    distance = -distance;
  }
  return raised;
}
}
