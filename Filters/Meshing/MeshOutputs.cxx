// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOutputs.h"

#include "ResultData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace MeshOutputs
{
namespace
{
void AddPoint(const PlacedMesh& mesh, std::size_t n, vtkPoints* points)
{
  const ruc::Vector3& place = mesh.Mesh.Points[n];
  points->InsertNextPoint(
    mesh.Origin[0] + place[0], mesh.Origin[1] + place[1], mesh.Origin[2] + place[2]);
}

// The arrays of cells of which each lies in a particle or in the matrix
class RegionArrays
{
public:
  RegionArrays(const PlacedMesh& mesh, vtkCellData* cells)
    : Mesh(mesh)
  {
    this->Phase->SetName("Phase");
    this->ParticleId->SetName("ParticleId");
    cells->AddArray(this->Phase);
    cells->AddArray(this->ParticleId);
  }

  void Add(int particle)
  {
    this->Phase->InsertNextValue(particle < 0 ? 0 : this->Mesh.Mode[particle]);
    this->ParticleId->InsertNextValue(
      particle < 0 ? 0 : static_cast<vtkIdType>(this->Mesh.Id[particle]));
  }

private:
  const PlacedMesh& Mesh;
  vtkNew<vtkIntArray> Phase;
  vtkNew<vtkIdTypeArray> ParticleId;
};

void AddPointArrays(const ruc::PeriodicMesh& mesh, vtkPointData* points)
{
  vtkNew<vtkUnsignedCharArray> boundary;
  boundary->SetName("Boundary");
  vtkNew<vtkIdTypeArray> periodicOf;
  periodicOf->SetName("PeriodicOf");
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    boundary->InsertNextValue(mesh.Boundary[n]);
    periodicOf->InsertNextValue(mesh.PeriodicOf[n]);
  }
  points->AddArray(boundary);
  points->AddArray(periodicOf);
}
}

void FillTetrahedra(const PlacedMesh& mesh, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t n = 0; n < mesh.Mesh.Points.size(); ++n)
  {
    AddPoint(mesh, n, points);
  }
  vtkNew<vtkCellArray> cells;
  RegionArrays regions(mesh, output->GetCellData());
  for (std::size_t n = 0; n < mesh.Mesh.Cells.size(); ++n)
  {
    const ruc::Tetrahedron& c = mesh.Mesh.Cells[n];
    const vtkIdType corners[4] = { c[0], c[1], c[2], c[3] };
    cells->InsertNextCell(4, corners);
    regions.Add(mesh.Mesh.Particle[n]);
  }
  output->SetPoints(points);
  output->SetCells(VTK_TETRA, cells);
  AddPointArrays(mesh.Mesh, output->GetPointData());
}

void FillSurfaces(const PlacedMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  RegionArrays regions(mesh, output->GetCellData());
  std::vector<vtkIdType> number(mesh.Mesh.Points.size(), -1);
  for (const ruc::SurfaceTriangle& triangle : ruc::FindSurfaces(mesh.Mesh))
  {
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      vtkIdType& own = number[triangle.Corners[k]];
      if (own < 0)
      {
        own = points->GetNumberOfPoints();
        AddPoint(mesh, triangle.Corners[k], points);
      }
      corners[k] = own;
    }
    cells->InsertNextCell(3, corners);
    regions.Add(triangle.Particle);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
}

void FillAngles(const std::array<ruc::MeshQuality, 2>& quality, vtkTable* table)
{
  std::vector<double> middle, share[2];
  constexpr int bins = ruc::MeshQuality::Bins;
  for (int bin = 0; bin < bins; ++bin)
  {
    middle.push_back((bin + 0.5) * 180.0 / bins);
    for (int phase = 0; phase < 2; ++phase)
    {
      const double angles = 6.0 * static_cast<double>(quality[phase].Cells);
      share[phase].push_back(static_cast<double>(quality[phase].Angles[bin]) / angles);
    }
  }
  PackData::AddColumn(table, "Angle", middle);
  PackData::AddColumn(table, "Matrix", share[0]);
  PackData::AddColumn(table, "Particles", share[1]);
}

void FillQuality(const std::array<ruc::MeshQuality, 2>& quality, double volume, vtkTable* table)
{
  std::vector<double> values[2];
  for (int phase = 0; phase < 2; ++phase)
  {
    const ruc::MeshQuality& of = quality[phase];
    values[phase] = { static_cast<double>(of.Cells), of.Volume / volume, of.LeastAngle,
      of.LargestAngle, static_cast<double>(of.Below5), static_cast<double>(of.Above170),
      static_cast<double>(of.Above175) };
  }
  PackData::AddColumn(table, "Quantity",
    std::vector<std::string>{ "tetrahedra", "volume fraction", "least angle", "largest angle",
      "tetrahedra with an angle below 5", "tetrahedra with an angle above 170",
      "tetrahedra with an angle above 175" });
  PackData::AddColumn(table, "Matrix", values[0]);
  PackData::AddColumn(table, "Particles", values[1]);
}
}
