// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/GridPredicates.h"

#include <vector>

namespace ruc
{
/**
 * Returns the order in which points are best inserted one by one into a tessellation: in rounds,
 * each about eight times as large as the one before it and drawn at random, and within a round
 * along a Hilbert curve, so that each point lies near the one before it. The order depends on the
 * points alone. Source: Amenta, Choi and Rote, Proc. 19th Symposium on Computational Geometry, 211
 * (2003).
 */
std::vector<int> InsertionOrder(const std::vector<GridPoint>& points);
}
