// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Homogenisation/CellSlab.h"
#include "ruc/Particles/SpherePack.h"

#include <array>
#include <functional>
#include <vector>

namespace ruc
{
/** What the voxels of a plane of a grid are made of, x running fastest. */
struct PlaneMixture
{
  /** The shares of a voxel that the materials have; the rest, down to 0, is the matrix. */
  std::vector<const float*> Fractions;
  /** The direction from the nearest surface's centre, for laminates; null where none is wanted. */
  std::array<const float*, 3> Normal;
};

/** Mixtures as MixtureOfPack makes them. */
using VisitMixture = std::function<void(int plane, const PlaneMixture& mixture)>;

/**
 * Calls visit(plane, mixture) for every plane of the grid of which `slab` has one, or an image of
 * one, from any thread. `materialOfMode` is the material, from 0, of modes 1…N_p. The grid lies in
 * the window or covers it; spheres have images across periodic faces. Shares are exact
 * (SphereFractions) and, with the normal of the nearest sphere's surface, equal for any number of
 * ranks. Collective.
 */
void MixtureOfPack(const SpherePack& piece, const Window& window, const CellSlab& slab,
  const std::vector<int>& materialOfMode, bool withNormals, Communicator& ranks,
  const VisitMixture& visit);

/** The planes of the grid that `slab` wants, in order. */
std::vector<int> WantedPlanes(const CellSlab& slab);
}
