// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/PairSums/SumRounds.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * S_rs(x) on the lag vectors x = (i, j, k) Spacing, with i = -Half[0]…Half[0] and so on. There are
 * 2 Half + 1 values along each axis, with x running fastest.
 */
struct ProbabilityMap
{
  std::array<int, 3> Half;
  double Spacing;
  std::vector<std::array<int, 2>> Pairs;   // of phases counted from 0, the matrix last
  std::vector<std::vector<double>> Values; // one image for each of these pairs

  std::size_t Voxels() const
  {
    return (2 * std::size_t(this->Half[0]) + 1) * (2 * std::size_t(this->Half[1]) + 1) *
      (2 * std::size_t(this->Half[2]) + 1);
  }
  /** The place of a lag vector in an array of values. */
  std::size_t PlaceOf(int i, int j, int k) const
  {
    const std::size_t row = 2 * std::size_t(this->Half[0]) + 1;
    const std::size_t slice = row * (2 * std::size_t(this->Half[1]) + 1);
    return (k + this->Half[2]) * slice + (j + this->Half[1]) * row + (i + this->Half[0]);
  }
};

/**
 * Returns the exact S_rs(x) of a pack of spheres, as SumPairsAlong has it along a direction,
 * symmetrised over x and -x: the map is even, exactly, and S_rs = S_sr. Pairs with the matrix
 * follow from those of the particles as in TwoPointProbability::CompleteMatrix. Half is floor(reach
 * / spacing) along all axes.
 *
 * The result is equal, bit by bit, on every rank and for any number of ranks and threads.
 * Throws where `progress` says to stop. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for no pairs or pairs of phases that do not
 * exist, for a spacing or reach that is not finite and > 0, for a reach above LagLimit::ForMap or a
 * spacing below its finest, and for more than 5e7 numbers (voxels x pairs).
 */
ProbabilityMap MapPairs(const PackShare& share, const std::vector<std::array<int, 2>>& pairs,
  double spacing, double reach, Communicator& ranks, const SumProgress& progress = {});

/**
 * What MapPairs takes for `pairs` pairs of phases, with `resolution` voxels from the centre to a
 * face, which is `reach` away.
 */
Estimate EstimateMap(const PackFigures& pack, double reach, int pairs, int resolution);
}
