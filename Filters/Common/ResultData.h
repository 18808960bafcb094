// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PackWindow.h"
#include "RUCCommonModule.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataObject;
class vtkTable;

/** How results become columns of tables and field data. */
namespace PackData RUCCOMMON_EXPORT
{
/**
 * Adds a column whose name the table does not have yet, in a time that does not depend on how many
 * columns there are.
 */
void AddColumn(vtkTable* table, vtkAbstractArray* column);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<double>& values);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<long long>& values);
void AddColumn(vtkTable* table, const std::string& name, const std::vector<std::string>& values);
/** Adds field data, in place of an array of the same name. */
void AddField(vtkDataObject* data, const char* name, const std::vector<double>& values);
void AddField(vtkDataObject* data, const char* name, const std::vector<long long>& values);
void AddField(vtkDataObject* data, const char* name, const std::string& text);
void AddField(vtkDataObject* data, const char* name, const std::vector<std::string>& texts);

/** The name of the field data that gives the reason why an output is empty: a run was refused. */
constexpr const char* RefusalField = "Refusal";

/** Adds the field data `WindowSource`, `LengthUnit` and `PluginVersion`. */
void AddOrigin(vtkDataObject* data, const PackOrigin& origin);

/**
 * Adds the window for filters downstream (AddWindow), unless it is that of the centres' bounds.
 * That one is a fallback for fractions, and no window in which anything was observed.
 */
void AddKnownWindow(vtkDataObject* data, const PackOrigin& origin);

/**
 * Adds field data that tell from what a result was made: the window, what AddOrigin adds,
 * `NumberOfSpheres`, `VolumeFractions` (in the layout of ruc::OnePointProbability) and
 * `OverlapPercent`.
 */
void AddPackSummary(vtkDataObject* data, const PackOrigin& origin, std::int64_t spheres,
  const std::vector<double>& fractions, double overlapPercent);

/**
 * Above this overlap, in percent of the spheres' volume, sums over spheres are no longer the
 * probabilities of phases.
 */
constexpr double TolerableOverlap = 0.01;
/**
 * Above this overlap, in percent of the spheres' volume, the radii are most likely not what they
 * should be. Packs of simulations and images overlap by up to 0.2 %, and by 2 to 6 % if all their
 * radii are 5 to 10 % too large. If diameters are taken as radii, a dense pack overlaps by 170 %
 * and more; a random one whose spheres truly take the fraction c of the window overlaps by about
 * 210 c %, which is 10 % at c = 0.05.
 */
constexpr double MostOverlap = 10.0;

/** Adds the lags r_0 to r_K as column `r`. */
void AddLags(vtkTable* table, const ruc::LagGrid& lags);
/** The name of a pair's column, such as "S_1_2". */
std::string PairName(const ruc::TwoPointProbability& probability, int r, int s);
}
