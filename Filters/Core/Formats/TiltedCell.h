// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/PackFrame.h"
#include "ruc/Window/Window.h"

namespace ruc
{
/**
 * Returns the brick of a box, which has its origin and its edges lx, ly, lz without the tilts. It
 * holds every sphere of a periodic pack once, as the tilted cell does, so what is counted in it is
 * exact. The brick repeats along x; along y it repeats only if a step along y is a period of the
 * cell, that is if xy is a multiple of lx, and along z likewise. Other axes of the brick are not
 * periodic: its faces cut a pack that goes on beyond them.
 */
Window BrickOf(const FrameBox& box);

/**
 * Moves centres by whole edges of the cell along its periodic axes, first c, then b, then a, into
 * the brick, and returns how many were moved. Throws std::invalid_argument for a centre more than
 * 10^9 edges away, whose digits do not tell where it is.
 */
std::size_t WrapIntoBrick(PackFrame& frame, const FrameBox& box);
}
