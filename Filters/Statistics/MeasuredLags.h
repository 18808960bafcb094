// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Tracing/SamplingRegion.h"

/** The lags of the filters that measure functions of one lag. */
namespace MeasuredLags
{
/**
 * The lags for the properties MaximumLag, `maximum`, and NumberOfLags, `count`. MaximumLag = 0
 * stands for half the shortest edge, or for the largest lag that the method allows: of sums over
 * pairs where `region` is null, else of lines and throws in that region. The edge is that of the
 * window, or with a mask that of the mask's bounds. Throws std::invalid_argument for numbers out
 * of range.
 */
ruc::LagGrid Find(double maximum, int count, const ruc::PackShare& share,
  const ruc::SamplingRegion* region = nullptr, bool hasMask = false);
}
