// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

class ProgressReport;
class RankCommunicator;

/** The exact pair sum of a pack over the ranks. */
namespace TwoPointSum RUCCOMMON_EXPORT
{
/** The lags up to `maximum`, or up to `automatic` where that is 0. Throws std::invalid_argument for
 * numbers out of range. */
ruc::LagGrid MakeLags(double maximum, int count, double automatic);

/** Half the shortest edge of the window, or the largest lag that it allows. */
double AutomaticLag(const ruc::PackShare& pack);

/** Collective; the same bits on every rank. */
ruc::TwoPointProbability Compute(const ruc::PackShare& pack, const ruc::LagGrid& lags,
  RankCommunicator& ranks, ProgressReport& report);
}
