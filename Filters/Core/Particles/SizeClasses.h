// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Which pairs of spheres a search has to find, by classes of size. Two spheres of the classes c and
 * d matter up to a centre distance Reach(c, d) = distance + factor (a + b), where a and b are upper
 * bounds of the radii in the classes. With one reach for all, a single large sphere would make
 * every pair of small ones costly.
 *
 * A class holds one or more octaves of radius. Neighbouring octaves stay together where dividing
 * them would save less than a fifth of the pairs, so that spheres of similar sizes are one class.
 */
class SizeClasses
{
public:
  /** Makes one class, with one reach for all pairs, whatever the radii. */
  explicit SizeClasses(double reach);

  /**
   * Makes the classes of the spheres of all ranks, of which this rank has those with the given
   * `radii` > 0. They are the same on every rank. `distance` >= 0, `factor` >= 0. Collective.
   */
  SizeClasses(
    const std::vector<double>& radii, double distance, double factor, Communicator& ranks);

  /** The same for one rank that has all spheres. */
  SizeClasses(const std::vector<double>& radii, double distance, double factor);

  int Count() const { return static_cast<int>(this->Largest.size()); }

  /** Returns the class of a radius. Class 0 holds the largest spheres. */
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
  std::vector<double> Largest; // for every class factor times an upper bound of its radii
};
}
