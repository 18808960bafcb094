// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/GreyLevels.h"

#include <optional>

namespace ruc
{
/** How the voxels of particles are told from those of the matrix. */
struct PhaseSearch
{
  /** Whether the image has two values without blur, those of matrix and particle. Where it is not
   * said, it has if there are no others. */
  std::optional<bool> Binary;
  std::optional<double> Threshold;                  // between the phases; else that of Otsu
  std::optional<double> MatrixValue, ParticleValue; // else those that the image has
  int Smoothing = -1; // how often it is smoothed to find particles; -1: by the noise
};

/** The two phases of an image whose particles are brighter than the matrix. */
struct TwoPhases
{
  GreyLevels Levels;
  bool Binary = false;
  double Threshold = 0.0;
  int Smoothing = 0;
  double MatrixValue = 0.0;
  double Contrast = 1.0; // what particles have more
};

/**
 * Finds the phases of an image without halo. Throws std::invalid_argument, the same on every rank,
 * for an image of one value, for one of more than two that should have two, for a threshold that is
 * not between its values, and for particles that are not brighter. Collective.
 */
TwoPhases FindPhases(const VoxelSlab<float>& image, const PhaseSearch& search, Communicator& ranks);

/** Returns the image when it is smoothed so many times by Smooth. Neither has a halo. Collective.
 */
VoxelSlab<float> Smoothed(VoxelSlab<float> image, int times, Communicator& ranks);
}
