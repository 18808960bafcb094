// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/Delaunay.h"

#include "ruc/Base/Text.h"
#include "ruc/Meshing/SpatialOrder.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace ruc
{
namespace
{
constexpr int Infinite = -1; // the point beyond the hull, a corner of every tetrahedron outside
constexpr int Removed = -2;

// The three corners of the face opposite to each corner, in an order in which the tetrahedron of
// the face and the corner is positive when the corner comes first
constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

class Tessellation
{
public:
  explicit Tessellation(const std::vector<GridPoint>& points)
    : Points(points)
  {
  }

  void Build()
  {
    std::vector<int> order = InsertionOrder(this->Points);
    if (!this->Start(order))
    {
      return;
    }
    for (std::size_t n = 4; n < order.size(); ++n)
    {
      this->Insert(order[n]);
    }
  }

  std::vector<Tetrahedron> Finite() const
  {
    std::vector<Tetrahedron> finite;
    for (const Cell& cell : this->Cells)
    {
      if (cell.Corners[0] != Removed && this->InfiniteCorner(cell) < 0)
      {
        finite.push_back(cell.Corners);
      }
    }
    return finite;
  }

private:
  struct Cell
  {
    Tetrahedron Corners;
    std::array<int, 4> Neighbours; // beyond the face opposite to each corner
    int Visit = 0; // the last insertion that looked at it, < 0 where it was no conflict
  };
  struct BorderFace
  {
    int Outside, FaceOutside;
    std::array<int, 3> Corners;
  };
  struct OpenEdge
  {
    std::int64_t Key = 0;
    int Cell = 0, Face = 0, Visit = 0;
  };

  const GridPoint& At(int point) const { return this->Points[point]; }

  static int InfiniteCorner(const Cell& cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] == Infinite)
      {
        return k;
      }
    }
    return -1;
  }

  // Orientation of a cell with a point in the place of one of its corners
  int OrientationWith(const Cell& cell, int corner, int point) const
  {
    Tetrahedron corners = cell.Corners;
    corners[corner] = point;
    return Orientation(
      this->At(corners[0]), this->At(corners[1]), this->At(corners[2]), this->At(corners[3]));
  }

  bool IsConflict(const Cell& cell, int point) const
  {
    const int infinite = this->InfiniteCorner(cell);
    if (infinite >= 0)
    {
      const int side = this->OrientationWith(cell, infinite, point);
      // In the plane of a face of the hull, the sphere of the tetrahedron below cuts out its circle
      return side > 0 ||
        (side == 0 && this->IsConflict(this->Cells[cell.Neighbours[infinite]], point));
    }
    const Tetrahedron& c = cell.Corners;
    return InSphere(
             this->At(c[0]), this->At(c[1]), this->At(c[2]), this->At(c[3]), this->At(point)) > 0;
  }

  // Moves the first points that span a volume to the front and makes the first five cells; returns
  // false where there are none
  bool Start(std::vector<int>& order);

  // Walks from the last new cell to one that is in conflict with the point
  int Locate(int point) const
  {
    int at = this->Last;
    if (const int infinite = this->InfiniteCorner(this->Cells[at]); infinite >= 0)
    {
      at = this->Cells[at].Neighbours[infinite];
    }
    int from = -1;
    while (true)
    {
      const Cell& cell = this->Cells[at];
      if (this->InfiniteCorner(cell) >= 0)
      {
        return at;
      }
      int next = -1;
      for (int k = 0; k < 4 && next < 0; ++k)
      {
        if (cell.Neighbours[k] != from && this->OrientationWith(cell, k, point) < 0)
        {
          next = cell.Neighbours[k];
        }
      }
      if (next < 0)
      {
        return at;
      }
      from = at;
      at = next;
    }
  }

  void Insert(int point);
  // Finds all cells in conflict with the point and the faces around them
  void FindCavity(int point, int start);
  void AddCell(int point, const BorderFace& face);
  int NewCell();
  // Links the face of a new cell to the other new cell at that edge of the cavity
  void LinkEdge(int cell, int face, int a, int b);

  const std::vector<GridPoint>& Points;
  std::vector<Cell> Cells;
  std::vector<int> Free;
  int Last = 0;
  int Visit = 0;
  std::vector<int> Cavity;
  std::vector<BorderFace> Border;
  std::vector<OpenEdge> Edges = std::vector<OpenEdge>(1024);
};

bool Tessellation::Start(std::vector<int>& order)
{
  const auto bring = [&](std::size_t place, auto&& fits)
  {
    const auto found =
      std::find_if(order.begin() + static_cast<std::ptrdiff_t>(place), order.end(), fits);
    if (found == order.end())
    {
      return false;
    }
    std::rotate(order.begin() + static_cast<std::ptrdiff_t>(place), found, found + 1);
    return true;
  };
  const auto line = [&](int n)
  {
    // On a line where the triangle has no area seen along any axis
    const GridPoint &a = this->At(order[0]), &b = this->At(order[1]), &c = this->At(n);
    for (int axis = 0; axis < 3; ++axis)
    {
      GridPoint apex = a;
      apex[axis] += 1.0;
      if (Orientation(a, b, c, apex) != 0)
      {
        return false;
      }
    }
    return true;
  };
  const auto side = [&](int n)
  { return Orientation(this->At(order[0]), this->At(order[1]), this->At(order[2]), this->At(n)); };
  const bool found = bring(0, [](int) { return true; }) &&
    bring(1, [&](int n) { return this->At(n) != this->At(order[0]); }) &&
    bring(2, [&](int n) { return !line(n); }) && bring(3, [&](int n) { return side(n) != 0; });
  if (!found)
  {
    return false;
  }
  if (side(order[3]) < 0)
  {
    std::swap(order[0], order[1]);
  }
  const Tetrahedron first{ order[0], order[1], order[2], order[3] };
  this->Cells.push_back({ first, { 1, 2, 3, 4 } });
  for (int k = 0; k < 4; ++k)
  {
    // Seen from outside the face turns the other way
    const auto& face = FaceOf[k];
    this->Cells.push_back({ { Infinite, first[face[0]], first[face[2]], first[face[1]] }, {} });
  }
  for (int k = 1; k <= 4; ++k)
  {
    Cell& cell = this->Cells[k];
    cell.Neighbours[0] = 0;
    for (int corner = 1; corner < 4; ++corner)
    {
      const auto opposite = std::find(first.begin(), first.end(), cell.Corners[corner]);
      cell.Neighbours[corner] = 1 + static_cast<int>(opposite - first.begin());
    }
  }
  return true;
}

int Tessellation::NewCell()
{
  if (this->Free.empty())
  {
    this->Cells.emplace_back();
    return static_cast<int>(this->Cells.size()) - 1;
  }
  const int cell = this->Free.back();
  this->Free.pop_back();
  return cell;
}

void Tessellation::FindCavity(int point, int start)
{
  ++this->Visit;
  this->Cavity.assign(1, start);
  this->Border.clear();
  this->Cells[start].Visit = this->Visit;
  for (std::size_t n = 0; n < this->Cavity.size(); ++n)
  {
    const int at = this->Cavity[n];
    for (int k = 0; k < 4; ++k)
    {
      const int next = this->Cells[at].Neighbours[k];
      Cell& cell = this->Cells[next];
      if (cell.Visit == this->Visit)
      {
        continue;
      }
      if (cell.Visit != -this->Visit)
      {
        const bool conflict = this->IsConflict(cell, point);
        cell.Visit = conflict ? this->Visit : -this->Visit;
        if (conflict)
        {
          this->Cavity.push_back(next);
          continue;
        }
      }
      const Tetrahedron& corners = this->Cells[at].Corners;
      const auto& face = FaceOf[k];
      const auto behind = std::find(cell.Neighbours.begin(), cell.Neighbours.end(), at);
      this->Border.push_back({ next, static_cast<int>(behind - cell.Neighbours.begin()),
        { corners[face[0]], corners[face[1]], corners[face[2]] } });
    }
  }
}

void Tessellation::LinkEdge(int cell, int face, int a, int b)
{
  const std::int64_t key =
    (static_cast<std::int64_t>(std::min(a, b)) + 1) << 32 | (std::max(a, b) + 1);
  const std::size_t mask = this->Edges.size() - 1;
  std::size_t place = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15u) >> 40 & mask;
  while (this->Edges[place].Visit == this->Visit && this->Edges[place].Key != key)
  {
    place = (place + 1) & mask;
  }
  OpenEdge& edge = this->Edges[place];
  if (edge.Visit != this->Visit)
  {
    edge = { key, cell, face, this->Visit };
    return;
  }
  this->Cells[cell].Neighbours[face] = edge.Cell;
  this->Cells[edge.Cell].Neighbours[edge.Face] = cell;
}

void Tessellation::AddCell(int point, const BorderFace& face)
{
  const int made = this->NewCell();
  const auto& [a, b, c] = face.Corners;
  this->Cells[made] = { { point, a, b, c }, { face.Outside, -1, -1, -1 } };
  this->Cells[face.Outside].Neighbours[face.FaceOutside] = made;
  this->LinkEdge(made, 1, b, c);
  this->LinkEdge(made, 2, a, c);
  this->LinkEdge(made, 3, a, b);
  this->Last = made;
}

void Tessellation::Insert(int point)
{
  const int start = this->Locate(point);
  for (const int corner : this->Cells[start].Corners)
  {
    if (corner != Infinite && this->At(corner) == this->At(point))
    {
      throw std::invalid_argument(Text("a tessellation requires points of different places, got ",
        std::min(corner, point), " and ", std::max(corner, point), " in one."));
    }
  }
  this->FindCavity(point, start);
  // A border has one and a half times as many edges as faces
  while (this->Edges.size() < 4 * this->Border.size())
  {
    this->Edges.assign(2 * this->Edges.size(), {});
  }
  for (const int cell : this->Cavity)
  {
    this->Cells[cell].Corners[0] = Removed;
    this->Free.push_back(cell);
  }
  for (const BorderFace& face : this->Border)
  {
    this->AddCell(point, face);
  }
}
}

std::vector<Tetrahedron> DelaunayTetrahedra(const std::vector<GridPoint>& points)
{
  Tessellation tessellation(points);
  tessellation.Build();
  return tessellation.Finite();
}
}
