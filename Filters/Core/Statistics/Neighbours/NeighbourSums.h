// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Neighbours/HingeSums.h"

#include <string>
#include <tuple>

namespace ruc
{
/** Pairs count as neighbours up to this gap d / (a + b) - 1. */
constexpr double LargestNeighbourGap = 0.15;

/**
 * Who is near to whom in a pack, and how wide its pores are, which F2 hardly sees: lens volumes
 * vanish smoothly where two spheres come apart. The mean diameter is the volume mean.
 *
 * - Gaps: of u = d / (a + b) - 1 over the neighbours of a sphere, as many as a sphere has on
 *   average. In a window each pair weighs V / gamma(d), as in S_rs.
 * - Nearest: of the least gap d - a - b of every sphere whose neighbours all lie in the window.
 * - Pores: of the distance from a point of the matrix to the nearest surface, at most LargestPore,
 *   over the points of a lattice so far from the faces that no sphere beyond them is closer.
 *
 * Gaps below 1e-4 count as 1e-4, and nearest gaps below 2.5e-6 mean diameters as that, since
 * measured packs overlap a little. A sum of too few spheres is empty.
 */
struct NeighbourSums
{
  HingeSums Gaps, Nearest, Pores;
  double LargestPore = 0.0; // 0.4 mean diameters

  bool Empty() const { return this->Gaps.Empty() && this->Nearest.Empty() && this->Pores.Empty(); }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Gaps, self.Nearest, self.Pores, self.LargestPore);
  }
};

/** A sum over fewer spheres than this, or than this many mean diameters cubed of pores, is empty.
 */
constexpr int LeastCentresOfSums = 100;

/**
 * Measures a pack. The standard errors are those of nine columns of equal width, three by three
 * across the two longest edges of the window's bounds. The result is the same for any number of
 * ranks and threads. Collective.
 */
NeighbourSums MeasureNeighbourSums(const PackShare& share, Communicator& ranks);

/** What MeasureNeighbourSums takes. */
Estimate EstimateNeighbourSums(const PackFigures& pack);
}
