// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/LatticePoints.h"

#include "ruc/Base/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// In units of the element size
constexpr double RowsOfPlane = 0.866;
constexpr double CellOfLattice = 1.1547; // whose two points are a size apart
constexpr double Jitter = 0.05;
constexpr double FreeOfEdge = 0.4;  // points on planes
constexpr double FreeOfPlane = 0.5; // points between planes
// The least distances from a surface
constexpr double FreeOnEdge = 0.4, FreeOnPlane = 0.5, FreeBetween = 0.6, FreeInside = 0.5;
constexpr std::uint64_t FirstSequence = 1u << 30;

int PlanesOf(const CellPoint& point)
{
  return point.OnPlane[0] + point.OnPlane[1] + point.OnPlane[2];
}

class Lattice
{
public:
  Lattice(const MeshCell& cell, double size, std::uint32_t seed)
    : Edge(cell.Edge)
    , Size(size)
    , Seed(seed)
  {
    this->Points.push_back({ { 0, 0, 0 }, { true, true, true } });
    for (int axis = 0; axis < 3; ++axis)
    {
      this->AddEdge(axis);
      this->AddPlane(axis);
    }
    this->AddBodyCentred();
  }

  std::vector<CellPoint> Points;

private:
  void AddEdge(int axis)
  {
    const int count = this->CountOf(axis, 1.0);
    CellPoint point;
    point.OnPlane = { axis != 0, axis != 1, axis != 2 };
    for (int n = 1; n < count; ++n)
    {
      point.Place[axis] = this->Edge[axis] * n / count;
      this->Points.push_back(point);
    }
  }

  void AddPlane(int axis)
  {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int columns = this->CountOf(u, 1.0), rows = 2 * this->CountOf(v, 2.0 * RowsOfPlane);
    CellPoint point;
    point.OnPlane[axis] = true;
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        point.Place[u] = this->Edge[u] * (column + 0.5 * (row % 2) + 0.25) / columns;
        point.Place[v] = this->Edge[v] * (row + 0.5) / rows;
        this->AddJittered(point, FreeOfEdge);
      }
    }
  }

  void AddBodyCentred()
  {
    std::array<int, 3> count{};
    for (int axis = 0; axis < 3; ++axis)
    {
      count[axis] = this->CountOf(axis, CellOfLattice);
    }
    CellPoint point;
    for (int n = 0; n < 2 * count[0] * count[1] * count[2]; ++n)
    {
      const std::array<int, 3> at{ n / 2 % count[0], n / 2 / count[0] % count[1],
        n / 2 / count[0] / count[1] };
      for (int axis = 0; axis < 3; ++axis)
      {
        point.Place[axis] = this->Edge[axis] * (at[axis] + 0.25 + 0.5 * (n % 2)) / count[axis];
      }
      this->AddJittered(point, FreeOfPlane);
    }
  }

  int CountOf(int axis, double sizes) const
  {
    return std::max(1, static_cast<int>(std::lround(this->Edge[axis] / (sizes * this->Size))));
  }

  // Displaces the point along the axes whose planes it is not on; those it must be `free` of
  void AddJittered(CellPoint point, double free)
  {
    const Vector3 draw =
      UniformTriple(this->Seed, RandomStream::MeshPoints, FirstSequence + this->Drawn++);
    for (int axis = 0; axis < 3; ++axis)
    {
      double& place = point.Place[axis];
      if (!point.OnPlane[axis])
      {
        place += 2.0 * Jitter * this->Size * (draw[axis] - 0.5);
        if (place < free * this->Size || place > this->Edge[axis] - free * this->Size)
        {
          return;
        }
      }
    }
    this->Points.push_back(point);
  }

  Vector3 Edge;
  double Size;
  std::uint32_t Seed;
  std::uint64_t Drawn = 0;
};

// The points in bins, and the distance of each to the nearest surface, < 0 inside
class SurfaceDistances
{
public:
  SurfaceDistances(const MeshCell& cell, double size, std::vector<CellPoint>& points)
    : Edge(cell.Edge)
    , Points(points)
    , Distance(points.size(), std::numeric_limits<double>::infinity())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Count[axis] = std::max(1, static_cast<int>(cell.Edge[axis] / size));
    }
    this->Bins.resize(static_cast<std::size_t>(this->Count[0]) * this->Count[1] * this->Count[2]);
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      this
        ->BinAt(this->BinOf(0, points[n].Place[0]), this->BinOf(1, points[n].Place[1]),
          this->BinOf(2, points[n].Place[2]))
        .push_back(static_cast<int>(n));
    }
    for (std::size_t i = 0; i < cell.Size(); ++i)
    {
      this->Mark(cell.Centre[i], cell.Radius[i], static_cast<int>(i), size);
    }
  }

  double Of(std::size_t point) const { return this->Distance[point]; }

private:
  int BinOf(int axis, double place) const
  {
    return static_cast<int>(std::floor(place / this->Edge[axis] * this->Count[axis]));
  }

  std::vector<int>& BinAt(int x, int y, int z)
  {
    const auto wrapped = [](int k, int count)
    { return static_cast<std::size_t>((k % count + count) % count); };
    return this->Bins[(wrapped(z, this->Count[2]) * this->Count[1] + wrapped(y, this->Count[1])) *
        this->Count[0] +
      wrapped(x, this->Count[0])];
  }

  void Mark(const Vector3& centre, double radius, int sphere, double size)
  {
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = this->BinOf(axis, centre[axis] - radius - size);
      last[axis] = std::min(
        this->BinOf(axis, centre[axis] + radius + size), first[axis] + this->Count[axis] - 1);
    }
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int x = first[0]; x <= last[0]; ++x)
        {
          for (const int point : this->BinAt(x, y, z))
          {
            this->MarkPoint(point, centre, radius, sphere);
          }
        }
      }
    }
  }

  void MarkPoint(int n, const Vector3& centre, double radius, int sphere)
  {
    CellPoint& point = this->Points[n];
    Vector3 arm{};
    std::array<int, 3> image{};
    for (int axis = 0; axis < 3; ++axis)
    {
      arm[axis] = point.Place[axis] - centre[axis];
      image[axis] = static_cast<int>(std::lround(-arm[axis] / this->Edge[axis]));
      arm[axis] += image[axis] * this->Edge[axis];
    }
    const double distance = Length(arm) - radius;
    if (distance < this->Distance[n])
    {
      this->Distance[n] = distance;
      point.Sphere = sphere;
      point.Image = image;
    }
  }

  Vector3 Edge;
  std::vector<CellPoint>& Points;
  std::vector<double> Distance;
  std::array<int, 3> Count{};
  std::vector<std::vector<int>> Bins;
};
}

std::vector<CellPoint> MakeLatticePoints(
  const MeshCell& cell, double size, const MeshSettings& settings)
{
  std::vector<CellPoint> points = Lattice(cell, size, settings.Seed).Points;
  const SurfaceDistances distances(cell, size, points);
  constexpr double free[] = { FreeBetween, FreeOnPlane, FreeOnEdge, 0.0 };
  std::vector<CellPoint> kept;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    CellPoint& point = points[n];
    if (distances.Of(n) > free[PlanesOf(point)] * size)
    {
      point.Sphere = -1;
      point.Image = {};
      kept.push_back(point);
    }
    else if (distances.Of(n) < -FreeInside * size)
    {
      point.IsInside = true;
      kept.push_back(point);
    }
  }
  return kept;
}
}
