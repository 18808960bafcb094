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
/** Collective; the same bits on every rank. */
ruc::TwoPointProbability Compute(const ruc::PackShare& pack, const ruc::LagGrid& lags,
  RankCommunicator& ranks, ProgressReport& report);
}
