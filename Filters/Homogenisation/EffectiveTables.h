// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/EffectiveResult.h"

#include <vector>

class RankCommunicator;
class vtkImageData;
class vtkTable;

/** The outputs of vtkRUCEffectiveProperties, as its header describes them. */
namespace EffectiveTables
{
/** What is known of a pack: bounds as of ruc::BoundPack, and quantities of the solver, if any. */
struct Properties
{
  std::vector<ruc::PropertyBounds> Bounds;
  std::vector<ruc::CellQuantity> Quantities;
};
void FillProperties(ruc::CellProperty property, const Properties& of, vtkTable* table);

void FillConvergence(
  ruc::CellProperty property, const std::vector<ruc::CellRun>& runs, vtkTable* table);

/** Fills this rank's piece of the image, which has its extent, with the fields. Collective. */
void FillFields(
  const ruc::CellGrid& cell, ruc::CellFields fields, vtkImageData* image, RankCommunicator& ranks);
}
