// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Which pairs of spheres a search has to find, by classes of size: two spheres of the classes c and
 * d matter up to a centre distance Reach(c, d) = distance + factor (a + b), a and b the largest
 * radii of the classes. One reach for all would let a single large sphere make every pair of small
 * ones dear.
 *
 * A class holds one or more octaves of radius. Neighbouring octaves stay together where dividing
 * them would save less than a fifth of the pairs, so that spheres of similar sizes are one class.
 */
class SizeClasses
{
public:
  /** One class, and one reach for all pairs, whatever the radii. */
  explicit SizeClasses(double reach);

  /**
   * Collective: of the spheres of all ranks, of which this one has those with the given `radii` >
   * 0. The same on every rank. `distance` >= 0, `factor` >= 0.
   */
  SizeClasses(
    const std::vector<double>& radii, double distance, double factor, Communicator& ranks);

  /** The same for one rank that has all spheres. */
  SizeClasses(const std::vector<double>& radii, double distance, double factor);

  int Count() const { return static_cast<int>(this->Largest.size()); }

  /** The class of a radius; 0 holds the largest spheres. */
  int ClassOf(double radius) const;

  double Reach(int c, int d) const
  {
    return this->Distance + (this->Largest[c] + this->Largest[d]);
  }

  /** The reach of two of the largest spheres. */
  double LargestReach() const { return this->Reach(0, 0); }

private:
  double LargestRadius = 0.0;
  double Distance;
  std::vector<int> ClassOfOctave;
  std::vector<double> Largest; // factor times the largest radius of a class
};
}
