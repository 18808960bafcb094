// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Meshing/MeshBox.h"

#include <vector>

namespace ruc
{
/**
 * Returns points about `size` apart in the matrix and in the spheres: the corner of the box, points
 * on its edges, hexagonal lattices on its planes and a body-centred lattice between them, displaced
 * a little at random so that no five lie on one sphere. Points too near to a surface are left out.
 */
std::vector<CellPoint> MakeLatticePoints(
  const MeshCell& cell, double size, const MeshSettings& settings);
}
