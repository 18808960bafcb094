// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/RadialDistribution.h"

#include "ruc/Base/FixedPointSums.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/WeightedPairs.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
int RadialDistribution::PairOf(int r, int s) const
{
  const int low = std::min(r, s);
  return low * this->Modes - low * (low - 1) / 2 + std::max(r, s) - low;
}

RadialDistribution MeasureRadialDistribution(
  const PackShare& share, const LagGrid& lags, Communicator& ranks, const SumProgress& progress)
{
  const int modes = share.NumberOfModes();
  CheckNumberOfLags(modes, lags);
  LagLimit::ForDistances(share.Observed, lags.Count).Check(lags);
  const std::size_t bins = static_cast<std::size_t>(lags.Count) + 1;
  const std::vector<double> unset(bins, std::numeric_limits<double>::quiet_NaN());
  RadialDistribution result{ lags, modes, {}, unset };
  result.Values.assign(modes * (modes + 1) / 2, unset);

  // Distances of centres count, whatever the radii
  const SizeClasses one((lags.Count + 0.5) * lags.Spacing);
  const WeightedPairs pairs(share, one, ranks, "MaximumLag");
  const std::size_t size = result.Values.size() * bins;
  const std::vector<std::int64_t> sums = pairs.Sum(size, ranks, progress,
    [&](std::size_t begin, std::size_t end, std::int64_t* own)
    {
      pairs.ForEach(begin, end,
        [&](std::size_t a, const PairNeighbourhood::Part& part, std::size_t b, const Vector3&,
          double d2, double weight)
        {
          const std::size_t bin = static_cast<std::size_t>(std::sqrt(d2) / lags.Spacing + 0.5);
          const int pair = result.PairOf(share.Own.Mode[a] - 1, part.Pack.Mode[b] - 1);
          // A distance just inside the last bin may be rounded up
          own[pair * bins + std::min(bin, bins - 1)] += RoundToFixedPoint(pairs.Scale * weight);
        });
    });

  const double volume = share.Observed.Volume();
  for (std::size_t k = 0; k < bins; ++k)
  {
    const double inner = k > 0 ? (k - 0.5) * lags.Spacing : 0.0;
    const double shell = SphereVolume((k + 0.5) * lags.Spacing) - SphereVolume(inner);
    double all = 0.0;
    for (int r = 0; r < modes; ++r)
    {
      for (int s = r; s < modes; ++s)
      {
        // The unordered pairs that were met are compared with those that there are
        const double number = r == s ? 0.5 * share.Count[r] * (share.Count[r] - 1.0)
                                     : double(share.Count[r]) * share.Count[s];
        const int pair = result.PairOf(r, s);
        const double sum = WideValue(&sums[2 * (pair * bins + k)]) / pairs.Scale;
        all += sum;
        if (number > 0.0)
        {
          result.Values[pair][k] = sum / (number * shell / volume);
        }
      }
    }
    const double number = 0.5 * share.NumberOfSpheres * (share.NumberOfSpheres - 1.0);
    if (number > 0.0)
    {
      result.Total[k] = all / (number * shell / volume);
    }
  }
  return result;
}

Estimate EstimateRadialDistribution(const PackFigures& pack, const LagGrid& lags)
{
  return { pack.PairsWithin(lags.Maximum()) * SecondsPerWeightedPair, 0.0, 0.0 };
}
}
