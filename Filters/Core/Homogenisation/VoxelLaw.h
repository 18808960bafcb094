// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace ruc
{
/**
 * The material of the voxels of a rank: what flux a gradient drives through each. It is linear and
 * symmetric.
 */
class VoxelLaw
{
public:
  virtual ~VoxelLaw() = default;

  /** Components of the unknown: 1 for a temperature, 3 for a displacement. */
  virtual int Components() const = 0;

  /** Flux components: the three of a vector, or the stresses xx, yy, zz, yz, xz, xy. */
  int FluxComponents() const { return this->Components() == 1 ? 3 : 6; }

  /**
   * Sets `flux` for `count` voxels from `place` on, x running fastest, then y, then the voxel
   * planes of a CellSlab. `gradient[3 c + d]` is the derivative of component c along axis d. May be
   * called from any thread.
   */
  virtual void Flux(
    std::size_t place, int count, const float* const* gradient, float* const* flux) const = 0;

  /**
   * A uniform material whose inverse makes the equations well-conditioned: a conductivity, or the
   * Lamé moduli lambda and mu.
   */
  virtual std::array<double, 2> Reference() const = 0;
};
}
