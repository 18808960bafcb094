// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/MeshImprovement.h"

#include "ruc/Base/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ruc
{
namespace
{
constexpr double GoodShape = 0.31;     // the sine of 162 degrees
constexpr double WorthOfMove = 1.01;   // less gain is none
constexpr double ReachOnSurface = 1.0; // of the shortest edge
constexpr double WorthOfRound = 0.95;
constexpr int DirectionsOfMove = 12;
constexpr double StepsOfMove[] = { 0.3, 0.1, 0.03 }; // of the shortest edge
constexpr double BestShape = 1.0;

Vector3 Minus(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

class Improver
{
public:
  Improver(PeriodicMesh& mesh, std::uint32_t seed)
    : Mesh(mesh)
    , Seed(seed)
    , CellsOf(mesh.Points.size())
    , Copies(mesh.Points.size())
    , Shape(mesh.Cells.size())
    , Start(mesh.Points)
    , Reach(mesh.Points.size())
  {
    for (std::size_t n = 0; n < mesh.Points.size(); ++n)
    {
      this->Copies[mesh.PeriodicOf[n]].push_back(static_cast<int>(n));
    }
    for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      this->Shape[cell] = this->ShapeNow(static_cast<int>(cell));
      for (const int corner : mesh.Cells[cell])
      {
        this->CellsOf[corner].push_back(static_cast<int>(cell));
      }
    }
    for (std::size_t n = 0; n < mesh.Points.size(); ++n)
    {
      this->Reach[n] = ReachOnSurface * this->ShortestEdge(static_cast<int>(n));
    }
  }

  /** Returns how many tetrahedra there were to improve. */
  std::size_t Round(int round)
  {
    std::vector<std::pair<double, int>> bad;
    for (std::size_t cell = 0; cell < this->Shape.size(); ++cell)
    {
      if (this->Shape[cell] < GoodShape)
      {
        bad.emplace_back(this->Shape[cell], static_cast<int>(cell));
      }
    }
    std::sort(bad.begin(), bad.end());
    RandomSequence draw(this->Seed, RandomStream::MeshImprovement, round);
    for (const auto& [shape, cell] : bad)
    {
      this->MoveCorners(cell, draw);
    }
    return bad.size();
  }

private:
  const Vector3& At(int point) const { return this->Mesh.Points[point]; }

  double ShapeNow(int cell) const
  {
    const Tetrahedron& c = this->Mesh.Cells[cell];
    return ShapeOf(this->At(c[0]), this->At(c[1]), this->At(c[2]), this->At(c[3]));
  }

  void MoveCorners(int cell, RandomSequence& draw)
  {
    for (const int corner : this->Mesh.Cells[cell])
    {
      if (this->Shape[cell] < GoodShape)
      {
        this->Move(this->Mesh.PeriodicOf[corner], draw);
      }
    }
  }

  double ShortestEdge(int point) const
  {
    double square = std::numeric_limits<double>::infinity();
    for (const int cell : this->CellsOf[point])
    {
      for (const int corner : this->Mesh.Cells[cell])
      {
        const Vector3 arm = Minus(this->At(corner), this->At(point));
        square = corner == point ? square : std::min(square, Dot(arm, arm));
      }
    }
    return std::sqrt(square);
  }

  // Whether a point of a surface is not so far from where it began that facets would get coarse
  bool IsNear(int base) const
  {
    return this->Mesh.Surface[base] < 0 ||
      Length(Minus(this->At(base), this->Start[base])) <= this->Reach[base];
  }

  // Puts a point, and its copies, where its sphere and its planes let it be
  void Place(int base, Vector3 place);
  // The worst shape around a point and its copies; sets the shapes as they are now if wanted
  double WorstAround(int base, bool keep);
  void Move(int base, RandomSequence& draw);

  PeriodicMesh& Mesh;
  std::uint32_t Seed;
  std::vector<std::vector<int>> CellsOf; // of each point
  std::vector<std::vector<int>> Copies;  // of each point that is no copy, itself included
  std::vector<double> Shape;             // of each tetrahedron
  std::vector<Vector3> Start;            // where each point was
  std::vector<double> Reach;             // how far from there it may be on a surface
};

void Improver::Place(int base, Vector3 place)
{
  const std::uint8_t faces = this->Mesh.Boundary[base];
  const int part = this->Mesh.Surface[base];
  double square = 0.0, radius2 = 0.0;
  Vector3 centre{};
  if (part >= 0)
  {
    centre = this->Mesh.PartCentre[part];
    radius2 = this->Mesh.PartRadius[part] * this->Mesh.PartRadius[part];
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (faces >> (2 * axis) & 3)
    {
      place[axis] = 0.0;
      radius2 -= centre[axis] * centre[axis];
    }
    else
    {
      square += (place[axis] - centre[axis]) * (place[axis] - centre[axis]);
    }
  }
  const double scale = part < 0 ? 1.0 : std::sqrt(radius2 / square);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (part >= 0 && !(faces >> (2 * axis) & 3))
    {
      place[axis] = centre[axis] + scale * (place[axis] - centre[axis]);
    }
  }
  for (const int copy : this->Copies[base])
  {
    Vector3& own = this->Mesh.Points[copy];
    for (int axis = 0; axis < 3; ++axis)
    {
      own[axis] = this->Mesh.Boundary[copy] >> (2 * axis) & 3 ? own[axis] : place[axis];
    }
  }
}

double Improver::WorstAround(int base, bool keep)
{
  double worst = BestShape;
  for (const int copy : this->Copies[base])
  {
    for (const int cell : this->CellsOf[copy])
    {
      const double shape = this->ShapeNow(cell);
      worst = std::min(worst, shape);
      if (keep)
      {
        this->Shape[cell] = shape;
      }
    }
  }
  return worst;
}

void Improver::Move(int base, RandomSequence& draw)
{
  const std::uint8_t faces = this->Mesh.Boundary[base];
  const int planes = ((faces & 3) != 0) + ((faces & 12) != 0) + ((faces & 48) != 0);
  if (planes + (this->Mesh.Surface[base] >= 0) >= 3)
  {
    return;
  }
  double worst = this->WorstAround(base, false);
  Vector3 best = this->At(base);
  const double edge = this->ShortestEdge(base);
  for (const double step : StepsOfMove)
  {
    const Vector3 from = best;
    for (int n = 0; n < DirectionsOfMove; ++n)
    {
      Vector3 place = from;
      for (double& coordinate : place)
      {
        coordinate += 2.0 * step * edge * (draw.Next() - 0.5);
      }
      this->Place(base, place);
      const double shape = this->IsNear(base) ? this->WorstAround(base, false) : worst;
      if (shape > WorthOfMove * worst)
      {
        worst = shape;
        best = this->At(base);
      }
    }
  }
  this->Place(base, best);
  this->WorstAround(base, true);
}

}

double ShapeOf(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  // The normals of the faces opposite to a, b, c and d, out of the tetrahedron
  const Vector3 ab = Minus(b, a), ac = Minus(c, a), ad = Minus(d, a), bc = Minus(c, b),
                bd = Minus(d, b), cd = Minus(d, c);
  const Vector3 normal[4] = { Cross(bc, bd), Cross(ad, ac), Cross(ab, ad), Cross(ac, ab) };
  const double volume = Dot(Cross(ab, ac), ad);
  if (!(volume > 0.0))
  {
    return -1.0;
  }
  double length[4];
  for (int k = 0; k < 4; ++k)
  {
    length[k] = Length(normal[k]);
  }
  // The edge that two faces have in common; the cross product of their normals is that times volume
  const Vector3* edge[4][4] = { { nullptr, &cd, &bd, &bc }, { nullptr, nullptr, &ad, &ac },
    { nullptr, nullptr, nullptr, &ab }, {} };
  double worst = 1.0;
  for (int k = 0; k < 4; ++k)
  {
    for (int l = k + 1; l < 4; ++l)
    {
      const double sine = volume * Length(*edge[k][l]) / (length[k] * length[l]);
      const bool isAcute = Dot(normal[k], normal[l]) < 0.0;
      worst = std::min(worst, isAcute ? 2.0 * sine : sine);
    }
  }
  return worst;
}

void ImproveMesh(PeriodicMesh& mesh, int rounds, std::uint32_t seed)
{
  Improver improver(mesh, seed);
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round)
  {
    const auto bad = static_cast<double>(improver.Round(round));
    if (bad == 0.0 || (round > 1 && bad > WorthOfRound * before))
    {
      return;
    }
    before = bad;
  }
}
}
