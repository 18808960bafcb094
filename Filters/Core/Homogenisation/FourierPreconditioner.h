// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Homogenisation/CornerField.h"
#include "ruc/Images/FourierTransform.h"

#include <array>
#include <vector>

namespace ruc
{
/**
 * The inverse of D^T C_0 D (CornerOperator) for a uniform material C_0, by Fourier transforms: that
 * makes conjugate gradients take as many steps on a fine grid as on a coarse one.
 */
class FourierPreconditioner
{
public:
  /** `reference` is that of VoxelLaw. The transform is of the cell's size. */
  FourierPreconditioner(const CellSlab& slab, const std::array<double, 2>& reference,
    int components, const Communicator& ranks);

  /**
   * Finds z = M r of the own planes, and returns the sum of r z over all corners, the same on every
   * rank. Then sets p to z + b p with b = that sum over `former`, or to z where `former` is 0.
   * Collective.
   */
  double Step(const CornerField& r, double former, CornerField& p, Communicator& ranks);

private:
  // Replaces the spectrum of r by that of z, and returns the sums of r z of every block
  std::vector<double> Divide();
  void DivideScalar(std::int64_t block, double* sum);
  void DivideVector(std::int64_t block, double* sum);

  const CellSlab& Slab;
  std::array<double, 2> Reference;
  FourierTransform Transform;
  std::vector<FourierTransform::Spectrum> Spectra; // of the components
  // For each axis and frequency the derivative over the edge of a voxel, and the mean of two
  // corners
  std::array<std::vector<double>, 3> Sine, Cosine;
};
}
