// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/SolverMesh.h"

class vtkUnstructuredGrid;

/** How the output of vtkRUCPeriodicMesh becomes a mesh of the core again. */
namespace MeshInput
{
/** What elements make a region: all particles, those of a mode, or each (vtkRUCSolverDeckWriter).
 */
enum class RegionKind
{
  Phases,
  Modes,
  Particles
};

/**
 * Reads a mesh, with all lengths times a factor. Throws std::invalid_argument that names what is
 * missing, unless there are tetrahedra alone, whole numbers in the arrays of vtkRUCPeriodicMesh,
 * and the box in the field data.
 */
ruc::SolverMesh Read(vtkUnstructuredGrid* grid, RegionKind regions, double lengthFactor);
}
