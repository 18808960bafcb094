// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <string>

class RankCommunicator;
class vtkTable;

/** Tables of S_rs, of this plugin or from any program. */
namespace ProbabilityTable RUCCOMMON_EXPORT
{
/** Half a unit of the last of five digits, which ParaView writes by default, as a share of a
 * number: 0.00005 of 1. */
constexpr double Rounding = 5e-5;

/**
 * Collective: S_rs from a table with the columns `r` and `S_1_1`, `S_1_2`, … `S_m_m`, one for each
 * unordered pair of phases, in any order; others are ignored. All its rows are on one rank. The
 * rows are the lags 0, dr, 2 dr, …; fractions are S_rr at lag 0. Throws std::invalid_argument, the
 * same on every rank, where a column is missing or not of numbers, where there are fewer than two
 * rows, where a lag is not within 2 `Rounding` of the last lag, or not within half a step, of a
 * whole number of steps, and for values that are not numbers. The lags of the result are equal
 * steps to the last lag as it is written. `what` names the table in messages.
 */
ruc::TwoPointProbability Read(vtkTable* table, const std::string& what, RankCommunicator& ranks);
}
