// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/SphereGrid.h"

#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// The most places in cells, and the most cells, for each sphere; both take 4 bytes
constexpr double MostPlaces = 8.0, MostCells = 2.0;
}

SphereGrid::SphereGrid(const SpherePack& pack, const Window& box)
  : Box(box)
  , Slack(1e-9 * *std::max_element(box.Size.begin(), box.Size.end()))
{
  const Vector3 upper = { box.Origin[0] + box.Size[0], box.Origin[1] + box.Size[1],
    box.Origin[2] + box.Size[2] };
  // An edge exceeds the diameter, so only the nearest images can reach into the box
  const int lastX = box.Periodic[0], lastY = box.Periodic[1], lastZ = box.Periodic[2];
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int z = -lastZ; z <= lastZ; ++z)
    {
      for (int y = -lastY; y <= lastY; ++y)
      {
        for (int x = -lastX; x <= lastX; ++x)
        {
          const Copy copy = { pack.X[i], pack.Y[i], pack.Z[i], pack.Radius[i], pack.Mode[i] - 1,
            { std::int8_t(x), std::int8_t(y), std::int8_t(z) } };
          if (this->ReachesInto(copy, box.Origin, upper))
          {
            this->Copies.push_back(copy);
          }
        }
      }
    }
  }
  this->Copies.shrink_to_fit();
  this->ChooseCells();

  std::vector<std::uint32_t> places(
    static_cast<std::size_t>(this->Count[0]) * this->Count[1] * this->Count[2] + 1, 0);
  for (const Copy& copy : this->Copies)
  {
    this->ForEachCellOf(copy, [&](std::size_t cell) { ++places[cell]; });
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& place : places)
  {
    sum += place;
    place = sum;
  }
  this->Places.resize(sum);
  // Cells are filled from their ends, after which places[cell] is where the cell begins
  for (std::size_t n = this->Copies.size(); n-- > 0;)
  {
    this->ForEachCellOf(this->Copies[n],
      [&](std::size_t cell) { this->Places[--places[cell]] = static_cast<std::uint32_t>(n); });
  }
  this->CellBegin = std::move(places);
}

Vector3 SphereGrid::CentreOf(const Copy& copy) const
{
  return { copy.X + copy.Image[0] * this->Box.Size[0], copy.Y + copy.Image[1] * this->Box.Size[1],
    copy.Z + copy.Image[2] * this->Box.Size[2] };
}

bool SphereGrid::ReachesInto(const Copy& copy, const Vector3& lower, const Vector3& upper) const
{
  const Vector3 centre = this->CentreOf(copy);
  double distance2 = 0.0;
  for (int q = 0; q < 3; ++q)
  {
    const double out = std::max({ lower[q] - centre[q], centre[q] - upper[q], 0.0 });
    distance2 += out * out;
  }
  const double radius = copy.Radius + this->Slack;
  return distance2 < radius * radius;
}

// Chooses the finest grid of about cubic cells that the memory allows. A sphere of radius a reaches
// into 1 + 6 (a/h) + 3 pi (a/h)^2 + 4/3 pi (a/h)^3 cells of edge h in the mean (Steiner's formula).
void SphereGrid::ChooseCells()
{
  double sum[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (const Copy& copy : this->Copies)
  {
    const double a = copy.Radius;
    sum[0] += 1.0;
    sum[1] += 6.0 * a;
    sum[2] += 3.0 * Pi * a * a;
    sum[3] += 4.0 / 3.0 * Pi * a * a * a;
  }
  const double spheres = std::max(sum[0], 1.0);
  double edge = std::cbrt(this->Box.Volume() / (MostCells * spheres));
  const Vector3& size = this->Box.Size;
  const auto cellsOf = [&](double h)
  { return std::max(size[0] / h, 1.0) * std::max(size[1] / h, 1.0) * std::max(size[2] / h, 1.0); };
  const auto placesOf = [&](double h)
  { return sum[0] + sum[1] / h + sum[2] / (h * h) + sum[3] / (h * h * h); };
  while (cellsOf(edge) > 1.01 * MostCells * spheres || placesOf(edge) > MostPlaces * spheres)
  {
    edge *= 1.05;
  }
  for (int q = 0; q < 3; ++q)
  {
    this->Count[q] = static_cast<int>(std::max(size[q] / edge, 1.0));
    this->Edge[q] = size[q] / this->Count[q];
  }
}

int SphereGrid::CellAlong(int axis, double position) const
{
  const double cell = std::floor((position - this->Box.Origin[axis]) / this->Edge[axis]);
  return static_cast<int>(std::clamp(cell, 0.0, this->Count[axis] - 1.0));
}

template <class Visit>
void SphereGrid::ForEachCellOf(const Copy& copy, Visit&& visit) const
{
  const Vector3 centre = this->CentreOf(copy);
  const double radius = copy.Radius + this->Slack;
  int first[3], last[3];
  for (int q = 0; q < 3; ++q)
  {
    first[q] = this->CellAlong(q, centre[q] - radius);
    last[q] = this->CellAlong(q, centre[q] + radius);
  }
  const auto border = [&](int q, int cell) { return this->Box.Origin[q] + cell * this->Edge[q]; };
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        if (this->ReachesInto(copy, { border(0, x), border(1, y), border(2, z) },
              { border(0, x + 1), border(1, y + 1), border(2, z + 1) }))
        {
          visit(this->CellNumber(x, y, z));
        }
      }
    }
  }
}

int SphereGrid::LowestModeAt(const Vector3& point, int none) const
{
  const std::size_t number = this->CellNumber(
    this->CellAlong(0, point[0]), this->CellAlong(1, point[1]), this->CellAlong(2, point[2]));
  int lowest = none;
  for (std::uint32_t n = this->CellBegin[number]; n < this->CellBegin[number + 1]; ++n)
  {
    const Copy& copy = this->Copies[this->Places[n]];
    const Vector3 centre = this->CentreOf(copy);
    const double x = point[0] - centre[0], y = point[1] - centre[1], z = point[2] - centre[2];
    if (x * x + y * y + z * z < copy.Radius * copy.Radius)
    {
      lowest = std::min(lowest, copy.Mode);
    }
  }
  return lowest;
}
}
