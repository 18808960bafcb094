// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"

#include <cstdint>
#include <tuple>

namespace ruc
{
/** The overlap of a pack, in which images along periodic axes count. */
struct PackOverlap
{
  /**
   * The lens volume of all pairs in percent of the volume of the spheres, V_o / V_p x 100 (section
   * II of the paper).
   */
  double Percent = 0.0;
  std::int64_t Pairs = 0; // that overlap
  /**
   * The largest (a + b - d) / (a + b) of all pairs with radii a and b and centre distance d. It is
   * < 0 where no two spheres overlap, and -1 where no pair is closer than 1.01 (a + b).
   */
  double Deepest = -1.0;

  /**
   * Returns whether no two spheres overlap, but for rounding: every pair has d >= (a + b)(1 -
   * 1e-12).
   */
  bool IsNone() const { return this->Deepest <= 1e-12; }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Percent, self.Pairs, self.Deepest);
  }
};

PackOverlap MeasureOverlap(const SpherePack& pack, const Window& window);

/** Measures a pack that is spread over ranks. Collective; the result is the same on every rank. */
PackOverlap MeasureOverlap(const PackShare& share, Communicator& ranks);
}
