// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Particles/SpherePack.h"

#include <optional>
#include <string>
#include <vector>

class RankCommunicator;
class vtkDataObject;
class vtkPointSet;

/** Windows and units as field data and properties. */
namespace PackData RUCCOMMON_EXPORT
{
/** Where a pack was observed. */
struct PackOrigin
{
  ruc::Window Observed;     // of its centres
  std::string WindowSource; // "Input", "Properties" or "Bounds of the centres"
  std::string LengthUnit;
  /** Sentences about what makes the result another than wanted, the same on all ranks. */
  std::vector<std::string> Warnings;
};

/** What a filter's own properties say of the window; sizes of 0 leave it to the pack. */
struct WindowProperties
{
  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
  double CylinderBase[3] = { 0.0, 0.0, 0.0 };
  double CylinderAxis[3] = { 0.0, 0.0, 1.0 };
  double CylinderRadius = 0.0;
  double CylinderHeight = 0.0;
  bool Crop = false; // leave spheres outside the window out

  bool HasBox() const;
  bool HasCylinder() const;
  bool HasAny() const;
};

/** What this rank alone knows of the window: by its field data, else the properties, else nothing.
 * Throws std::invalid_argument for fields and properties that make no window. */
std::optional<ruc::Window> FindWindowHere(vtkPointSet* input, const WindowProperties& properties);

/**
 * Collective: where the pack was observed, of which this rank has `piece`: by the field data of any
 * rank, else the properties, else the bounds of the centres, with a warning. Throws
 * std::invalid_argument, the same on every rank, where ranks have different windows, and where the
 * bounds have no volume.
 */
PackOrigin FindOrigin(vtkPointSet* input, const WindowProperties& properties,
  const ruc::SpherePack& piece, RankCommunicator& ranks);

/** Collective: the field `LengthUnit` of the lowest rank that has one, or an empty text. */
std::string FindLengthUnit(vtkDataObject* data, RankCommunicator& ranks);

/** `BoxOrigin`, … or `CylinderBase`, …, in the form that FindOrigin reads. */
void AddWindow(vtkDataObject* data, const ruc::Window& window);

/** Whether the blocks of one pack have to agree on a field of this name: the fields of a window,
 * and `LengthUnit`. */
bool IsOfWholePack(const std::string& field);
}
