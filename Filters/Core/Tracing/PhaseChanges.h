// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Tracing/LineBundle.h"

#include <vector>

namespace ruc
{
/**
 * A position along a line at which it passes from one phase into another. Phases are counted from
 * 0, the matrix is N_p, and N_p + 1 stands for points outside the region.
 */
struct PhaseChange
{
  double Position;
  int Before, After;
};

/**
 * Replaces `changes` by the ascending phase changes of a line, found from the spheres that it meets
 * and from its intervals inside the region. `hits` are sorted on the way. A point in several
 * spheres belongs to the lowest of their modes, a point in none to the matrix.
 */
void FindPhaseChanges(std::vector<SphereHit>& hits, const std::vector<LineInterval>& inside,
  int modes, std::vector<PhaseChange>& changes);
}
