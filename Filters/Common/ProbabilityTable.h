// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RUCCommonModule.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <string>

class RankCommunicator;
class vtkTable;

/** Tables of S_rs, made by this plugin or by any other program. */
namespace ProbabilityTable RUCCOMMON_EXPORT
{
/**
 * The relative rounding of five digits, which ParaView writes by default: half a unit of the last
 * digit, 0.00005 of 1.
 */
constexpr double Rounding = 5e-5;

/**
 * Reads S_rs from a table with the columns `r` and `S_1_1`, `S_1_2`, … `S_m_m`, one for each
 * unordered pair of phases, in any order; other columns are ignored. All rows of the table are on
 * one rank. They are the lags 0, dr, 2 dr, …; fractions are S_rr at lag 0. The lags of the result
 * are equal steps to the last lag as it is written. `what` names the table in messages. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, where a column is missing or not of
 * numbers, for values that are not finite, where there are fewer than two rows, and where a lag is
 * farther from a whole number of steps than 2 `Rounding` of the last lag, or than half a step.
 */
ruc::TwoPointProbability Read(vtkTable* table, const std::string& what, RankCommunicator& ranks);
}
