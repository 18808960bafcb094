// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/CellList.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
int CellList::Axis::CellOf(double c) const
{
  return std::clamp(static_cast<int>((c - this->Origin) / this->Width), 0, this->Count - 1);
}

// A reach may be that many cells of a narrow pack that their number is no int
int CellList::Axis::FirstCell(double c, double reach) const
{
  const double cell = std::floor((c - reach - this->Origin) / this->Width);
  return static_cast<int>(this->Periodic ? cell : std::clamp(cell, 0.0, double(this->Count)));
}

int CellList::Axis::LastCell(double c, double reach) const
{
  const double cell = std::floor((c + reach - this->Origin) / this->Width);
  return static_cast<int>(this->Periodic ? cell : std::clamp(cell, -1.0, this->Count - 1.0));
}

double CellList::Axis::DistanceTo(double c, int k) const
{
  const double low = this->Origin + k * this->Width;
  return std::max({ low - c, c - (low + this->Width), 0.0 });
}

int CellList::Axis::ImageOf(int k) const
{
  return this->Periodic ? (k >= 0 ? k / this->Count : -((-k + this->Count - 1) / this->Count)) : 0;
}

std::size_t CellList::CellNumber(int cx, int cy, int cz) const
{
  return (std::size_t(cz) * this->Axes[1].Count + cy) * this->Axes[0].Count + cx;
}

CellList::CellList(const SpherePack& pack, const Window& window, double cutoff)
  : Cutoff(cutoff)
{
  const std::vector<double>* centres[3] = { &pack.X, &pack.Y, &pack.Z };
  for (int q = 0; q < 3; ++q)
  {
    Axis& axis = this->Axes[q];
    axis.Periodic = window.Periodic[q];
    if (axis.Periodic)
    {
      axis.Origin = window.Origin[q];
      axis.Edge = window.Size[q];
    }
    else
    {
      const auto [low, high] = std::minmax_element(centres[q]->begin(), centres[q]->end());
      axis.Origin = pack.Empty() ? 0.0 : *low;
      axis.Edge = std::max(pack.Empty() ? 0.0 : *high - *low, 1e-6 * cutoff);
    }
  }

  // A row of cells along x is one range, so rows are thick, to be few and long, and their cells
  // short, to fit the sphere of the cut-off. Fewer than one centre a cell make the walk over cells
  // dearer than the distances it saves.
  constexpr double rowsPerCutoff = 2.0;
  constexpr double cellsPerRowWidth = 4.0;
  const double volume = this->Axes[0].Edge * this->Axes[1].Edge * this->Axes[2].Edge;
  double width = std::max(cutoff / rowsPerCutoff,
    std::cbrt(cellsPerRowWidth * volume / std::max<std::size_t>(pack.Size(), 1)));
  const auto cells = [&]()
  {
    double product = 1.0;
    for (Axis& axis : this->Axes)
    {
      const double length = &axis == this->Axes ? width / cellsPerRowWidth : width;
      axis.Count = static_cast<int>(std::clamp(axis.Edge / length, 1.0, 1e6));
      axis.Width = axis.Edge / axis.Count;
      product *= axis.Count;
    }
    return product;
  };
  while (cells() > 2.0 * pack.Size() + 27.0)
  {
    width *= 1.25;
  }

  // Counting sort by cell; within a cell the order of the pack stays
  std::vector<std::size_t> cellOf(pack.Size());
  this->CellBegin.assign(
    std::size_t(this->Axes[0].Count) * this->Axes[1].Count * this->Axes[2].Count + 1, 0);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    cellOf[i] = this->CellNumber(this->Axes[0].CellOf(pack.X[i]), this->Axes[1].CellOf(pack.Y[i]),
      this->Axes[2].CellOf(pack.Z[i]));
    ++this->CellBegin[cellOf[i] + 1];
  }
  std::partial_sum(this->CellBegin.begin(), this->CellBegin.end(), this->CellBegin.begin());
  std::vector<std::size_t> next(this->CellBegin.begin(), this->CellBegin.end() - 1);
  this->X.resize(pack.Size());
  this->Y.resize(pack.Size());
  this->Z.resize(pack.Size());
  this->Index.resize(pack.Size());
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const std::size_t place = next[cellOf[i]]++;
    this->X[place] = pack.X[i];
    this->Y[place] = pack.Y[i];
    this->Z[place] = pack.Z[i];
    this->Index[place] = static_cast<std::uint32_t>(i);
  }
}

std::int64_t CellList::MostNeighbours() const
{
  std::size_t fullest = 0;
  for (std::size_t c = 0; c + 1 < this->CellBegin.size(); ++c)
  {
    fullest = std::max(fullest, this->CellBegin[c + 1] - this->CellBegin[c]);
  }
  double cells = 1.0;
  for (const Axis& axis : this->Axes)
  {
    const double span = 2.0 * std::ceil(this->Cutoff / axis.Width) + 1.0;
    cells *= axis.Periodic ? span : std::min(span, double(axis.Count));
  }
  return static_cast<std::int64_t>(std::ceil(cells * fullest));
}

void CellList::FindRanges(std::size_t i, std::vector<Range>& ranges) const
{
  ranges.clear();
  const Axis &ax = this->Axes[0], &ay = this->Axes[1], &az = this->Axes[2];
  // A centre's cell was found with rounding; the slack keeps a pair at the very cut-off from being
  // missed.
  const double reach = this->Cutoff + 1e-12 * (this->Cutoff + ax.Edge + ay.Edge + az.Edge);
  const double x = this->X[i], y = this->Y[i], z = this->Z[i];
  const int cx = ax.CellOf(x), cy = ay.CellOf(y), cz = az.CellOf(z);

  // Half of the neighbourhood: the layers above, the rows behind in the own layer, and what follows
  // in the own row
  const int lastZ = az.LastCell(z, reach);
  for (int kz = cz; kz <= lastZ; ++kz)
  {
    const bool ownLayer = kz == cz;
    const double dz = ownLayer ? 0.0 : az.DistanceTo(z, kz);
    const double reachY = std::sqrt(std::max(reach * reach - dz * dz, 0.0));
    const int lastY = ay.LastCell(y, reachY);
    const int imageZ = az.ImageOf(kz);
    for (int ky = ownLayer ? cy : ay.FirstCell(y, reachY); ky <= lastY; ++ky)
    {
      const bool ownRow = ownLayer && ky == cy;
      const double dy = ownRow ? 0.0 : ay.DistanceTo(y, ky);
      const double reachX = std::sqrt(std::max(reach * reach - dz * dz - dy * dy, 0.0));
      const int lastX = ax.LastCell(x, reachX);
      const int imageY = ay.ImageOf(ky);
      const std::size_t row = this->CellNumber(0, ky - imageY * ay.Count, kz - imageZ * az.Count);
      // A row of cells is one stretch of sorted places, as far as it lies in one image of the box
      for (int kx = ownRow ? cx : ax.FirstCell(x, reachX); kx <= lastX;)
      {
        const int imageX = ax.ImageOf(kx);
        const int end = std::min(lastX + 1, (imageX + 1) * ax.Count);
        const std::size_t begin =
          ownRow && kx == cx ? i + 1 : this->CellBegin[row + (kx - imageX * ax.Count)];
        const std::size_t stop = this->CellBegin[row + (end - imageX * ax.Count)];
        if (begin < stop)
        {
          ranges.push_back(
            { begin, stop, x - imageX * ax.Edge, y - imageY * ay.Edge, z - imageZ * az.Edge });
        }
        kx = end;
      }
    }
  }
}

void CellList::FindRangesAround(const Vector3& point, std::vector<Range>& ranges) const
{
  ranges.clear();
  const Axis &ax = this->Axes[0], &ay = this->Axes[1], &az = this->Axes[2];
  const double reach = this->Cutoff + 1e-12 * (this->Cutoff + ax.Edge + ay.Edge + az.Edge);
  const auto outside = [&](const Axis& axis, double c)
  { return c < axis.Origin - reach || c > axis.Origin + axis.Edge + reach; };
  if (outside(ax, point[0]) || outside(ay, point[1]) || outside(az, point[2]))
  {
    return;
  }
  const int lastZ = az.LastCell(point[2], reach);
  for (int kz = az.FirstCell(point[2], reach); kz <= lastZ; ++kz)
  {
    const double dz = az.DistanceTo(point[2], kz);
    const double reachY = std::sqrt(std::max(reach * reach - dz * dz, 0.0));
    const int lastY = ay.LastCell(point[1], reachY);
    for (int ky = ay.FirstCell(point[1], reachY); ky <= lastY; ++ky)
    {
      const double dy = ay.DistanceTo(point[1], ky);
      const double reachX = std::sqrt(std::max(reach * reach - dz * dz - dy * dy, 0.0));
      const int firstX = ax.FirstCell(point[0], reachX), lastX = ax.LastCell(point[0], reachX);
      if (firstX <= lastX)
      {
        const std::size_t begin = this->CellBegin[this->CellNumber(firstX, ky, kz)];
        const std::size_t end = this->CellBegin[this->CellNumber(lastX, ky, kz) + 1];
        if (begin < end)
        {
          ranges.push_back({ begin, end, point[0], point[1], point[2] });
        }
      }
    }
  }
}
}
