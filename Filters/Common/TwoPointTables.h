// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Statistics/PairSums/DirectionalProbability.h"
#include "ruc/Statistics/PairSums/RadialDistribution.h"
#include "ruc/Statistics/Results/TwoPointChecks.h"
#include "ruc/Statistics/Sampling/ChordLengths.h"
#include "ruc/Statistics/Sampling/SampledSums.h"

#include <vector>

class vtkTable;

/** The tables of the filters of two-point statistics, whose columns are documented there. */
namespace TwoPointTables RUCCOMMON_EXPORT
{
/** The errors may be empty, as they are for an exact method. */
void FillProbabilities(const ruc::SampledTwoPoint& measured, vtkTable* table);
/**
 * `asymmetry` is that of a sampled method (SampledTwoPoint), and empty for an exact one. Of the
 * errors at zero and the asymmetry, the table has what is not 0 by construction: the errors at zero
 * of an exact method, the asymmetry of a sampled one.
 */
void FillChecks(const ruc::TwoPointProbability& probability,
  const std::vector<ruc::TwoPointCheck>& checks, const std::vector<double>& asymmetry,
  vtkTable* table);
void FillGradients(const ruc::TwoPointProbability& probability, vtkTable* table);
void FillIsotropy(const ruc::DirectionalProbability& directional, vtkTable* table);
void FillDirections(const ruc::DirectionalProbability& directional, vtkTable* table);
void FillChordLengths(const ruc::ChordLengths& chords, vtkTable* table);
void FillRadialDistribution(const ruc::RadialDistribution& distribution, vtkTable* table);
void FillAutocovariance(const ruc::TwoPointProbability& probability, vtkTable* table);
}
