// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshInput.h"

#include "PackData.h"
#include "ruc/Base/Text.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <stdexcept>

namespace MeshInput
{
namespace
{
[[noreturn]] void Refuse(const std::string& what)
{
  throw std::invalid_argument("Input requires the tetrahedra of Periodic Mesh, got " + what + ".");
}

vtkDataArray* Require(vtkFieldData* arrays, const char* name, vtkIdType count)
{
  vtkDataArray* array = PackData::FindArray(arrays, name, count);
  if (!array)
  {
    Refuse(ruc::Text("no array '", name, "'"));
  }
  return array;
}

ruc::Vector3 RequireVector(vtkUnstructuredGrid* grid, const char* name, double factor)
{
  vtkDataArray* array = PackData::FindArray(grid->GetFieldData(), name, 3);
  if (!array)
  {
    Refuse(ruc::Text("no field data '", name, "' of three numbers"));
  }
  return { factor * array->GetTuple1(0), factor * array->GetTuple1(1),
    factor * array->GetTuple1(2) };
}

void ReadPoints(vtkUnstructuredGrid* grid, double factor, ruc::SolverMesh& mesh)
{
  const vtkIdType count = grid->GetNumberOfPoints();
  vtkDataArray* boundary = Require(grid->GetPointData(), "Boundary", count);
  vtkDataArray* periodicOf = Require(grid->GetPointData(), "PeriodicOf", count);
  for (vtkIdType n = 0; n < count; ++n)
  {
    double place[3];
    grid->GetPoint(n, place);
    mesh.Points.push_back({ factor * place[0], factor * place[1], factor * place[2] });
    const double faces = boundary->GetTuple1(n), base = periodicOf->GetTuple1(n);
    if (!(faces >= 0.0 && faces < 64.0 && base >= 0.0 && base < static_cast<double>(count)))
    {
      Refuse(ruc::Text("Boundary ", faces, " and PeriodicOf ", base, " at point ", n));
    }
    mesh.Boundary.push_back(static_cast<std::uint8_t>(faces));
    mesh.PeriodicOf.push_back(static_cast<std::int64_t>(base));
  }
}

std::string NameOfRegion(RegionKind kind, long long number)
{
  return number == 0             ? "MATRIX"
    : kind == RegionKind::Phases ? "PARTICLES"
    : kind == RegionKind::Modes  ? ruc::Text("MODE_", number)
                                 : ruc::Text("PARTICLE_", number);
}

void ReadCells(vtkUnstructuredGrid* grid, RegionKind kind, ruc::SolverMesh& mesh)
{
  const vtkIdType count = grid->GetNumberOfCells();
  vtkDataArray* labels =
    Require(grid->GetCellData(), kind == RegionKind::Particles ? "ParticleId" : "Phase", count);
  std::map<long long, std::vector<vtkIdType>> cellsOf;
  vtkNew<vtkIdList> corners;
  for (vtkIdType n = 0; n < count; ++n)
  {
    if (grid->GetCellType(n) != VTK_TETRA)
    {
      Refuse(ruc::Text("a cell of the type ", grid->GetCellType(n)));
    }
    grid->GetCellPoints(n, corners);
    mesh.Cells.push_back({ static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
      static_cast<int>(corners->GetId(2)), static_cast<int>(corners->GetId(3)) });
    const auto label = static_cast<long long>(labels->GetTuple1(n));
    cellsOf[kind == RegionKind::Phases ? label != 0 : label].push_back(n);
  }
  mesh.Region.resize(mesh.Cells.size());
  for (const auto& [label, cells] : cellsOf)
  {
    for (const vtkIdType cell : cells)
    {
      mesh.Region[cell] = static_cast<int>(mesh.RegionNames.size());
    }
    mesh.RegionNames.push_back(NameOfRegion(kind, label));
  }
}
}

ruc::SolverMesh Read(vtkUnstructuredGrid* grid, RegionKind regions, double lengthFactor)
{
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    Refuse("no cells on rank 0");
  }
  ruc::SolverMesh mesh;
  mesh.Origin = RequireVector(grid, "BoxOrigin", lengthFactor);
  mesh.Edge = RequireVector(grid, "BoxSize", lengthFactor);
  ReadPoints(grid, lengthFactor, mesh);
  ReadCells(grid, regions, mesh);
  return mesh;
}
}
