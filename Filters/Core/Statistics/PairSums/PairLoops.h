// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"

namespace ruc
{
/**
 * Adds the pairs that the centres at places [begin, end) of `cells` make to `histogram`,
 * PairHistogram::Size() integers, each with the weight `scale`. `types` holds the type at every
 * sorted place. The cell list must be of a fully periodic box.
 */
void CountPairs(const PairHistogram& classes, const CellList& cells,
  const std::vector<std::int32_t>& types, double scale, std::size_t begin, std::size_t end,
  std::int64_t* histogram);

/**
 * The same for the own centres at places [begin, end) of a share of a pack and its surroundings,
 * with `types` for every part. A pair weighs scale x V/gamma(d), with V the volume of `window` and
 * gamma its set covariance, which is `scale` where all axes are periodic.
 */
void CountPairs(const PairHistogram& classes, const PairNeighbourhood& pairs,
  const std::vector<std::vector<std::int32_t>>& types, const Window& window, double scale,
  std::size_t begin, std::size_t end, std::int64_t* histogram);

/**
 * Brings a pair potential into the form that AddPairForces reads. `potential` is a function on the
 * knots of all classes. `slopes` becomes four numbers for each knot, of which the first three are
 * c0, c1 and c2: the derivative with respect to distance is c0 + t (c1 + t c2), where t in [0, 1)
 * is the position between this knot and the next. Returns an upper bound of the derivative's
 * magnitude.
 */
double FindSlopes(
  const PairHistogram& classes, const std::vector<double>& potential, std::vector<double>& slopes);

/**
 * Adds the derivative of a potential's sum over the pairs that the centres [begin, end) make to
 * `gradient`. For each sorted place it holds four integers: scale x the derivative with respect to
 * x, y and z, and an unused number. All axes must be periodic.
 */
void AddPairForces(const PairHistogram& classes, const CellList& cells,
  const std::vector<std::int32_t>& types, const std::vector<double>& slopes, double scale,
  std::size_t begin, std::size_t end, std::int64_t* gradient);

/** The seconds that it takes to find a pair and add it to a histogram. */
constexpr double SecondsPerHistogramPair = 9.5e-9;
}
