// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TwoPointProbability.h"
#include "ruc/Statistics/ThirdOrder/NeighbourhoodMultipoles.h"
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"

class vtkTable;

/** The tables of vtkRUCThreePointProbability, whose columns are documented there. */
namespace ThreePointTables
{
void FillLimits(const ruc::ThreePointProbability& probability,
  const ruc::TwoPointProbability& twoPoint, vtkTable* curves, vtkTable* checks);

/** Returns the names of the phases whose parameters are not known, as "matrix, mode 2". */
std::string FillThirdOrder(const ruc::ThreePointProbability& probability, vtkTable* table);

/** Field data on every rank, rows on the first one. */
void FillMultipoles(
  const ruc::NeighbourhoodMultipoles& multipoles, bool isFirstRank, vtkTable* table);
}
