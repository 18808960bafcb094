// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/TwoPointProbability.h"

class ProgressReport;
class RankCommunicator;
namespace PackData
{
struct ObservedPack;
}

/** The exact pair sum of a pack over the ranks. */
namespace TwoPointSum
{
/** The lags up to `maximum`, or up to `automatic` where that is 0. Throws std::invalid_argument for
 * numbers out of range. */
ruc::LagGrid MakeLags(double maximum, int count, double automatic);

/** Half the shortest edge of the window, or the largest lag that it allows. */
double AutomaticLag(const PackData::ObservedPack& observed);

/** Collective; the same bits on every rank. */
ruc::TwoPointProbability Compute(const PackData::ObservedPack& observed, const ruc::LagGrid& lags,
  RankCommunicator& ranks, ProgressReport& report);

/** (sum d^3 / number)^(1/3) */
double MeanDiameter(const ruc::SpherePack& pack);
}
