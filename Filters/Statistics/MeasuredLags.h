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
 * Returns the lags for the properties MaximumLag, `maximum`, and NumberOfLags, `count`. They are
 * those of ruc::LagLimit for sums over pairs where `region` is null, else for lines and throws in
 * that region of the window or mask. Throws std::invalid_argument for numbers out of range.
 */
ruc::LagGrid Find(double maximum, int count, const ruc::PackShare& share,
  const ruc::SamplingRegion* region = nullptr, bool hasMask = false);
}
