// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/PackMixture.h"
#include "ruc/Homogenisation/VoxelLaw.h"

#include <array>
#include <vector>

namespace ruc
{
/** What a voxel is that a surface cuts. */
enum class InterfaceRule
{
  Laminate,  // layers along the surface: the least error at small contrast
  Harmonic,  // the inverse of the mean inverse: gaps between good conductors stay open
  Arithmetic // the mean: gaps between voids stay closed
};
constexpr int CountOf(InterfaceRule)
{
  return 3;
}

/**
 * The conductivity of voxels. With the shares f of the materials it is 1 / <1/k> (Harmonic), <k>
 * (Arithmetic), or the flux <k> g - (<k> - 1 / <1/k>) n (n g) with the normal n of the surface
 * (Laminate).
 */
class ConductivityVoxels : public VoxelLaw
{
public:
  /** All conductivities are finite and >= 0; `materials` are those of PlaneMixture. */
  ConductivityVoxels(
    const CellSlab& slab, double matrix, const std::vector<double>& materials, InterfaceRule rule);

  /** Sets the voxels of a plane of the grid, wherever the slab has it. From any thread. */
  void SetPlane(int plane, const PlaneMixture& mixture);

  int Components() const override { return 1; }
  void Flux(
    std::size_t place, int count, const float* const* gradient, float* const* flux) const override;
  std::array<double, 2> Reference() const override;

  /** The rule by contrast: Harmonic from 30 on, Arithmetic where it is 1/30 or less. */
  static InterfaceRule AutomaticRule(double matrix, const std::vector<double>& materials);

  static double BytesOfVoxel(InterfaceRule rule)
  {
    return rule == InterfaceRule::Laminate ? 16.0 : 4.0;
  }

private:
  const CellSlab& Slab;
  double Matrix;
  std::vector<double> Materials;
  InterfaceRule Rule;
  std::vector<float> Mean; // the conductivity along a surface, or in all directions
  std::array<std::vector<float>, 3> Normal; // times the root of what is less across the surface
};
}
