// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/RadicalCell.h"

#include <voro++/cell.hh>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ruc
{
namespace
{
// The Legendre polynomials P_4 and P_6 of a cosine, by its square
double Fourth(double x2)
{
  return ((35.0 * x2 - 30.0) * x2 + 3.0) / 8.0;
}
double Sixth(double x2)
{
  return (((231.0 * x2 - 315.0) * x2 + 105.0) * x2 - 5.0) / 16.0;
}
}

struct RadicalCellFinder::Workspace
{
  voro::voronoicell_neighbor Cell;
  std::vector<int> Neighbours;
  std::vector<double> Areas;
};

RadicalCellFinder::RadicalCellFinder(double scale, double largestRadius)
  : Space(std::make_unique<Workspace>())
  , Scale(scale)
  , LargestRadius(largestRadius)
{
}

RadicalCellFinder::~RadicalCellFinder() = default;

namespace
{
void SetOrder(const std::vector<int>& neighbours, const std::vector<double>& areas,
  const std::vector<SphereAround>& around, RadicalCell& cell)
{
  std::vector<std::size_t> faces;
  double area = 0.0;
  for (std::size_t f = 0; f < neighbours.size(); ++f)
  {
    if (neighbours[f] >= 0)
    {
      faces.push_back(f);
      area += areas[f];
    }
  }
  double fourth = 0.0, sixth = 0.0;
  for (const std::size_t f : faces)
  {
    const SphereAround& one = around[neighbours[f]];
    for (const std::size_t g : faces)
    {
      const SphereAround& other = around[neighbours[g]];
      const double dot = Dot(one.Offset, other.Offset);
      const double cosine2 = dot * dot / (one.SquaredDistance * other.SquaredDistance);
      const double weight = areas[f] * areas[g] / (area * area);
      fourth += weight * Fourth(cosine2);
      sixth += weight * Sixth(cosine2);
    }
  }
  cell.Faces = static_cast<int>(faces.size());
  cell.Q4 = std::sqrt(std::max(fourth, 0.0));
  cell.Q6 = std::sqrt(std::max(sixth, 0.0));
}
}

RadicalCell RadicalCellFinder::Find(
  double radius, double reach, const std::vector<SphereAround>& around)
{
  RadicalCell found;
  voro::voronoicell_neighbor& cell = this->Space->Cell;
  // Voro++ compares with tolerances that are lengths. Where the cube around is not cut off
  // altogether, the farthest vertex lies beyond half the reach, so that the cell needs more.
  const double unit = 1.0 / this->Scale, edge = reach * unit;
  cell.init(-edge, edge, -edge, edge, -edge, edge);
  const double excess = this->LargestRadius * this->LargestRadius - radius * radius;
  double farthest = 0.0; // of the vertices
  const auto measure = [&]
  {
    farthest = 0.5 * this->Scale * std::sqrt(cell.max_radius_squared());
    found.NeededReach = farthest + std::sqrt(farthest * farthest + std::max(excess, 0.0));
  };
  measure();
  for (std::size_t n = 0; n < around.size(); ++n)
  {
    const SphereAround& sphere = around[n];
    const double distance = std::sqrt(sphere.SquaredDistance);
    if (distance >= found.NeededReach)
    {
      break;
    }
    const double plane =
      sphere.SquaredDistance + (radius - sphere.Radius) * (radius + sphere.Radius);
    if (plane < 2.0 * distance * farthest)
    {
      if (!cell.nplane(sphere.Offset[0] * unit, sphere.Offset[1] * unit, sphere.Offset[2] * unit,
            plane * unit * unit, static_cast<int>(n)))
      {
        found.NeededReach = 0.0;
        return found;
      }
      measure();
    }
  }
  if (found.NeededReach <= reach)
  {
    found.Volume = cell.volume() * this->Scale * this->Scale * this->Scale;
    cell.neighbors(this->Space->Neighbours);
    cell.face_areas(this->Space->Areas);
    SetOrder(this->Space->Neighbours, this->Space->Areas, around, found);
  }
  return found;
}
}
