// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SpherePack.h"

namespace ruc
{
/** The probability of a false alarm of FindFilledShare is less than this. */
constexpr double FilledShareRisk = 1e-6;
/** FindFilledShare tells of an empty share of the window only from this share on. */
constexpr double LeastEmptyShare = 0.1;

/**
 * Returns the share of a window's volume that the centres fill. It is 1 unless chance cannot
 * explain what they leave empty, as in a pack that was cut while its window is still that of the
 * whole. Collective.
 *
 * The window is divided into cells of equal volume in four ways, with 2, 4, 8 and 16 spheres in
 * each on average. The probability that n independent centres leave any E of m cells empty is at
 * most C(m, E) (1 - E/m)^n. Spheres that keep their distance leave less empty, so the bound holds
 * for packs as well. Three things prevent false alarms: a cell inside a large sphere counts as
 * filled; n is the number of equal spheres that scatter as much, (sum v)^2 / sum v^2 with the
 * spheres' volumes v, so that a region of large spheres is not taken for an empty one among small
 * spheres; and a cell is wider than the layer of one radius that the wall of a container leaves
 * without centres.
 */
double FindFilledShare(const SpherePack& piece, const Window& window, Communicator& ranks);
}
