// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/Fit/VoxelSlab.h"

namespace ruc
{
/** What the grey values of an image tell before anything is found in it. */
struct GreyLevels
{
  double Low = 0.0, High = 0.0; // the least and the greatest value
  double Threshold = 0.0;       // of Otsu: between the values of the two phases
  double Below = 0.0;           // the median up to the threshold, which is near the matrix's value
  double Above = 0.0;           // that above it
  double Noise = 0.0;           // the standard deviation of what changes from voxel to voxel
  bool TwoValues = false;       // whether there are two values and no others
};

/**
 * Finds the levels of an image without halo. The threshold is the one of Otsu (1979) in a histogram
 * of 4096 classes. Where these are wide since a ten-thousandth of the voxels or less lies far away,
 * it is made again without those. The noise is the median size of fourth differences along x, over
 * that which white noise of deviation 1 has; the edge of a particle, blurred by a voxel or more,
 * hardly has any. They come from counts, and so are equal for any number of ranks.
 *
 * Throws std::invalid_argument, the same on every rank, for an image with one value only.
 * Collective.
 */
GreyLevels FindGreyLevels(const VoxelSlab<float>& image, Communicator& ranks);

/**
 * Returns how many times an image with that share of noise, its deviation over the contrast of the
 * phases, is smoothed by Smooth for the share to be below 0.12; 3 at most.
 */
int SmoothingFor(double noise);

/**
 * Replaces every value by the mean with weights 1 2 1 along each axis. At the border of the image
 * its last voxel is repeated, and so it is at that of the slab: one plane of a halo is used up.
 */
void Smooth(VoxelSlab<float>& image);
}
