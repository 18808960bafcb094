// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/MeshQuality.h"

#include <cstdint>
#include <vector>

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

/** How a periodic mesh becomes data sets of VTK. */
namespace MeshOutputs
{
/** A mesh, the place of its box, and the mode and the id of each sphere. */
struct PlacedMesh
{
  ruc::PeriodicMesh Mesh;
  ruc::Vector3 Origin{};
  std::vector<int> Mode;
  std::vector<std::int64_t> Id;
};

/** The tetrahedra with `Phase` and `ParticleId`, the points with `Boundary` and `PeriodicOf`. */
void FillTetrahedra(const PlacedMesh& mesh, vtkUnstructuredGrid* output);
/** The triangles between particles and matrix, with `Phase` and `ParticleId`. */
void FillSurfaces(const PlacedMesh& mesh, vtkPolyData* output);
/** The shares of angles in bins of 5 degrees. */
void FillAngles(const std::array<ruc::MeshQuality, 2>& quality, vtkTable* table);
/** A row for each figure, with its value in the matrix and in the particles. */
void FillQuality(const std::array<ruc::MeshQuality, 2>& quality, double volume, vtkTable* table);
}
