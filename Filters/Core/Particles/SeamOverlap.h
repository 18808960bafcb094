// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

namespace ruc
{
/**
 * Returns whether spheres overlap across the periodic faces of a box, as those of a pack do that
 * was cut out of a larger one. Pairs count whose overlap a + b - d exceeds a fifth of the lesser
 * radius: five of them or more across the faces, and more than within a largest diameter of the
 * faces on either side, where a pack that overlaps everywhere has four times as many. The centres
 * must lie in the box (MoveIntoBox).
 */
bool OverlapsAcrossSeams(const SpherePack& pack, const Window& box);
}
