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
  return static_cast<int>(std::clamp((c - this->Origin) / this->Width, 0.0, this->Count - 1.0));
}

// The reach may be so many cells of a narrow pack that their number does not fit an int, hence the
// clamps
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

std::size_t CellList::Grid::CellNumber(int cx, int cy, int cz) const
{
  return (std::size_t(cz) * this->Axes[1].Count + cy) * this->Axes[0].Count + cx;
}

double CellList::Grid::MostCells(double reach) const
{
  double cells = 1.0;
  for (const Axis& axis : this->Axes)
  {
    const double span = 2.0 * std::ceil(reach / axis.Width) + 1.0;
    cells *= axis.Periodic ? span : std::min(span, double(axis.Count));
  }
  return cells;
}

std::size_t CellList::Grid::FullestCell() const
{
  std::size_t fullest = 0;
  for (std::size_t c = 0; c + 1 < this->CellBegin.size(); ++c)
  {
    fullest = std::max(fullest, this->CellBegin[c + 1] - this->CellBegin[c]);
  }
  return fullest;
}

CellList::CellList(const SpherePack& pack, const Window& window, double cutoff)
  : CellList(pack, window, SizeClasses(cutoff))
{
}

CellList::CellList(const SpherePack& pack, const Window& window, const SizeClasses& classes)
  : Classes(classes)
{
  std::vector<std::vector<std::uint32_t>> members(classes.Count());
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    members[classes.Count() == 1 ? 0 : classes.ClassOf(pack.Radius[i])].push_back(
      static_cast<std::uint32_t>(i));
  }
  this->X.reserve(pack.Size());
  this->Y.reserve(pack.Size());
  this->Z.reserve(pack.Size());
  this->Index.reserve(pack.Size());
  for (int c = 0; c < classes.Count(); ++c)
  {
    this->Grids.push_back(this->MakeGrid(pack, members[c], window, classes.Reach(c, c)));
    this->Sort(pack, members[c], this->Grids.back());
  }
}

CellList::Grid CellList::MakeGrid(const SpherePack& pack, const std::vector<std::uint32_t>& members,
  const Window& window, double reach) const
{
  Grid grid;
  const std::vector<double>* centres[3] = { &pack.X, &pack.Y, &pack.Z };
  for (int q = 0; q < 3; ++q)
  {
    Axis& axis = grid.Axes[q];
    axis.Periodic = window.Periodic[q];
    if (axis.Periodic)
    {
      axis.Origin = window.Origin[q];
      axis.Edge = window.Size[q];
      continue;
    }
    const auto less = [&](std::uint32_t i, std::uint32_t j)
    { return (*centres[q])[i] < (*centres[q])[j]; };
    const auto [low, high] = std::minmax_element(members.begin(), members.end(), less);
    axis.Origin = members.empty() ? 0.0 : (*centres[q])[*low];
    axis.Edge =
      std::max(members.empty() ? 0.0 : (*centres[q])[*high] - (*centres[q])[*low], 1e-6 * reach);
  }

  // A row of cells along x is one range, so rows are thick, to be few and long, and their cells
  // short, to fit the sphere of the reach. Fewer than one centre a cell make the walk over cells
  // dearer than the distances it saves.
  constexpr double rowsPerReach = 2.0;
  constexpr double cellsPerRowWidth = 4.0;
  const double volume = grid.Axes[0].Edge * grid.Axes[1].Edge * grid.Axes[2].Edge;
  double width = std::max(reach / rowsPerReach,
    std::cbrt(cellsPerRowWidth * volume / std::max<std::size_t>(members.size(), 1)));
  const auto cells = [&]()
  {
    double product = 1.0;
    for (Axis& axis : grid.Axes)
    {
      const double length = &axis == grid.Axes ? width / cellsPerRowWidth : width;
      axis.Count = static_cast<int>(std::clamp(axis.Edge / length, 1.0, 1e6));
      axis.Width = axis.Edge / axis.Count;
      product *= axis.Count;
    }
    return product;
  };
  while (cells() > 2.0 * members.size() + 27.0)
  {
    width *= 1.25;
  }
  return grid;
}

// A counting sort by cell, in which the order of the pack stays within a cell
void CellList::Sort(const SpherePack& pack, const std::vector<std::uint32_t>& members, Grid& grid)
{
  std::vector<std::size_t> cellOf;
  cellOf.reserve(members.size());
  grid.First = this->X.size();
  grid.CellBegin.assign(
    std::size_t(grid.Axes[0].Count) * grid.Axes[1].Count * grid.Axes[2].Count + 1, 0);
  for (std::uint32_t i : members)
  {
    cellOf.push_back(grid.CellNumber(grid.Axes[0].CellOf(pack.X[i]), grid.Axes[1].CellOf(pack.Y[i]),
      grid.Axes[2].CellOf(pack.Z[i])));
    ++grid.CellBegin[cellOf.back() + 1];
  }
  grid.CellBegin.front() = grid.First;
  std::partial_sum(grid.CellBegin.begin(), grid.CellBegin.end(), grid.CellBegin.begin());
  std::vector<std::size_t> next(grid.CellBegin.begin(), grid.CellBegin.end() - 1);
  const std::size_t size = grid.First + members.size();
  this->X.resize(size);
  this->Y.resize(size);
  this->Z.resize(size);
  this->Index.resize(size);
  for (std::size_t n = 0; n < members.size(); ++n)
  {
    const std::uint32_t i = members[n];
    const std::size_t place = next[cellOf[n]]++;
    this->X[place] = pack.X[i];
    this->Y[place] = pack.Y[i];
    this->Z[place] = pack.Z[i];
    this->Index[place] = i;
  }
}

int CellList::ClassOf(std::size_t i) const
{
  int c = static_cast<int>(this->Grids.size()) - 1;
  while (i < this->Grids[c].First)
  {
    --c;
  }
  return c;
}

std::int64_t CellList::MostNeighbours() const
{
  double most = 0.0;
  for (int c = 0; c < this->Classes.Count(); ++c)
  {
    double neighbours = 0.0;
    for (int d = 0; d < this->Classes.Count(); ++d)
    {
      neighbours +=
        this->Grids[d].MostCells(this->Classes.Reach(c, d)) * this->Grids[d].FullestCell();
    }
    most = std::max(most, neighbours);
  }
  return static_cast<std::int64_t>(std::ceil(most));
}

void CellList::FindRanges(std::size_t i, std::vector<Range>& ranges) const
{
  ranges.clear();
  const int own = this->ClassOf(i);
  const Vector3 point = { this->X[i], this->Y[i], this->Z[i] };
  AppendRanges(this->Grids[own], point, this->Classes.Reach(own, own), true, i, ranges);
  // A pair of two classes is found from its larger sphere
  for (int smaller = own + 1; smaller < this->Classes.Count(); ++smaller)
  {
    AppendRanges(this->Grids[smaller], point, this->Classes.Reach(own, smaller), false, 0, ranges);
  }
}

void CellList::FindRangesAround(
  const Vector3& point, int sizeClass, std::vector<Range>& ranges) const
{
  ranges.clear();
  for (int c = 0; c < this->Classes.Count(); ++c)
  {
    AppendRanges(this->Grids[c], point, this->Classes.Reach(sizeClass, c), false, 0, ranges);
  }
}

void CellList::AppendRanges(const Grid& grid, const Vector3& point, double reach, bool half,
  std::size_t after, std::vector<Range>& ranges)
{
  const Axis &ax = grid.Axes[0], &ay = grid.Axes[1], &az = grid.Axes[2];
  // Centres were put into cells with rounding; the slack keeps a pair at exactly the reach from
  // being missed. It is bounded, since a centre far out would lead it through images without end
  // along the periodic axes.
  const double slack = 1e-12 * (reach + ax.Edge + ay.Edge + az.Edge);
  const double ball = reach + std::min(slack, reach);
  const double x = point[0], y = point[1], z = point[2];
  const int cx = ax.CellOf(x), cy = ay.CellOf(y), cz = az.CellOf(z);

  // Half of the neighbourhood: the layers above, the rows behind in the own layer, and what follows
  // in the own row
  const int lastZ = az.LastCell(z, ball);
  for (int kz = half ? cz : az.FirstCell(z, ball); kz <= lastZ; ++kz)
  {
    const bool ownLayer = half && kz == cz;
    const double dz = ownLayer ? 0.0 : az.DistanceTo(z, kz);
    const double ballY = std::sqrt(std::max(ball * ball - dz * dz, 0.0));
    const int lastY = ay.LastCell(y, ballY);
    const int imageZ = az.ImageOf(kz);
    for (int ky = ownLayer ? cy : ay.FirstCell(y, ballY); ky <= lastY; ++ky)
    {
      const bool ownRow = ownLayer && ky == cy;
      const double dy = ownRow ? 0.0 : ay.DistanceTo(y, ky);
      const double ballX = std::sqrt(std::max(ball * ball - dz * dz - dy * dy, 0.0));
      const int lastX = ax.LastCell(x, ballX);
      const int imageY = ay.ImageOf(ky);
      const std::size_t row = grid.CellNumber(0, ky - imageY * ay.Count, kz - imageZ * az.Count);
      // A row of cells is one stretch of sorted places, as far as it lies in one image of the box
      for (int kx = ownRow ? cx : ax.FirstCell(x, ballX); kx <= lastX;)
      {
        const int imageX = ax.ImageOf(kx);
        const int end = std::min(lastX + 1, (imageX + 1) * ax.Count);
        const std::size_t begin =
          ownRow && kx == cx ? after + 1 : grid.CellBegin[row + (kx - imageX * ax.Count)];
        const std::size_t stop = grid.CellBegin[row + (end - imageX * ax.Count)];
        if (begin < stop)
        {
          ranges.push_back({ begin, stop, x - imageX * ax.Edge, y - imageY * ay.Edge,
            z - imageZ * az.Edge, reach });
        }
        kx = end;
      }
    }
  }
}
}
