// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"

#include <cstdint>
#include <tuple>

namespace ruc
{
/** Overlap of a pack, images along periodic axes included. */
struct PackOverlap
{
  /** Total lens volume of all pairs / total volume of the spheres x 100. */
  double Percent = 0.0;
  std::int64_t Pairs = 0;
  /** Largest (a + b - d) / (a + b) of all pairs; < 0 where nothing touches, -1 without neighbours.
   */
  double Deepest = -1.0;

  /** Every pair has d >= (a + b)(1 - 1e-12). */
  bool IsNone() const { return this->Deepest <= 1e-12; }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Percent, self.Pairs, self.Deepest);
  }
};

PackOverlap MeasureOverlap(const SpherePack& pack, const Window& window);

/** Collective: of a pack that is spread over ranks; the same on every rank. */
PackOverlap MeasureOverlap(const PackShare& share, Communicator& ranks);
}
