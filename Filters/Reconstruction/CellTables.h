// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CellSearch.h"

#include <string>
#include <vector>

class vtkInformationVector;

/** The outputs of a reconstruction: cells as packs, and tables about them. */
namespace CellTables
{
enum Ports
{
  CELL = 0,
  CONVERGENCE = 1,
  PROBABILITIES = 2,
  ALL_CELLS = 3,
  TABLE_OF_CELLS = 4,
  COMPARISON = 5,
  NUMBER_OF_PORTS = 6
};

/** What was found, and what was looked for. */
struct Reconstruction
{
  const std::vector<CellSearch::FoundCell>& Cells; // at least one
  const ruc::CellContents& Contents;
  const ruc::TwoPointProbability& Target;
  const CellSearch::Settings& Settings;
  double Floor; // the F2 between the pack and its medium, or NaN where it is not known
  std::string LengthUnit;
};

/**
 * Fills the outputs of vtkRUCUnitCellReconstruction, which describes them: data on rank 0 alone,
 * field data and the names of blocks on every rank.
 */
void FillOutputs(
  const Reconstruction& reconstruction, vtkInformationVector* outputs, bool isFirstRank);
}
