// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PackShare.h"

#include <vector>

namespace ruc
{
/**
 * Returns the volume fractions c_r of the modes 1…N_p and, last, of the matrix. A mode's fraction
 * is the volume of its spheres with centres in the window over that of the window, and c_m = 1 -
 * sum c_r. They are those of the whole pack, the same on every rank.
 */
std::vector<double> OnePointProbability(const PackTotals& pack);
}
