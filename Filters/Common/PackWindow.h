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

/** Windows and units of length, as field data and as properties. */
namespace PackData RUCCOMMON_EXPORT
{
/** Where a pack was observed, and in what unit. */
struct PackOrigin
{
  ruc::Window Observed;     // the region in which its centres were observed
  std::string WindowSource; // "Input", "Properties" or "Bounds of the centres"
  std::string LengthUnit;
  /** Sentences that warn that the result may not be the one wanted, the same on all ranks. */
  std::vector<std::string> Warnings;
};

/**
 * What the properties of a filter say of the window. Where all sizes are 0, the window is left to
 * the pack.
 */
struct WindowProperties
{
  double BoxOrigin[3] = { 0.0, 0.0, 0.0 };
  double BoxSize[3] = { 0.0, 0.0, 0.0 };
  int BoxPeriodic[3] = { 0, 0, 0 };
  double CylinderBase[3] = { 0.0, 0.0, 0.0 };
  double CylinderAxis[3] = { 0.0, 0.0, 1.0 };
  double CylinderRadius = 0.0;
  double CylinderHeight = 0.0;
  bool Crop = false; // whether spheres with centres outside the window are left out

  /** Returns whether a size of the box is not 0. */
  bool HasBox() const;
  /** Returns whether the radius or the height of the cylinder is not 0. */
  bool HasCylinder() const;
  /** Returns whether the properties set a window. */
  bool HasAny() const;
};

/**
 * Returns the window as this rank alone knows it: by the field data, else by the properties, else
 * nothing. Throws std::invalid_argument for fields and properties that make no window.
 */
std::optional<ruc::Window> FindWindowHere(vtkPointSet* input, const WindowProperties& properties);

/**
 * Returns the window in the field data of any rank, or nothing. Throws std::invalid_argument, the
 * same on every rank, for fields that make no window and if ranks have different windows.
 * Collective.
 */
std::optional<ruc::Window> FindOwnWindow(vtkPointSet* input, RankCommunicator& ranks);

/**
 * Returns where the pack was observed, of which this rank has `piece`: by the field data of any
 * rank, else by the properties, else, with a warning, by the bounds of the centres. Throws
 * std::invalid_argument, the same on every rank, for fields and properties that make no window, if
 * ranks have different windows, and if the bounds have no volume. Collective.
 */
PackOrigin FindOrigin(vtkPointSet* input, const WindowProperties& properties,
  const ruc::SpherePack& piece, RankCommunicator& ranks);

/** Returns the field `LengthUnit` of the lowest rank that has one, or an empty text. Collective. */
std::string FindLengthUnit(vtkDataObject* data, RankCommunicator& ranks);

/**
 * Adds the window as field data, `BoxOrigin`, … or `CylinderBase`, …, in the form that FindOrigin
 * reads.
 */
void AddWindow(vtkDataObject* data, const ruc::Window& window);

/**
 * Returns whether the blocks of one pack must agree on a field of this name: the fields of a
 * window, and `LengthUnit`.
 */
bool IsOfWholePack(const std::string& field);
}
