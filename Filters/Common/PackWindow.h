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

namespace ruc
{
struct FoundWindow;
}

/** Windows and units of length, as field data and as properties. */
namespace PackData RUCCOMMON_EXPORT
{
/** Where a pack was observed, and in what unit. */
struct PackOrigin
{
  ruc::Window Observed; // the region in which its centres were observed
  /**
   * "Input", "Properties", "Bounds of the centres"; or "Cut faces" or "Eroded" for a window that
   * was found by how the pack ends (ruc::FindWindow).
   */
  std::string WindowSource;
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
  bool Crop = false;   // whether spheres with centres outside the window are left out
  bool Masked = false; // whether a mask takes the place of the window

  /** Returns whether a size of the box is not 0. */
  bool HasBox() const;
  /** Returns whether the radius or the height of the cylinder is not 0. */
  bool HasCylinder() const;
  /** Returns whether the properties set a window. */
  bool HasAny() const;
};

/**
 * Returns the window as this rank alone knows it, with the precedence of FindOrigin, or nothing.
 * Throws std::invalid_argument for fields and properties that make no window.
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
 * rank, else by the properties, else, with a warning, by the bounds of the centres. Properties go
 * before field data whose `WindowSource` tells of a window that was found, not given;
 * with a mask such a window is passed over. Throws
 * std::invalid_argument, the same on every rank, for fields and properties that make no window, if
 * ranks have different windows, and if the bounds have no volume. Collective.
 */
PackOrigin FindOrigin(vtkPointSet* input, const WindowProperties& properties,
  const ruc::SpherePack& piece, RankCommunicator& ranks);

/**
 * Returns whether FindOrigin takes a window that was found. The pack may then reach beyond it.
 * Collective.
 */
bool TakesFoundWindow(
  vtkPointSet* input, const WindowProperties& properties, RankCommunicator& ranks);

/** Returns the field `LengthUnit` of the lowest rank that has one, or an empty text. Collective. */
std::string FindLengthUnit(vtkDataObject* data, RankCommunicator& ranks);

/**
 * Adds the window as field data, `BoxOrigin`, … or `CylinderBase`, …, in the form that FindOrigin
 * reads.
 */
void AddWindow(vtkDataObject* data, const ruc::Window& window);

/**
 * Adds a window that was looked for as such field data, if there is one, with `WindowSource`; and
 * `FaceKinds` and `WindowErosion` if faces were looked at.
 */
void AddFoundWindow(vtkDataObject* data, const ruc::FoundWindow& found);

/**
 * Returns whether the blocks of one pack must agree on a field of this name: the fields of a
 * window, and `LengthUnit`.
 */
bool IsOfWholePack(const std::string& field);
}
