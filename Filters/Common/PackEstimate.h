// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PackData.h"
#include "RUCCommonModule.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Reconstruction/CellObjective.h"

#include <optional>
#include <vector>

/** What one rank knows of its input without asking the others, in the form that estimates take. */
namespace PackEstimate RUCCOMMON_EXPORT
{
/**
 * Figures of a pack with `Mode`. `spheres` is how many all ranks have; 0: on one rank those of
 * `piece`, on several its field data `NumberOfSpheres`. Sizes and, where there is no window, the
 * density are those of `piece`. None where the pack is not known; throws std::invalid_argument for
 * a window that a run would refuse.
 */
std::optional<ruc::PackFigures> FindFigures(
  vtkPointSet* piece, const PackData::WindowProperties& properties, double spheres, int ranks);

/** A cell like those of a table of S_rs with spheres of these diameters, still without a number;
 * and the table's lags. None where the table does not tell; throws std::invalid_argument for
 * diameters that do not belong to its modes. */
std::optional<ruc::CellFigures> FindCellFigures(
  vtkTable* table, const std::vector<double>& diameters, ruc::LagGrid& lags);

/** Threads of all ranks. */
double Cores(int ranks);
}
