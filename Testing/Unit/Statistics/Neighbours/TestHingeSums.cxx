// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/HingeSums.h"

#include "Oracles.h"

namespace
{
using ruc::BlockHistogram;
using ruc::HingeSide;
using ruc::HingeSums;

// Uniform values from 0 to 1, as many in each of the blocks
BlockHistogram UniformValues(
  int blocks, int values, oracle::Uniform& random, std::vector<std::vector<double>>& drawn)
{
  BlockHistogram histogram(0.0, 1.0, blocks);
  drawn.resize(blocks);
  for (int block = 0; block < blocks; ++block)
  {
    histogram.Norm[block] = values;
    for (int n = 0; n < values; ++n)
    {
      drawn[block].push_back(random());
      ++histogram.Weight[block * BlockHistogram::Bins + histogram.BinOf(drawn[block].back())];
    }
  }
  return histogram;
}

double MeanHinge(const std::vector<double>& values, HingeSide side, double threshold)
{
  double sum = 0.0;
  for (double u : values)
  {
    sum += std::max(side == HingeSide::Below ? threshold - u : u - threshold, 0.0);
  }
  return sum / values.size();
}

TEST(HingeSums, AreTheMeansOfTheHinges)
{
  oracle::Uniform random(3);
  std::vector<std::vector<double>> drawn;
  const BlockHistogram histogram = UniformValues(6, 500, random, drawn);
  for (HingeSide side : { HingeSide::Below, HingeSide::Above })
  {
    const HingeSums sums = ruc::FindHingeSums(histogram, side, 0.0);
    ASSERT_EQ(sums.Size(), 21u);
    for (std::size_t j = 0; j < sums.Size(); ++j)
    {
      double mean = 0.0, squares = 0.0;
      for (const std::vector<double>& block : drawn)
      {
        const double value = MeanHinge(block, side, sums.Threshold[j]);
        mean += value / 6.0;
        squares += value * value / 6.0;
      }
      // Values stand for the middle of their bin
      EXPECT_NEAR(sums.Value[j], mean, 0.5 / BlockHistogram::Bins);
      // Of equal blocks the jackknife is the standard error of their mean
      EXPECT_NEAR(
        sums.Error[j], std::sqrt((squares - mean * mean) / 5.0), 0.5 / BlockHistogram::Bins);
    }
  }
}

TEST(HingeSums, ThresholdsAreTheDenserTheRarerTheValues)
{
  oracle::Uniform random(4);
  std::vector<std::vector<double>> drawn;
  const BlockHistogram histogram = UniformValues(4, 100000, random, drawn);
  const HingeSums below = ruc::FindHingeSums(histogram, HingeSide::Below, 0.0);
  const HingeSums above = ruc::FindHingeSums(histogram, HingeSide::Above, 0.0);
  ASSERT_EQ(below.Size(), 21u);
  ASSERT_EQ(above.Size(), 21u);
  for (int j = 0; j < 21; ++j)
  {
    const double share = std::pow(3.0 * (j + 1) / 64.0, 2);
    EXPECT_NEAR(below.Threshold[j], share, 0.004);
    EXPECT_NEAR(above.Threshold[20 - j], 1.0 - share, 0.004);
  }
  EXPECT_EQ(ruc::FindHingeSums(histogram, HingeSide::Below, 0.1).Size(), 15u); // from k = 21 on
}

TEST(HingeSums, WhatDoesNotScatterIsLeftOut)
{
  BlockHistogram histogram(0.0, 1.0, 3);
  EXPECT_TRUE(ruc::FindHingeSums(histogram, HingeSide::Below, 0.0).Empty());
  for (int block = 0; block < 3; ++block)
  {
    histogram.Norm[block] = 10.0;
    histogram.Weight[block * BlockHistogram::Bins + 100] = 60.0;
  }
  EXPECT_TRUE(ruc::FindHingeSums(histogram, HingeSide::Below, 0.0).Empty());
}

TEST(HingeSums, MisfitCountsStandardErrors)
{
  const HingeSums pack = { { 1.0, 2.0 }, { 0.5, 0.7 }, { 0.1, 0.2 } };
  std::vector<double> slopes;
  EXPECT_EQ(ruc::FindMisfit(pack, pack.Value, slopes), 0.0);
  EXPECT_NEAR(ruc::FindMisfit(pack, { 0.6, 0.3 }, slopes), (1.0 + 4.0) / 2.0, 1e-14);
  ASSERT_EQ(slopes.size(), 2u);
  EXPECT_NEAR(slopes[0], 10.0, 1e-12); // 2 z / (error J)
  EXPECT_NEAR(slopes[1], -10.0, 1e-12);
  EXPECT_EQ(ruc::FindMisfit({}, {}, slopes), 0.0);
}
}
