// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CellProperties.h"
#include "CellSearch.h"
#include "ruc/Particles/PackFigures.h"

#include <optional>

class vtkTable;

/**
 * Estimates what a reconstruction takes at most, to its last iteration or generation, and what its
 * automatic properties stand for. `longestSearch` limits the time of the search alone, in seconds
 * of one core. OfTable returns none if the table does not tell. Both throw std::invalid_argument
 * for properties that a run would refuse.
 */
namespace CellEstimate
{
ruc::Estimate OfPack(const ruc::PackFigures& pack, const CellProperties& properties,
  const CellSearch::Settings& search, double longestSearch);
std::optional<ruc::Estimate> OfTable(vtkTable* table, const CellProperties& properties,
  const CellSearch::Settings& search, double longestSearch);

/** Estimates the megabytes that a search for a cell of known contents takes on a rank. */
double MegabytesOf(
  const ruc::CellContents& contents, const ruc::LagGrid& lags, const CellSearch::Settings& search);
}
