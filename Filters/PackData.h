// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/SpherePack.h"
#include "Statistics/TwoPointProbability.h"

#include <string>
#include <vector>

class RankCommunicator;
class vtkDataArray;
class vtkDataObject;
class vtkPointSet;
class vtkPolyData;
class vtkTable;

/** Sphere packs and tables as VTK data sets, with the arrays that README names. */
namespace PackData
{
/** A pack with the window its centres were observed in. */
struct ObservedPack
{
  ruc::SpherePack Pack;
  ruc::Window Observed;
  std::string WindowSource; // "Input", "Properties" or "Bounds of the centres"
  std::string LengthUnit;
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
 * Collective: the whole pack on every rank, however it was spread over them, in canonical order
 * (ruc::SortCanonically). `Mode` is required and read only `withModes`; `Id` is the input's, or the
 * place in that order. Throws std::invalid_argument, the same on every rank, where an array is
 * missing or not of the form required.
 */
ruc::SpherePack GatherPack(vtkPointSet* input, bool withModes, RankCommunicator& ranks);

/**
 * Collective: GatherPack, its window (field data of the pack, else the properties, else the bounds
 * of the centres), and every check that estimators need: ruc::ValidatePack and ruc::ValidateWindow.
 */
ObservedPack GatherObservedPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/** The point array of that name as double, checked: numeric, one component. Null where there are no
 * points. */
vtkDataArray* RequireArray(vtkPointSet* input, const char* name);

/** Collective: whether any rank's piece has a point array of that name. */
bool HasArray(vtkPointSet* input, const char* name, RankCommunicator& ranks);

/** Points with vertex cells, `Radius`, `Mode` where the pack has modes, and `Id`, where it has none
 * the place in the pack. */
void FillPolyData(const ruc::SpherePack& pack, vtkPolyData* output);

// Columns and field data
void AddColumn(vtkTable* table, const std::string& name, const std::vector<double>& values);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<long long>& values);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<std::string>& values);
void AddField(vtkDataObject* data, const char* name, const std::vector<double>& values);
void AddField(vtkDataObject* data, const char* name, const std::vector<long long>& values);
void AddField(vtkDataObject* data, const char* name, const std::string& text);

/** `BoxOrigin`, … or `CylinderBase`, …, in the form that GatherObservedPack reads. */
void AddWindow(vtkDataObject* data, const ruc::Window& window);
/** `WindowSource`, `LengthUnit` and `PluginVersion`. */
void AddOrigin(vtkDataObject* data, const ObservedPack& pack);

/**
 * What made a result of this pack: window and origin, `NumberOfSpheres`, `VolumeFractions` (as
 * ruc::OnePointProbability) and `OverlapPercent`.
 */
void AddPackSummary(vtkDataObject* data, const ObservedPack& pack,
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
