// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackFigures.h"
#include "ruc/Statistics/Sampling/SampledSums.h"

#include <optional>

/** What the estimates of the filters that measure functions of one lag have in common. */
namespace StatisticsEstimate
{
/**
 * Returns about the lags of MeasuredLags::Find, from figures of the pack; with `exact`, those for
 * sums over pairs.
 */
ruc::LagGrid FindLags(double maximum, int count, const ruc::PackFigures& pack, bool exact);

/**
 * Returns what comes before the work on the lags, which is to share the pack out, and tells what
 * MaximumLag = 0 stands for.
 */
ruc::Estimate OfPack(const ruc::PackFigures& pack, double maximum, const ruc::LagGrid& lags);

/**
 * Returns what it takes until ParaView knows `tables` tables with a column for every pair of
 * phases, which is more than the functions take for hundreds of modes.
 */
ruc::Estimate OfTables(const ruc::PackFigures& pack, int tables);

/**
 * Returns the number of samples that the settings ask for, or none where there can be no such
 * samples. It is not a number where a TargetError is asked for, so that only samples tell it: the
 * memory is known then, but not the time.
 */
std::optional<double> NumberOfSamples(const ruc::SamplingSettings& settings);
}
