// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/Jackknife.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace ruc
{
/** How void distances are measured. Lengths are in the unit of the pack. */
struct VoidSettings
{
  /**
   * The spacing of the lattice of points. 0 stands for a twentieth of the mean diameter, more where
   * there would be too many points.
   */
  double Spacing = 0.0;
  /**
   * The last distance of the table; distances beyond it count as that. 0 stands for one mean
   * diameter, more where spheres are sparse, less in a small periodic box.
   */
  double MaximumDistance = 0.0;
  int Distances = 200;            // the number of steps up to it, from 1 to 100 000
  int Blocks = 32;                // about the number of blocks for the errors, from 2 to 1000
  bool WithCriticalRadius = true; // which takes most of the time
};

/** Throws std::invalid_argument for settings out of range. */
void CheckSettings(const VoidSettings& settings);

/** Returns the settings with MaximumDistance as it is taken, which is where that is 0. */
VoidSettings WithMaximumDistance(const VoidSettings& settings, const PackTotals& pack);

/**
 * How far points of the matrix are from the nearest surface of a sphere: delta(x) = min over i of
 * |x - c_i| - r_i, at the points of a lattice in a region. Standard errors of means are those of
 * the delete-one jackknife over blocks of the region.
 */
struct VoidDistances
{
  std::int64_t Points = 0; // of the matrix
  int Blocks = 0;
  double Spacing = 0.0; // the largest along any axis
  double MaximumDistance = 0.0;
  double Beyond = 0.0; // the share of the points that are as far as that, or farther

  std::vector<double> Distance;      // z
  std::vector<ValueWithError> Share; // P(delta > z) of the points of the matrix
  ValueWithError Mean;               // of delta
  double Largest = 0.0;

  /**
   * The radius of the largest sphere that fits through the matrix along x, y and z: from face to
   * face of the region, or of the box inside a cylinder along an axis; along a periodic axis from a
   * place to its image. NaN where the region is no box, and without WithCriticalRadius.
   *
   * Points beside a throat count as those within (PoreThroats), so that the spacing h makes an
   * error of the order of h^2 / 12 mean diameters. The error has this, and the scatter of the
   * eighths of the box times 2^(-1 / 0.876): by that power of the edge, with the exponent nu of
   * percolation in three dimensions, the critical value of a box scatters (D. Stauffer, A. Aharony,
   * Introduction to Percolation Theory, 1994).
   */
  std::array<ValueWithError, 3> CriticalRadius;
};

/**
 * Measures a pack. The result is equal, bit by bit, for any number
 * of ranks and threads. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for settings out of range, a lattice of
 * more than 10^9 points, a MaximumDistance that reaches across a periodic box, and a region without
 * a point of the matrix.
 */
VoidDistances MeasureVoids(const PackShare& share, const SamplingRegion& region,
  const VoidSettings& settings, Communicator& ranks,
  const std::function<void(double)>& progress = {});

/** What MeasureVoids takes. Throws std::invalid_argument for settings out of range. */
Estimate EstimateVoids(const PackFigures& pack, const VoidSettings& settings);
}
