// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"

namespace ruc
{
/**
 * Adds the pairs that centres [begin, end) of `cells` make to `histogram` (PairHistogram::Size()
 * integers), each with the weight `scale`. `types` holds the type of every sorted place. For a cell
 * list of a fully periodic box.
 */
void CountPairs(const PairHistogram& classes, const CellList& cells,
  const std::vector<std::int32_t>& types, double scale, std::size_t begin, std::size_t end,
  std::int64_t* histogram);

/**
 * The same for the own centres [begin, end) of a share of a pack and its surroundings, `types` for
 * every part. A pair weighs scale x V/gamma(d) with V the volume of `window` and gamma its set
 * covariance: 1 x scale where all axes are periodic.
 */
void CountPairs(const PairHistogram& classes, const PairNeighbourhood& pairs,
  const std::vector<std::vector<std::int32_t>>& types, const Window& window, double scale,
  std::size_t begin, std::size_t end, std::int64_t* histogram);

/**
 * A pair potential in the form that AddPairForces reads: from `potential`, a function on the knots
 * of all classes, four numbers a knot with which its derivative after the distance is c0 + t (c1 +
 * t c2), t in [0, 1) the place between this knot and the next. Returns a bound of that derivative's
 * magnitude.
 */
double FindSlopes(
  const PairHistogram& classes, const std::vector<double>& potential, std::vector<double>& slopes);

/**
 * Adds the derivative of a potential's sum over the pairs that centres [begin, end) make to
 * `gradient`: scale x the derivative after x, y, z and an unused number for each sorted place, in
 * fixed point. All axes periodic.
 */
void AddPairForces(const PairHistogram& classes, const CellList& cells,
  const std::vector<std::int32_t>& types, const std::vector<double>& slopes, double scale,
  std::size_t begin, std::size_t end, std::int64_t* gradient);

/** Seconds that a pair takes to be found and added to a histogram. */
constexpr double SecondsPerHistogramPair = 9.5e-9;
}
