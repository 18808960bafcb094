// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <optional>
#include <string>
#include <vector>

class RankCommunicator;
class vtkAbstractArray;
class vtkDataArray;
class vtkDataObject;
class vtkPointSet;
class vtkPolyData;
class vtkTable;

/** Sphere packs and tables as VTK data sets, with the arrays that README names. */
namespace PackData RUCCOMMON_EXPORT
{
/** Where a pack was observed. */
struct PackOrigin
{
  ruc::Window Observed;     // of its centres
  std::string WindowSource; // "Input", "Properties" or "Bounds of the centres"
  std::string LengthUnit;
};

/** A whole pack. */
struct ObservedPack : PackOrigin
{
  ruc::SpherePack Pack;
};

/** A rank's piece of a pack, as the input hands it out. */
struct PackPiece : PackOrigin
{
  ruc::SpherePack Piece;
  std::int64_t NumberOfSpheres = 0; // on all ranks
};

/** A rank's share of a pack. */
struct SharedPack : PackOrigin
{
  ruc::PackShare Share;
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
};

/**
 * Collective: this rank's piece of the pack and the window of the whole: field data of the pack,
 * else the properties, else the bounds of the centres. `Mode` is required and read only
 * `withModes`. Throws std::invalid_argument, the same on every rank, where there are no points,
 * where an array is missing or not of the form required, for numbers out of range, and for centres
 * outside the window unless the properties say to crop.
 */
PackPiece FindPiece(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/** Collective: FindPiece, and every check of ruc::SharePack. No rank sees more than its share. */
SharedPack FindShare(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/**
 * Collective: the whole pack on every rank, however it was spread over them, in canonical order
 * (ruc::SortCanonically), checked by ruc::ValidatePack and ruc::ValidateWindow. `Id` is the
 * input's, or the place in that order. For packs that are small, such as unit cells.
 */
ObservedPack GatherPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/** What this rank alone knows of the window: by its field data, else the properties, else nothing.
 * Throws std::invalid_argument as FindPiece does. */
std::optional<ruc::Window> FindWindowHere(vtkPointSet* input, const WindowProperties& properties);

/** The point array of that name as double, checked: numeric, one component. Null where there are no
 * points. */
vtkDataArray* RequireArray(vtkPointSet* input, const char* name);

/** Collective: the field `LengthUnit` of the lowest rank that has one, or an empty text. */
std::string FindLengthUnit(vtkDataObject* data, RankCommunicator& ranks);

/** Collective: whether any rank's piece has a point array of that name. */
bool HasArray(vtkPointSet* input, const char* name, RankCommunicator& ranks);

/** Points with vertex cells, `Radius`, `Mode` where the pack has modes, and `Id`, where it has none
 * the place in the pack. */
void FillPolyData(const ruc::SpherePack& pack, vtkPolyData* output);

// Columns and field data
/** Adds a column of a name that the table does not have yet, in a time that does not depend on how
 * many columns there are. */
void AddColumn(vtkTable* table, vtkAbstractArray* column);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<double>& values);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<long long>& values);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<std::string>& values);
void AddField(vtkDataObject* data, const char* name, const std::vector<double>& values);
void AddField(vtkDataObject* data, const char* name, const std::vector<long long>& values);
void AddField(vtkDataObject* data, const char* name, const std::string& text);

/** `BoxOrigin`, … or `CylinderBase`, …, in the form that GatherObservedPack reads. */
void AddWindow(vtkDataObject* data, const ruc::Window& window);
/** `WindowSource`, `LengthUnit` and `PluginVersion`. */
void AddOrigin(vtkDataObject* data, const PackOrigin& origin);

/**
 * What made a result of this pack: window and origin, `NumberOfSpheres`, `VolumeFractions` (as
 * ruc::OnePointProbability) and `OverlapPercent`.
 */
void AddPackSummary(vtkDataObject* data, const PackOrigin& origin, std::int64_t spheres,
  const std::vector<double>& fractions, double overlapPercent);

/** Above this overlap, in percent of the spheres' volume, sums over spheres are no longer the
 * probabilities of phases. */
constexpr double TolerableOverlap = 0.01;
/** The end of a sentence that begins with the filter's name. */
std::string OverlapWarning(double percent);

/** The lags 0 to K as column `r`. */
void AddLags(vtkTable* table, const ruc::LagGrid& lags);
/** "S_1_2" */
std::string PairName(const ruc::TwoPointProbability& probability, int r, int s);
}
