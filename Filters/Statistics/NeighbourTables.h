// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"

class vtkPolyData;
class vtkTable;

/** The outputs of vtkRUCNeighbourStatistics, as its header describes them. */
namespace NeighbourTables
{
/** `own` are the spheres of this rank's share. */
void FillPack(
  const ruc::SpherePack& own, const ruc::NeighbourStatistics& found, vtkPolyData* output);
void FillContacts(const ruc::NeighbourStatistics& found, vtkPolyData* output);
void FillGaps(const ruc::NeighbourStatistics& found, vtkTable* table);
void FillMeans(const ruc::NeighbourStatistics& found, vtkTable* table);
}
