// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/Jackknife.h"

#include <vector>

namespace ruc
{
/**
 * Returns the mean number of spheres around one with a gap d / (a + b) - 1 up to each of `gaps`,
 * which ascend. All spheres of the window count, and a pair weighs V / gamma(d) as in S_rs, for
 * what lies beyond the faces. The standard errors are by about so many blocks (TaperedBlocks), and
 * NaN for 0. The result is equal, bit by bit, for any number of ranks and threads. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for a window without room for blocks.
 */
std::vector<ValueWithError> CountGaps(
  const PackShare& share, const std::vector<double>& gaps, int blocks, Communicator& ranks);
}
