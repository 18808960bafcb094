// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/PairSums/SumRounds.h"
#include "ruc/Base/FixedPointSums.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/Results/LagGrid.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace ruc
{
/**
 * The pairs of a pack that are close enough to matter (SizeClasses), each with its weight V /
 * gamma(d), where V is the volume of the window of the centres and gamma its set covariance; and
 * how to add them up in FixedPointSums.
 */
class WeightedPairs
{
public:
  /**
   * Looks for the heaviest weight among all pairs. Pairs with a displacement that is `rim` or more
   * away from the cube of half edge `cube` around 0 are left out; all others must have a set
   * covariance > 0. Throws std::invalid_argument, the same on every rank, where a sphere may have
   * more than FixedPointSums::MostTerms others around it; the message blames `property`.
   * Collective.
   */
  WeightedPairs(const PackShare& share, const SizeClasses& classes, Communicator& ranks,
    const char* property, double cube = std::numeric_limits<double>::infinity(), double rim = 1.0);

  /** The same for all pairs closer than their reach, none of which weighs more than `heaviest`. */
  WeightedPairs(const PackShare& share, const SizeClasses& classes, double heaviest,
    Communicator& ranks, const char* property);

  PairNeighbourhood Pairs;
  /**
   * The factor that makes weights integers: twice the weight of any pair of any rank times Scale is
   * at most 2^FixedPointSums::TermBits.
   */
  double Scale;
  /**
   * How many own centres are taken between two calls of FixedPointSums::Take(Terms), if each pair,
   * and each centre with itself, adds at most that once to a sum.
   */
  std::size_t Step;
  std::int64_t Terms;

  /**
   * Calls visit(i, part, j, d, d2, weight) for every pair, as PairNeighbourhood::ForEachPair does.
   */
  template <class Visit>
  void ForEach(std::size_t begin, std::size_t end, Visit&& visit) const
  {
    this->Pairs.ForEachPair(begin, end,
      [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy,
        double dz, double d2)
      {
        const double x = std::max(std::abs(dx) - this->Cube, 0.0);
        const double y = std::max(std::abs(dy) - this->Cube, 0.0);
        const double z = std::max(std::abs(dz) - this->Cube, 0.0);
        if (x * x + y * y + z * z < this->Rim * this->Rim)
        {
          visit(i, part, j, Vector3{ dx, dy, dz }, d2,
            this->Periodic ? 1.0 : this->Volume / this->Observed.SetCovariance(dx, dy, dz));
        }
      });
  }

  /**
   * Returns `size` numbers summed over the own centres of all ranks, two limbs each (WideValue).
   * add(begin, end, sums) adds those of the places [begin, end), on any thread. Throws where
   * `progress` says to stop. Collective.
   */
  template <class Add>
  std::vector<std::int64_t> Sum(
    std::size_t size, Communicator& ranks, const SumProgress& progress, Add&& add) const
  {
    constexpr std::size_t chunkOfCentres = 64;
    std::vector<std::int64_t> sums(2 * size, 0);
    const std::size_t centres = this->Pairs.Size();
    const std::int64_t chunks =
      static_cast<std::int64_t>((centres + chunkOfCentres - 1) / chunkOfCentres);
    SumRounds rounds(this->Spheres, ranks, progress);
#pragma omp parallel
    {
      FixedPointSums own(size);
      for (int round = 0; rounds.GoOn(round); ++round)
      {
#pragma omp for schedule(dynamic)
        for (std::int64_t chunk = rounds.Begin(round, chunks);
             chunk < rounds.Begin(round + 1, chunks); ++chunk)
        {
          const std::size_t end = std::min((chunk + 1) * chunkOfCentres, centres);
          for (std::size_t i = chunk * chunkOfCentres; i < end; i += this->Step)
          {
            add(i, std::min(i + this->Step, end), own.Take(this->Terms));
          }
        }
      }
      const std::vector<std::int64_t>& wide = own.Finish();
#pragma omp critical
      std::transform(wide.begin(), wide.end(), sums.begin(), sums.begin(), std::plus<>());
    }
    rounds.RequireEnd();
    ranks.Sum(sums.data(), sums.size());
    return sums;
  }

private:
  void FindScale(double heaviest, Communicator& ranks, const char* property);

  Window Observed;
  double Cube, Rim, Volume;
  bool Periodic;
  std::int64_t Spheres; // on all ranks
};

/** The seconds that it takes to find a pair and hand it out by ForEach. */
constexpr double SecondsPerWeightedPair = 25e-9;

/**
 * The number of lags at which two spheres overlap when one of them is moved by the lag, at most
 * that of all lags.
 */
double LagsOfPair(const PackFigures& pack, const LagGrid& lags);
}
