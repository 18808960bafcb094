// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Comparison/GapCounts.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/Results/TaperedBlocks.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

namespace ruc
{
namespace
{
constexpr double LeastBlockEdge = 2.0; // in mean diameters, as of FindPairSumErrors
constexpr int WeightBits = 24;

// For each cell of the blocks, or for all, the number of spheres and of pairs up to each gap
std::vector<double> SumOverCells(const PackShare& share, const std::vector<double>& gaps,
  const std::optional<TaperedBlocks>& blocks, Communicator& ranks)
{
  const std::size_t stride = gaps.size() + 1;
  std::vector<std::int64_t> sums(stride * (blocks ? blocks->Cells() : 1), 0);
  const Surroundings around(share, 2.0 * share.LargestRadius * (1.0 + gaps.back()), ranks);
  const Window& window = share.Observed;
  const bool periodic = window.IsFullyPeriodic();
  const double volume = window.Volume();
  const std::int64_t centres = static_cast<std::int64_t>(around.Size());
#pragma omp parallel
  {
    std::vector<std::int64_t> own(sums.size(), 0);
#pragma omp for schedule(dynamic, 64) nowait
    for (std::int64_t place = 0; place < centres; ++place)
    {
      const std::size_t i = around.PlaceOf(place);
      std::int64_t* of = &own[stride * (blocks ? blocks->CellOf(share.Own.Centre(i)) : 0)];
      ++of[0];
      around.ForEachAround(place,
        [&](const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz,
          double d2)
        {
          const double gap = std::sqrt(d2) / (share.Own.Radius[i] + part.Pack.Radius[j]) - 1.0;
          if (gap <= gaps.back())
          {
            const double weight = periodic ? 1.0 : volume / window.SetCovariance(dx, dy, dz);
            const std::int64_t term = RoundToFixedPoint(std::ldexp(weight, WeightBits));
            for (std::size_t n = gaps.size(); n > 0 && gap <= gaps[n - 1]; --n)
            {
              of[n] += term;
            }
          }
        });
    }
#pragma omp critical
    std::transform(own.begin(), own.end(), sums.begin(), sums.begin(), std::plus<>());
  }
  ranks.Sum(sums.data(), sums.size());
  std::vector<double> values;
  values.reserve(sums.size());
  for (std::size_t n = 0; n < sums.size(); ++n)
  {
    values.push_back(std::ldexp(static_cast<double>(sums[n]), n % stride == 0 ? 0 : -WeightBits));
  }
  return values;
}
}

std::vector<ValueWithError> CountGaps(
  const PackShare& share, const std::vector<double>& gaps, int number, Communicator& ranks)
{
  std::optional<TaperedBlocks> blocks;
  if (number > 0)
  {
    blocks.emplace(share.Observed, number, LeastBlockEdge * share.MeanDiameter(), "Blocks");
  }
  const std::vector<double> sums = SumOverCells(share, gaps, blocks, ranks);
  const std::size_t stride = gaps.size() + 1, cells = sums.size() / stride;
  std::vector<ValueWithError> counts;
  for (std::size_t n = 1; n < stride; ++n)
  {
    double pairs = 0.0;
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      pairs += sums[cell * stride + n];
    }
    const double spheres = static_cast<double>(share.NumberOfSpheres), mean = pairs / spheres;
    double error = std::numeric_limits<double>::quiet_NaN();
    if (blocks)
    {
      std::vector<double> parts(blocks->Count(), 0.0);
      for (std::size_t cell = 0; cell < cells; ++cell)
      {
        const double* of = &sums[cell * stride];
        blocks->ForEachBlock(static_cast<int>(cell),
          [&](int block, int weight)
          { parts[block] += (of[n] - mean * of[0]) * weight / TaperedBlocks::WholeWeight; });
      }
      error = std::sqrt(blocks->VarianceOfSum(parts)) / spheres;
    }
    counts.push_back({ mean, error });
  }
  return counts;
}
}
