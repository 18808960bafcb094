// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Descent.h"
#include "ruc/Particles/PackOverlap.h"

#include <cstdint>
#include <functional>
#include <tuple>

namespace ruc
{
/** The state of RemoveOverlap between two steps, from which it goes on to the same end, bit by bit.
 */
struct OverlapRemovalState
{
  std::uint32_t Attempt = 0; // counted from 0
  DescentState Descent;      // of the centres in this attempt

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Attempt, self.Descent);
  }

  /** Throws std::invalid_argument unless it can be a state of so many spheres. */
  void Check(std::size_t spheres) const;
};

/**
 * Moves the centres of a pack in a box apart until no two spheres overlap. Faces of the box that
 * are not periodic are walls, which spheres do not overlap either. It minimises the sum of the
 * squares of a + b - d over the pairs that overlap, with L-BFGS; radii are enlarged a little, so
 * that the minimum is reached with room to spare. A pack that jams is shaken, by random numbers of
 * the seed, and tried again.
 *
 * Returns whether nothing overlaps. `carryOn` is called every few steps and
 * stops the work when it returns false; `pack` then holds what was reached.
 *
 * `save`, if given, receives the state every 50 steps and where the work is stopped; it takes a
 * kilobyte a sphere. `resume` is such a state to go on from; of `pack` then the radii count.
 */
bool RemoveOverlap(SpherePack& pack, const Window& box, std::uint32_t seed,
  const std::function<bool()>& carryOn, const OverlapRemovalState* resume = nullptr,
  const std::function<void(const OverlapRemovalState&)>& save = {});
}
