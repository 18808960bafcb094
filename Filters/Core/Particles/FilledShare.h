// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SpherePack.h"

namespace ruc
{
/** A false alarm of FindFilledShare is less likely than this. */
constexpr double FilledShareRisk = 1e-6;
/** FindFilledShare tells of nothing smaller that is empty. */
constexpr double LeastEmptyShare = 0.1;

/**
 * Collective: the share of a window's volume that the centres fill, 1 unless chance cannot explain
 * what they leave empty: after a pack was cut, its window is still that of the whole.
 *
 * The window is divided into cells of equal volume, in four ways, for 2, 4, 8 and 16 spheres each
 * on average. Of m cells, E are empty of n independent centres with a probability of at most
 * C(m, E) (1 - E/m)^n, whichever these are. Spheres that keep their distance leave less empty, so
 * the bound holds for packs, too. Three things keep it from telling of what is no cut: a cell
 * inside a large sphere counts as filled; n is the number of equal spheres that scatter as much,
 * (sum v)^2 / sum v^2 with their volumes v, so that a region of large spheres is not taken for an
 * empty one among small spheres; and a cell is wider than the layer of one radius that the wall of
 * a container leaves without centres.
 */
double FindFilledShare(const SpherePack& piece, const Window& window, Communicator& ranks);
}
