// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ruc
{
/**
 * Returns whether a sphere has gone more than `share` of its radius from where a list of pairs was
 * made. `centres` and `listedAt` hold x, y and z of each sphere.
 */
bool HaveGone(const double* centres, const std::vector<double>& listedAt,
  const std::vector<double>& radius, double share);

/**
 * The pairs of spheres of a periodic box that are closer than `reach` times the sum of their radii.
 * They are kept in a list with some room, which is made anew only when a sphere has gone through
 * it. Every pair counts once, by its nearest image. They come in one order, by their places.
 */
class NearPairs
{
public:
  /** `spheres` tells the radii; its centres do not matter. */
  NearPairs(const SpherePack& spheres, const Window& box, double reach);

  struct Pair
  {
    std::size_t First, Second; // First < Second
    Vector3 Along;             // from the first centre to the nearest image of the second
    double Distance;
    double Contact; // the sum of the radii

    double Gap() const { return this->Distance / this->Contact - 1.0; }
  };

  /** Returns the pairs for these centres, x, y and z of each sphere, anywhere in space. */
  const std::vector<Pair>& Find(const double* centres);

private:
  void MakeList(const double* centres);

  SpherePack Spheres;
  Window Box;
  double Reach;
  std::vector<double> ListedAt; // the centres for which the list was made
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Listed;
  std::vector<Pair> Near;
};
}
