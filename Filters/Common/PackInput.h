// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <string>

class RankCommunicator;
class vtkInformation;

/**
 * Takes packs in: whatever the input is made of, every filter gets one point set on each rank.
 *
 * - A composite data set (multiblock, partitioned, grouped) is one pack: the points of all blocks,
 *   with the arrays that all blocks with points have, and the field data of the blocks and of the
 *   data sets that hold them. Blocks must agree on the window and the unit of length.
 * - Points that `vtkGhostType` marks as duplicate or hidden are no spheres and are left out.
 * - A table, with `withTables`, has its points in the columns whose names
 *   ruc::FindNamedColumns takes for x, y and z; all columns become arrays.
 */
namespace PackInput RUCCOMMON_EXPORT
{
/**
 * Lets a port take point sets and composite data sets of them, and whatever else there is, which
 * Find refuses. The pipeline then makes one request for all blocks instead of one for each. The
 * port lets several inputs in, so that the filter can say that it takes only one
 * (vtkRUCParallelAlgorithm::RequireOne).
 */
void Accept(vtkInformation* portInformation);

/**
 * Returns this rank's points of an input, or null if there is none. Throws std::invalid_argument if
 * a block is no point set, if blocks do not agree, and if a table has no such columns.
 */
vtkSmartPointer<vtkPointSet> FindHere(vtkDataObject* input, bool withTables = false);

/** The same, but throws on all ranks if it throws on one. Collective. */
vtkSmartPointer<vtkPointSet> Find(
  vtkDataObject* input, RankCommunicator& ranks, bool withTables = false);

/**
 * Tells of a table which of several columns that may be a coordinate is taken; an empty text if no
 * two may be the same, or if the input is no table.
 */
std::string TellTaken(vtkDataObject* input);
}
