// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/ConductivityVoxels.h"
#include "ruc/Homogenisation/EffectiveBounds.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * The stiffness of voxels of isotropic materials. A voxel that a surface cuts has the means of K
 * and G (Arithmetic), the inverses of the means of 1 / K and 1 / G (Harmonic), or is a laminate of
 * the matrix and that material of which it has most, with the surface's normal n (Laminate): with
 * the share f of spheres, D = C_2 - C_1, x~ = (1 - f) x_2 + f x_1 and t = (D : e) n the stress is
 *
 *     <C> : e + D : sym(a n),  a = -(f (1 - f) / mu~) (t - (lambda~ + mu~) / (lambda~ + 2 mu~) n (n
 * t))
 */
class ElasticVoxels : public VoxelLaw
{
public:
  /** `materials` are those of PlaneMixture, at most 255. */
  ElasticVoxels(const CellSlab& slab, const ElasticModuli& matrix,
    const std::vector<ElasticModuli>& materials, InterfaceRule rule);

  /** Sets the voxels of a plane of the grid, wherever the slab has it. From any thread. */
  void SetPlane(int plane, const PlaneMixture& mixture);

  int Components() const override { return 3; }
  void Flux(
    std::size_t place, int count, const float* const* gradient, float* const* flux) const override;
  std::array<double, 2> Reference() const override;

  static double BytesOfVoxel(InterfaceRule rule)
  {
    return rule == InterfaceRule::Laminate ? 29.0 : 8.0;
  }

private:
  void SetVoxel(const PlaneMixture& mixture, std::size_t n, float* values) const;

  const CellSlab& Slab;
  ElasticModuli Matrix;
  std::vector<ElasticModuli> Materials;
  InterfaceRule Rule;
  // lambda and mu; of a laminate also f (1 - f) / mu~ and its product with (lambda~ + mu~) /
  // (lambda~
  // + 2 mu~), and the normal
  std::array<std::vector<float>, 7> Values;
  std::vector<std::uint8_t> Material;      // of the laminate
  std::vector<float> LambdaApart, MuApart; // of every material, less that of the matrix
};
}
