// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SpherePack.h"

#include <array>
#include <cstdint>
#include <optional>

namespace ruc
{
/** Where a pack lies and how large its spheres are. The same on any number of ranks. */
struct PackBounds
{
  /** Collective. All centres and radii must be in the range of Window.h, and a radius above 0. */
  PackBounds(const SpherePack& piece, const std::optional<Window>& box, Communicator& ranks);

  std::int64_t Spheres = 0;
  /** The bounds of the centres. */
  Vector3 LeastCentre{}, GreatestCentre{};
  /** The bounds of the spheres; along the periodic axes of the box, that of the box. */
  Vector3 Least{}, Greatest{};
  std::array<bool, 3> Periodic{};
  double LargestRadius = 0.0;
  /** The mean radius, weighted by volume, over the largest one. */
  double VolumeMean = 0.0;

  double Extent(int axis) const { return this->Greatest[axis] - this->Least[axis]; }
  double LargestDiameter() const { return 2.0 * this->LargestRadius; }
};

/**
 * A share from 0 to 1 as a whole number, so that sums over spheres do not depend on their order.
 * The sum of 2^32 of them does not overflow.
 */
std::int64_t FixedShare(double share);
}
