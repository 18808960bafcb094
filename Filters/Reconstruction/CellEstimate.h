// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CellProperties.h"
#include "CellSearch.h"
#include "ruc/Particles/PackFigures.h"

class vtkTable;

/**
 * What a reconstruction takes at most, to its last iteration or generation, and what its automatic
 * properties stand for. `longestSearch` is a limit of the search alone, in seconds of one core.
 * Throws std::invalid_argument where the input or the properties do not tell.
 */
namespace CellEstimate
{
ruc::Estimate OfPack(const ruc::PackFigures& pack, const CellProperties& properties,
  const CellSearch::Settings& search, double longestSearch);
ruc::Estimate OfTable(vtkTable* table, const CellProperties& properties,
  const CellSearch::Settings& search, double longestSearch);
}
