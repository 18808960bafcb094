// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PackData.h"
#include "RUCCommonModule.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Reconstruction/CellObjective.h"

#include <optional>
#include <vector>

/**
 * What one rank knows about its input without asking the others, in the form that estimates take.
 */
namespace PackEstimate RUCCOMMON_EXPORT
{
/**
 * Returns the figures of a pack with `Mode`, or none where the pack is not known. `spheres` is the
 * number on all ranks; 0 means that of `piece` on one rank, and on several ranks the field data
 * `NumberOfSpheres` of `piece`. The sizes and, where there is no window, the density are those of
 * `piece`. Throws std::invalid_argument for a window that a run would refuse.
 */
std::optional<ruc::PackFigures> FindFigures(
  vtkPointSet* piece, const PackData::WindowProperties& properties, double spheres, int ranks);

/**
 * Returns the number of spheres on all ranks: `told` if that is above 0, otherwise as FindFigures
 * finds it.
 */
std::optional<double> FindSpheres(vtkPointSet* piece, double told, int ranks);

/**
 * Returns a cell like those of a table of S_rs with spheres of these diameters, still without a
 * number of spheres, and the table's lags; or none where the table does not tell. Throws
 * std::invalid_argument for diameters that do not belong to its modes.
 */
std::optional<ruc::CellFigures> FindCellFigures(
  vtkTable* table, const std::vector<double>& diameters, ruc::LagGrid& lags);

/** Returns the number of threads of all ranks together. */
double Cores(int ranks);
}
