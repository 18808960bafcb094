// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ruc
{
/**
 * Returns about the largest fraction of volume that spheres of these radii fill in a random close
 * pack, to within 0.01: 0.64 where all are equal, more where small ones find room between large
 * ones. It takes milliseconds.
 *
 * It is the rod packing of Farr and Groot (J. Chem. Phys. 131, 244104, 2009): chords of the spheres
 * are put on a line, the longest first, each into the largest gap that is left, and keep a distance
 * in proportion to their length.
 */
double MaximumRandomFraction(const std::vector<double>& radii);
}
