// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/TaperedBlocks.h"

#include <string>
#include <vector>

namespace ruc
{
/**
 * Whether the fraction of the particles in layers across an axis differs by more than the scatter
 * within the layers explains.
 */
struct LayerTest
{
  std::string Axis;   // "x", "y", "z"; of a cylinder "axis" and "radius"
  double First, Last; // the fractions in the first and the last layer
  double Least, Most; // and of all layers
  double ChiSquared;  // of the differences from the mean
  int Freedoms;       // the number of layers less one
  /**
   * The test by the distribution F as a standard normal deviate (E. Paulson, Ann. Math. Stat. 13,
   * 233, 1942): above 3, one pack in a thousand would differ as much by chance.
   */
  double Deviate;

  /** The deviate beyond which a pack is not one medium. */
  static constexpr double MostDeviate = 3.0;
  bool Passed() const { return !(this->Deviate > MostDeviate); }
  /** Says along which axis the fraction goes from what to what. */
  std::string Describe() const;
};

/**
 * Tests the layers of blocks along each axis that has two or more. `volumes` are those of the
 * spheres in each cell of the blocks, and `volume` that of the window. `rings` are those in rings
 * of equal area around the axis of a cylinder, the inner first; none for a box.
 */
std::vector<LayerTest> TestLayers(const TaperedBlocks& blocks, const std::vector<double>& volumes,
  const std::vector<double>& rings, double volume);

/** Says what tests were not passed, in whole sentences; an empty text if all were. */
std::string DescribeFailures(const std::vector<LayerTest>& tests);
}
