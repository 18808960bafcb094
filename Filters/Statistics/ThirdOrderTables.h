// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

class vtkPolyData;
class vtkTable;

/** The outputs of vtkRUCThirdOrderParameters, as its header describes them. */
namespace ThirdOrderTables
{
void FillParameters(const ruc::ThirdOrderOfSpheres& found, vtkTable* table);
void FillIntegrals(const ruc::ThirdOrderOfSpheres& found, vtkTable* table);
void FillSpectrum(const ruc::ThirdOrderOfSpheres& found, vtkTable* table);
void FillSlabs(const ruc::ThirdOrderOfSpheres& found, vtkTable* table);
/** `own` are the spheres of this rank's share. */
void FillPack(
  const ruc::SpherePack& own, const ruc::ThirdOrderOfSpheres& found, vtkPolyData* output);
}
