// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/SurfacePoints.h"

#include "ruc/Base/Random.h"
#include "ruc/Particles/CellList.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// Lengths in units of the local element size, unless they say otherwise
constexpr double LargestOfRadius = 0.75; // the local size, in radii
constexpr double ReachOfContact = 0.3;   // gaps with rings
constexpr double WidthOfContact = 0.6;   // the last ring
constexpr double GrowthOfRings = 1.8;    // from ring to ring
constexpr int PointsOfRing = 7;
constexpr double JitterOfRing = 0.1;   // of the radius: four points of one circle lie in one plane
constexpr double SpacingOfRing = 0.42; // least distance of other points, in radii of the ring
constexpr double FreeOfFixed = 0.62;   // least distance of rings from points of circles
constexpr double FreeOfAny = 1.35;     // that of even points from all others, in those distances
constexpr double FreeOfPlane = 0.45;   // that of even points from planes
constexpr double ShallowCap = 0.9;     // caps of less height have a pole
constexpr double AreaOfPoint = 0.866;  // in size^2
constexpr int LeastPoints = 12;
constexpr int LeastOfCircle = 5;
constexpr std::uint64_t FirstSequence = 1u << 20; // the draws before are those of the shifts

struct Plane
{
  int Axis;
  double Place;
};

class SphereSurface
{
public:
  SphereSurface(const MeshCell& cell, int sphere, double size, RandomSequence draw)
    : Cell(cell)
    , Sphere(sphere)
    , Centre(cell.Centre[sphere])
    , Radius(cell.Radius[sphere])
    , Size(std::min(size, LargestOfRadius * cell.Radius[sphere]))
    , Draw(draw)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double place : { 0.0, cell.Edge[axis] })
      {
        if (std::abs(place - this->Centre[axis]) < this->Radius)
        {
          this->Planes.push_back({ axis, place });
        }
      }
    }
  }

  void AddCuts()
  {
    this->AddCorners();
    for (const Plane& plane : this->Planes)
    {
      this->AddCircle(plane);
    }
    this->AddPoles();
  }

  void AddContact(const NearSphere& near, double size);
  void AddEvenPoints();
  void Append(std::vector<CellPoint>& points) const;

private:
  struct Point
  {
    Vector3 Place;
    std::array<bool, 3> OnPlane;
    double Free; // the least distance of other points
  };

  void Add(const Vector3& place, const std::array<bool, 3>& onPlane, double free)
  {
    this->Points.push_back({ place, onPlane, free });
  }
  void AddCorners();
  void AddCircle(const Plane& plane);
  void AddPoles();
  // Adds a point of a ring unless it is too near to another point or a plane
  void AddFree(const Vector3& place, double free);
  static double Distance(const Vector3& a, const Vector3& b)
  {
    return Length({ a[0] - b[0], a[1] - b[1], a[2] - b[2] });
  }
  Vector3 OnSurface(const Vector3& direction) const
  {
    const double scale = this->Radius / Length(direction);
    return { this->Centre[0] + scale * direction[0], this->Centre[1] + scale * direction[1],
      this->Centre[2] + scale * direction[2] };
  }

  const MeshCell& Cell;
  int Sphere;
  Vector3 Centre;
  double Radius, Size;
  RandomSequence Draw;
  std::vector<Plane> Planes;
  std::vector<Point> Points;
};

void SphereSurface::AddCorners()
{
  for (const Plane& a : this->Planes)
  {
    for (const Plane& b : this->Planes)
    {
      if (b.Axis <= a.Axis)
      {
        continue;
      }
      const double da = a.Place - this->Centre[a.Axis], db = b.Place - this->Centre[b.Axis];
      const double square = this->Radius * this->Radius - da * da - db * db;
      for (int side = -1; square > 0.0 && side <= 1; side += 2)
      {
        Vector3 place = this->Centre;
        place[a.Axis] = a.Place;
        place[b.Axis] = b.Place;
        const int along = 3 - a.Axis - b.Axis;
        place[along] += side * std::sqrt(square);
        std::array<bool, 3> onPlane{};
        onPlane[a.Axis] = onPlane[b.Axis] = true;
        this->Add(place, onPlane, FreeOfFixed * this->Size);
      }
    }
  }
}

void SphereSurface::AddCircle(const Plane& plane)
{
  const int u = (plane.Axis + 1) % 3, v = (plane.Axis + 2) % 3;
  const double height = plane.Place - this->Centre[plane.Axis];
  const double radius = std::sqrt(this->Radius * this->Radius - height * height);
  std::vector<double> angles;
  for (const Point& corner : this->Points)
  {
    if (corner.OnPlane[plane.Axis] && corner.OnPlane[u] + corner.OnPlane[v] == 1 &&
      corner.Place[plane.Axis] == plane.Place)
    {
      angles.push_back(
        std::atan2(corner.Place[v] - this->Centre[v], corner.Place[u] - this->Centre[u]));
    }
  }
  std::sort(angles.begin(), angles.end());
  const bool whole = angles.empty();
  if (whole)
  {
    angles.push_back(2.0 * Pi * this->Draw.Next());
  }
  std::array<bool, 3> onPlane{};
  onPlane[plane.Axis] = true;
  for (std::size_t n = 0; n < angles.size(); ++n)
  {
    const double begin = angles[n];
    const double end = n + 1 < angles.size() ? angles[n + 1] : angles[0] + 2.0 * Pi;
    const int parts = std::max(whole ? LeastOfCircle : 2,
      static_cast<int>(std::lround((end - begin) * radius / this->Size)));
    for (int part = whole ? 0 : 1; part < parts; ++part)
    {
      const double angle = begin + (end - begin) * part / parts;
      Vector3 place = this->Centre;
      place[plane.Axis] = plane.Place;
      place[u] += radius * std::cos(angle);
      place[v] += radius * std::sin(angle);
      this->Add(place, onPlane, FreeOfFixed * this->Size);
    }
  }
}

void SphereSurface::AddPoles()
{
  const auto add = [&](const Vector3& arm)
  {
    const double depth = Length(arm);
    if (depth > 0.0 && depth < this->Radius && this->Radius - depth < ShallowCap * this->Size)
    {
      this->Add(this->OnSurface(arm), {}, FreeOfFixed * this->Size);
    }
  };
  for (std::size_t a = 0; a < this->Planes.size(); ++a)
  {
    Vector3 arm{};
    arm[this->Planes[a].Axis] = this->Planes[a].Place - this->Centre[this->Planes[a].Axis];
    add(arm);
    for (std::size_t b = a + 1; b < this->Planes.size(); ++b)
    {
      Vector3 toEdge = arm;
      toEdge[this->Planes[b].Axis] = this->Planes[b].Place - this->Centre[this->Planes[b].Axis];
      add(toEdge);
    }
  }
}

void SphereSurface::AddFree(const Vector3& place, double free)
{
  for (const Plane& plane : this->Planes)
  {
    if (std::abs(place[plane.Axis] - plane.Place) < 0.25 * free)
    {
      return;
    }
  }
  for (const Point& point : this->Points)
  {
    if (Distance(point.Place, place) < 0.9 * std::min(point.Free, free))
    {
      return;
    }
  }
  this->Add(place, {}, free);
}

void SphereSurface::AddContact(const NearSphere& near, double size)
{
  // Both sides see the same frame, turned by a quarter of the spacing
  const Vector3& u = near.Direction;
  const auto most = std::max_element(
    u.begin(), u.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double sign = *most > 0.0 ? 1.0 : -1.0;
  Vector3 e1 = Cross({ sign * u[0], sign * u[1], sign * u[2] }, { 0.3, 0.5, 0.81 });
  const double length = Length(e1);
  e1 = { e1[0] / length, e1[1] / length, e1[2] / length };
  const Vector3 e2 = Cross({ sign * u[0], sign * u[1], sign * u[2] }, e1);
  const double reduced = 2.0 * this->Radius * near.Radius / (this->Radius + near.Radius);
  double radius = std::max(std::sqrt(reduced * near.Gap), 0.01 * reduced);
  this->AddFree(this->OnSurface(u), 0.45 * radius);
  for (int ring = 0; radius < WidthOfContact * size && radius < 0.9 * this->Radius; ++ring)
  {
    for (int n = 0; n < PointsOfRing; ++n)
    {
      const double angle =
        2.0 * Pi * (n + 0.5 * (ring % 2) + (sign > 0.0 ? 0.25 : 0.0)) / PointsOfRing + 0.011 * ring;
      const double across = radius * (1.0 + JitterOfRing * (this->Draw.Next() - 0.5));
      const double height = std::sqrt(this->Radius * this->Radius - across * across);
      const double a = across * std::cos(angle), b = across * std::sin(angle);
      this->AddFree({ this->Centre[0] + a * e1[0] + b * e2[0] + height * u[0],
                      this->Centre[1] + a * e1[1] + b * e2[1] + height * u[1],
                      this->Centre[2] + a * e1[2] + b * e2[2] + height * u[2] },
        SpacingOfRing * radius);
    }
    radius *= GrowthOfRings;
  }
}

void SphereSurface::AddEvenPoints()
{
  const int count = std::max(LeastPoints,
    static_cast<int>(
      4.0 * Pi * this->Radius * this->Radius / (AreaOfPoint * this->Size * this->Size)));
  // A random rotation (Shoemake, Graphics Gems III, 124 (1992)), applied to the lattice
  const double s = this->Draw.Next(), alpha = 2.0 * Pi * this->Draw.Next(),
               beta = 2.0 * Pi * this->Draw.Next();
  const double x = std::sqrt(1.0 - s) * std::sin(alpha), y = std::sqrt(1.0 - s) * std::cos(alpha),
               z = std::sqrt(s) * std::sin(beta), w = std::sqrt(s) * std::cos(beta);
  const std::size_t fixed = this->Points.size();
  for (int n = 0; n < count; ++n)
  {
    const double height = 1.0 - 2.0 * (n + 0.5) / count;
    const double across = std::sqrt(1.0 - height * height), angle = Pi * (1.0 + std::sqrt(5.0)) * n;
    const Vector3 from{ across * std::cos(angle), across * std::sin(angle), height };
    const Vector3 once = Cross({ x, y, z }, from);
    const Vector3 twice =
      Cross({ x, y, z }, { once[0] + w * from[0], once[1] + w * from[1], once[2] + w * from[2] });
    const Vector3 place = this->OnSurface(
      { from[0] + 2.0 * twice[0], from[1] + 2.0 * twice[1], from[2] + 2.0 * twice[2] });
    bool isFree = true;
    for (const Plane& plane : this->Planes)
    {
      isFree = isFree && std::abs(place[plane.Axis] - plane.Place) > FreeOfPlane * this->Size;
    }
    for (std::size_t k = 0; isFree && k < fixed; ++k)
    {
      isFree = Distance(this->Points[k].Place, place) > FreeOfAny * this->Points[k].Free;
    }
    if (isFree)
    {
      this->Add(place, {}, 0.0);
    }
  }
}

void SphereSurface::Append(std::vector<CellPoint>& points) const
{
  for (const Point& point : this->Points)
  {
    CellPoint made;
    made.Sphere = this->Sphere;
    made.OnPlane = point.OnPlane;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = point.Place[axis], edge = this->Cell.Edge[axis];
      made.Image[axis] = point.OnPlane[axis] ? x > 0.0 : x < 0.0 ? -1 : x >= edge ? 1 : 0;
      made.Place[axis] = point.OnPlane[axis] ? 0.0 : x - made.Image[axis] * edge;
    }
    points.push_back(made);
  }
}
}

std::vector<std::vector<NearSphere>> FindNearSpheres(const MeshCell& cell, double reach)
{
  SpherePack pack;
  pack.Radius = cell.Radius;
  for (const Vector3& centre : cell.Centre)
  {
    pack.X.push_back(centre[0]);
    pack.Y.push_back(centre[1]);
    pack.Z.push_back(centre[2]);
  }
  const Window window = Window::MakeBox({ 0, 0, 0 }, cell.Edge, { true, true, true });
  std::vector<std::vector<NearSphere>> near(cell.Size());
  const CellList cells(pack, window, SizeClasses(pack.Radius, reach, 1.0));
  cells.ForEachPair(
    [&](std::size_t i, std::size_t j, double dx, double dy, double dz, double d2)
    {
      const double distance = std::sqrt(d2), gap = distance - cell.Radius[i] - cell.Radius[j];
      if (gap < reach)
      {
        const Vector3 u{ dx / distance, dy / distance, dz / distance };
        near[i].push_back({ u, gap, cell.Radius[j] });
        near[j].push_back({ { -u[0], -u[1], -u[2] }, gap, cell.Radius[i] });
      }
    });
  // Narrow gaps first: their rings take precedence
  for (std::vector<NearSphere>& of : near)
  {
    std::sort(of.begin(), of.end(),
      [](const NearSphere& a, const NearSphere& b)
      { return std::tie(a.Gap, a.Direction) < std::tie(b.Gap, b.Direction); });
  }
  return near;
}

std::vector<CellPoint> MakeSurfacePoints(
  const MeshCell& cell, double size, const MeshSettings& settings)
{
  const std::vector<std::vector<NearSphere>> near = FindNearSpheres(cell, ReachOfContact * size);
  std::vector<CellPoint> points;
  for (std::size_t i = 0; i < cell.Size(); ++i)
  {
    SphereSurface surface(cell, static_cast<int>(i), size,
      RandomSequence(settings.Seed, RandomStream::MeshPoints, FirstSequence + i));
    surface.AddCuts();
    for (std::size_t n = 0; settings.ContactRings && n < near[i].size(); ++n)
    {
      surface.AddContact(near[i][n], size);
    }
    surface.AddEvenPoints();
    surface.Append(points);
  }
  return points;
}
}
