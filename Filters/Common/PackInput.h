// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"

#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

class RankCommunicator;
class vtkInformation;

/**
 * The door through which packs come in: whatever the input is made of, every filter gets one point
 * set a rank.
 *
 * - Composite data sets (multiblock, partitioned, grouped) are one pack: the points of all blocks,
 *   with the arrays that all blocks with points have, and the field data of the blocks and of what
 *   holds them. Blocks must agree on window and length unit.
 * - Points that `vtkGhostType` marks as duplicate or hidden are no spheres and are left out.
 */
namespace PackInput RUCCOMMON_EXPORT
{
/** Lets a port take point sets and composite data sets of them, of which the pipeline then makes
 * one request instead of one a block; and several of them, of which the filter then says that it
 * takes one (vtkRUCParallelAlgorithm::RequireOne). */
void Accept(vtkInformation* portInformation);

/** This rank's points of an input, null where there is none. Throws std::invalid_argument where a
 * block is no point set, and where blocks do not agree. */
vtkSmartPointer<vtkPointSet> FindHere(vtkDataObject* input);

/** Collective: the same; throws on all ranks where one does. */
vtkSmartPointer<vtkPointSet> Find(vtkDataObject* input, RankCommunicator& ranks);
}
