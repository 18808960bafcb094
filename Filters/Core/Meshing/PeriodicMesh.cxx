// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/PeriodicMesh.h"

#include "ruc/Base/Text.h"
#include "ruc/Meshing/LatticePoints.h"
#include "ruc/Meshing/MeshImprovement.h"
#include "ruc/Meshing/MeshPoints.h"
#include "ruc/Meshing/SurfacePoints.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ruc
{
namespace
{
// Where four points of a face of the box lie on one circle, both faces may be divided differently;
// with other random numbers they do not
constexpr int Attempts = 8;
constexpr std::uint32_t SeedOfAttempt = 1000003;

// Fitted to meshes of 50 to 1082 beads with sizes from 0.1 to 1 radii, with their improvement
constexpr double PointsOfSize = 1.3; // in a cube of the element size
constexpr double PointsOfSphere = 40.0;
constexpr double SecondsOfPoint = 3e-5;
constexpr double BytesOfPoint = 1200.0; // with the arrays of the output

std::vector<Tetrahedron> Tessellate(
  const std::vector<int>& chosen, const std::vector<GridPoint>& points)
{
  std::vector<GridPoint> places;
  places.reserve(chosen.size());
  for (const int point : chosen)
  {
    places.push_back(points[point]);
  }
  std::vector<Tetrahedron> cells = DelaunayTetrahedra(places);
  for (Tetrahedron& cell : cells)
  {
    for (int& corner : cell)
    {
      corner = chosen[corner];
    }
  }
  return cells;
}

void AddMatrix(const MeshPoints& points, const std::vector<GridPoint>& grid, PeriodicMesh& mesh)
{
  std::vector<int> chosen;
  for (int point = 0; point < static_cast<int>(grid.size()); ++point)
  {
    if (!points.IsInside(point))
    {
      chosen.push_back(point);
    }
  }
  for (const Tetrahedron& cell : Tessellate(chosen, grid))
  {
    const int part = points.PartOf(cell[0]);
    const bool isInPart = part >= 0 &&
      std::all_of(
        cell.begin(), cell.end(), [&](int corner) { return points.PartOf(corner) == part; });
    if (!isInPart)
    {
      mesh.Cells.push_back(cell);
      mesh.Particle.push_back(-1);
    }
  }
}

void AddParticles(const MeshPoints& points, const std::vector<GridPoint>& grid, PeriodicMesh& mesh)
{
  const std::vector<MeshPoints::Part>& parts = points.Parts();
  std::vector<std::vector<Tetrahedron>> cells(parts.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t n = 0; n < parts.size(); ++n)
  {
    std::vector<int> chosen = parts[n].OnSurface;
    chosen.insert(chosen.end(), parts[n].Inside.begin(), parts[n].Inside.end());
    cells[n] = Tessellate(chosen, grid);
  }
  for (std::size_t n = 0; n < parts.size(); ++n)
  {
    mesh.Cells.insert(mesh.Cells.end(), cells[n].begin(), cells[n].end());
    mesh.Particle.resize(mesh.Cells.size(), parts[n].Sphere);
  }
}

// The mesh of points whose random part is that of the attempt
PeriodicMesh MeshShiftedCell(
  const MeshCell& cell, double size, int attempt, const MeshSettings& settings)
{
  MeshSettings ofAttempt = settings;
  ofAttempt.Seed += attempt * SeedOfAttempt;
  std::vector<CellPoint> cellPoints = MakeSurfacePoints(cell, size, ofAttempt);
  const std::vector<CellPoint> lattice = MakeLatticePoints(cell, size, ofAttempt);
  cellPoints.insert(cellPoints.end(), lattice.begin(), lattice.end());
  MeshPoints points(cell, cellPoints);
  points.AddMiddles();

  PeriodicMesh mesh;
  points.Fill(mesh);
  mesh.ElementSize = size;
  const std::vector<GridPoint> grid = RoundToGrid(mesh.Points, { 0, 0, 0 }, mesh.Edge);
  AddMatrix(points, grid, mesh);
  AddParticles(points, grid, mesh);
  ImproveMesh(mesh, settings.ImprovementRounds, ofAttempt.Seed);
  return mesh;
}
}

double PeriodicMesh::VolumeOf(std::size_t cell) const
{
  const Vector3& origin = this->Points[this->Cells[cell][0]];
  Vector3 edge[3];
  for (int k = 0; k < 3; ++k)
  {
    const Vector3& corner = this->Points[this->Cells[cell][k + 1]];
    edge[k] = { corner[0] - origin[0], corner[1] - origin[1], corner[2] - origin[2] };
  }
  return Dot(Cross(edge[0], edge[1]), edge[2]) / 6.0;
}

PeriodicMesh MakePeriodicMesh(
  const SpherePack& pack, const Window& window, const MeshSettings& settings)
{
  if (window.GetShape() != Window::Shape::Box || !window.IsFullyPeriodic())
  {
    throw std::invalid_argument(
      "Periodic Mesh requires a box that is periodic along three axes, got a " + window.Describe() +
      ".");
  }
  const double size = FindElementSize(pack, window, settings);
  const CellGaps gaps = CheckGaps(pack, window, settings);
  const ShiftedCell shifted = ShiftCell(pack, window, settings);
  std::string fault;
  for (int attempt = 0; attempt < Attempts; ++attempt)
  {
    PeriodicMesh mesh = MeshShiftedCell(shifted.Cell, size, attempt, settings);
    mesh.Shift = shifted.Shift;
    mesh.Margin = shifted.Margin;
    mesh.Gaps = gaps;
    fault = FindFault(mesh);
    if (fault.empty())
    {
      return mesh;
    }
  }
  throw std::invalid_argument(
    Text("Periodic Mesh requires another Seed or ElementSize, got no mesh in ", Attempts,
      " attempts: ", fault, "."));
}

Estimate EstimatePeriodicMesh(const PackFigures& pack, const MeshSettings& settings)
{
  const double size = settings.ElementSize == 0.0
    ? std::min(0.5 * pack.MeanRadius, 0.5 * pack.Observed.ShortestEdge())
    : settings.ElementSize;
  const double points =
    PointsOfSize * pack.Observed.Volume() / (size * size * size) + PointsOfSphere * pack.Spheres;
  Estimate estimate;
  estimate.Seconds = points * SecondsOfPoint;
  estimate.MegabytesOfRank = points * BytesOfPoint / BytesOfMegabyte;
  if (settings.ElementSize == 0.0)
  {
    estimate.Automatic = Text("Element Size ", size);
  }
  return estimate;
}
}
