// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/HingeSums.h"

#include "ruc/Statistics/Results/Jackknife.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
// The weights of all blocks
std::vector<double> SumOfBlocks(const BlockHistogram& histogram)
{
  std::vector<double> sum(BlockHistogram::Bins, 0.0);
  for (int block = 0; block < histogram.Blocks; ++block)
  {
    std::transform(sum.begin(), sum.end(),
      histogram.Weight.begin() + std::size_t(block) * BlockHistogram::Bins, sum.begin(),
      std::plus<>());
  }
  return sum;
}

std::vector<double> FindThresholds(const BlockHistogram& histogram, HingeSide side)
{
  const std::vector<double> weights = SumOfBlocks(histogram);
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double width = (histogram.High - histogram.Low) / BlockHistogram::Bins;
  std::vector<double> thresholds;
  double counted = 0.0;
  int k = 3;
  for (int n = 0; n < BlockHistogram::Bins && k < 64; ++n)
  {
    const int bin = side == HingeSide::Below ? n : BlockHistogram::Bins - 1 - n;
    counted += weights[bin];
    const double edge =
      histogram.Low + (side == HingeSide::Below ? bin + 1 : bin) * width; // behind the bin
    for (; k < 64 && counted > 0.0 && counted >= all * k * k / 4096.0; k += 3)
    {
      thresholds.push_back(edge);
    }
  }
  std::sort(thresholds.begin(), thresholds.end());
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  return thresholds;
}

// The hinge sum of each block, not divided by its norm
std::vector<double> SumsOfBlocks(const BlockHistogram& histogram, HingeSide side, double threshold)
{
  std::vector<double> sums(histogram.Blocks, 0.0);
  for (int block = 0; block < histogram.Blocks; ++block)
  {
    const double* const weights = &histogram.Weight[std::size_t(block) * BlockHistogram::Bins];
    for (int bin = 0; bin < BlockHistogram::Bins; ++bin)
    {
      const double u = histogram.ValueOf(bin);
      const double hinge = side == HingeSide::Below ? threshold - u : u - threshold;
      sums[block] += weights[bin] * std::max(hinge, 0.0);
    }
  }
  return sums;
}

}

BlockHistogram::BlockHistogram(double low, double high, int blocks)
  : Low(low)
  , High(high)
  , Blocks(blocks)
  , Weight(std::size_t(blocks) * Bins, 0.0)
  , Norm(blocks, 0.0)
{
}

int BlockHistogram::BinOf(double value) const
{
  const double place = (value - this->Low) / (this->High - this->Low) * Bins;
  return static_cast<int>(std::clamp(std::floor(place), 0.0, Bins - 1.0));
}

double BlockHistogram::ValueOf(int bin) const
{
  return this->Low + (bin + 0.5) * (this->High - this->Low) / Bins;
}

HingeSums FindHingeSums(const BlockHistogram& histogram, HingeSide side, double least)
{
  HingeSums found;
  const double norm = std::accumulate(histogram.Norm.begin(), histogram.Norm.end(), 0.0);
  if (!(norm > 0.0))
  {
    return found;
  }
  for (double threshold : FindThresholds(histogram, side))
  {
    const std::vector<double> sums = SumsOfBlocks(histogram, side, threshold);
    const auto [value, error] = JackknifeRatio(sums, histogram.Norm);
    if (threshold >= least && error > 1e-9 * value)
    {
      found.Threshold.push_back(threshold);
      found.Value.push_back(value);
      found.Error.push_back(error);
    }
  }
  return found;
}

double FindMisfit(
  const HingeSums& pack, const std::vector<double>& values, std::vector<double>& slopes)
{
  const double thresholds = static_cast<double>(pack.Size());
  double misfit = 0.0;
  slopes.resize(pack.Size());
  for (std::size_t j = 0; j < pack.Size(); ++j)
  {
    const double z = (values[j] - pack.Value[j]) / pack.Error[j];
    misfit += z * z / thresholds;
    slopes[j] = 2.0 * z / (pack.Error[j] * thresholds);
  }
  return misfit;
}
}
