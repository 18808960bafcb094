// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/CornerField.h"
#include "ruc/Homogenisation/VoxelLaw.h"

#include <array>
#include <functional>
#include <vector>

namespace ruc
{
/** The most components of a flux, and of a gradient. */
constexpr int MostFluxes = 6;
constexpr int MostGradients = 9;

/** A uniform gradient, at 3 c + d as VoxelLaw has it. */
using MacroGradient = std::array<double, MostGradients>;

/** The place in a flux of its part along axis d for component c. */
int FluxOf(int components, int c, int d);

/**
 * The equations of a cell: D^T C (E + D u) at its corners, with the gradient D u at the centres of
 * voxels, each from the voxel's eight corners (the rotated scheme of F. Willot, C. R. Mécanique
 * 343, 232, 2015, in the real space), its transpose D^T, the law C and the uniform gradient E.
 */
class CornerOperator
{
public:
  CornerOperator(const CellSlab& slab, const VoxelLaw& law);

  /**
   * Takes the flux of a voxel plane, which is of the cell's plane z: its components, each of as
   * many numbers as the plane has voxels. It is called for own planes alone, from any thread.
   */
  using TakeFlux = std::function<void(int z, const float* const* flux)>;

  /** Sets the own planes of `result`. The halo of `u` must be up to date. */
  void Apply(const CornerField& u, const MacroGradient& uniform, CornerField& result,
    const TakeFlux& take = {}) const;

private:
  // Room of a thread: a row of each kind, and the fluxes of two voxel planes
  struct Room;
  void FindFlux(const CornerField& u, const MacroGradient& uniform, int n, Room& room) const;
  void Collect(int n, CornerField& result, Room& room) const;

  const CellSlab& Slab;
  const VoxelLaw& Law;
  std::array<float, 3> Weight; // a quarter of the inverse of the voxel's edge
};
}
