// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackFigures.h"
#include "ruc/Statistics/Sampling/SampledSums.h"

#include <optional>

/** What the estimates of the filters that measure functions of one lag have in common. */
namespace StatisticsEstimate
{
/** MeasuredLags::Find, about, from figures of the pack; `exact`: for sums over pairs. */
ruc::LagGrid FindLags(double maximum, int count, const ruc::PackFigures& pack, bool exact);

/** What comes before the work on the lags: the pack is shared out. Tells what MaximumLag = 0 stands
 * for. */
ruc::Estimate OfPack(const ruc::PackFigures& pack, double maximum, const ruc::LagGrid& lags);

/** How many samples the settings ask for; none where there are no such samples, and not a number
 * where only samples tell, because a TargetError is asked for: the memory is known then. */
std::optional<double> NumberOfSamples(const ruc::SamplingSettings& settings);
}
