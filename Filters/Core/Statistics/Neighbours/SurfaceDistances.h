// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/** Points in a box, equally spaced along each axis; the last axis runs fastest. */
struct PointLattice
{
  Vector3 Origin;  // the first point
  Vector3 Spacing; // along a periodic axis, Count times Spacing is the edge of the box
  std::array<int, 3> Count;
  std::array<bool, 3> Periodic;

  /** The number of points of a plane across the first axis. */
  std::size_t PlaneSize() const
  {
    return static_cast<std::size_t>(this->Count[1]) * this->Count[2];
  }
  Vector3 PointAt(int i, int j, int k) const
  {
    return { this->Origin[0] + i * this->Spacing[0], this->Origin[1] + j * this->Spacing[1],
      this->Origin[2] + k * this->Spacing[2] };
  }
};

/** Returns the spacing of about `most` points in a box, however flat or long it is, or `finest`. */
double LatticeSpacing(const Window& box, double finest, double most);

/**
 * The distances from the points of a lattice to the nearest surface of a sphere. They are below 0
 * within a sphere, and have the accuracy of a float.
 */
struct SurfaceDistances
{
  std::vector<float> Distance; // at most `most`
  /** The place of that sphere in the pack, or -1 where none is closer than `most`. */
  std::vector<std::int32_t> Sphere;
};

/**
 * Finds the distances of the points of the planes [first, last) across the first axis. Along a
 * periodic axis the images of spheres count, whose radius and `most` together must be less than the
 * edge. The result does not depend on the number of threads.
 */
SurfaceDistances FindSurfaceDistances(
  const SpherePack& pack, const PointLattice& lattice, double most, int first, int last);
}
