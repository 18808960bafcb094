// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/SpherePack.h"

#include <vector>

namespace ruc
{
/**
 * Volume fractions c_r of the modes 1…N_p and, last, of the matrix: the volume of the spheres with
 * centres in the window over that of the window, c_m = 1 - sum c_r. The pack in canonical order.
 */
std::vector<double> OnePointProbability(const SpherePack& pack, const Window& window);
}
