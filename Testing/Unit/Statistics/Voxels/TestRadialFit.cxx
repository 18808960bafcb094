// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Voxels/RadialFit.h"

#include "ruc/Statistics/Voxels/ImageLags.h"

#include "Oracles.h"

#include <limits>

TEST(RadialFit, FindsAFunctionThatIsLinearBetweenLags)
{
  const ruc::LagGrid lags = { 1.5, 4 };
  const std::vector<double> knots = { 0.3, -1.0, 2.0, 0.5, 0.7 };
  std::vector<double> lengths = { 0.0, std::numeric_limits<double>::quiet_NaN() },
                      values = { 9.0, 9.0 };
  for (double length = 0.7; length <= 6.0; length += 0.41)
  {
    const int k = static_cast<int>(length / 1.5);
    const double b = length / 1.5 - k;
    lengths.push_back(length);
    values.push_back((1.0 - b) * knots[k] + b * knots[std::min(k + 1, 4)]);
  }
  const std::vector<double> found = ruc::FitRadial(lengths, values, 0.3, lags);
  for (int k = 0; k <= 4; ++k)
  {
    EXPECT_NEAR(found[k], knots[k], 1e-13) << k;
  }
}

TEST(RadialFit, NothingNearIsBetter)
{
  // The sum of squares does not fall when any value is moved
  const ruc::LagGrid lags = { 1.0, 5 };
  oracle::Uniform random(1);
  std::vector<double> lengths, values;
  for (int n = 0; n < 60; ++n)
  {
    lengths.push_back(random(0.1, 5.0));
    values.push_back(random());
  }
  const auto sum = [&](const std::vector<double>& fit)
  {
    double squares = 0.0;
    for (std::size_t n = 0; n < lengths.size(); ++n)
    {
      const int k = static_cast<int>(lengths[n]);
      const double b = lengths[n] - k;
      squares += std::pow(((1.0 - b) * fit[k] + b * fit[k + 1] - values[n]) / lengths[n], 2);
    }
    return squares;
  };
  const std::vector<double> best = ruc::FitRadial(lengths, values, 0.5, lags);
  EXPECT_EQ(best[0], 0.5);
  for (int k = 1; k <= 5; ++k)
  {
    for (double step : { -1e-3, 1e-3 })
    {
      std::vector<double> other = best;
      other[k] += step;
      EXPECT_GT(sum(other), sum(best)) << k;
    }
  }
}

TEST(ImageLags, TakesALagAVoxel)
{
  const ruc::ImageLags lags = ruc::FindImageLags({ 513, 457, 280 }, { 2.0, 2.0, 2.0 }, 0.0, 0);
  EXPECT_EQ(lags.Lags.Count, 70);
  EXPECT_EQ(lags.Lags.Spacing, 2.0);
  EXPECT_EQ(lags.Last, (std::array<int, 3>{ 70, 70, 70 }));
  EXPECT_EQ(lags.Shells(), 4901);
  EXPECT_EQ(lags.ShellOf(-3, 0, 4), 25);
  EXPECT_EQ(lags.ShellOf(70, 1, 0), -1);
  EXPECT_EQ(lags.ShellLengths()[25], 10.0);
  EXPECT_TRUE(std::isnan(lags.ShellLengths()[7])); // no three squares make 7

  const ruc::ImageLags flat = ruc::FindImageLags({ 20, 30, 1 }, { 1.0, 1.0, 5.0 }, 7.5, 3);
  EXPECT_EQ(flat.Lags.Spacing, 2.5);
  EXPECT_EQ(flat.Last, (std::array<int, 3>{ 7, 7, 0 }));
}

TEST(ImageLags, RefusesWhatHasNoVoxels)
{
  const ruc::Vector3 unit = { 1, 1, 1 };
  EXPECT_SAYS(ruc::FindImageLags({ 1, 1, 1 }, unit, 0.0, 0), "more than one voxel");
  EXPECT_SAYS(ruc::FindImageLags({ 9, 20, 20 }, unit, 4.6, 0),
    "half the shortest edge of the image that has several voxels, 4.5, got 4.6");
  EXPECT_SAYS(ruc::FindImageLags({ 9, 20, 20 }, unit, -1.0, 0), "got -1");
  EXPECT_SAYS(ruc::FindImageLags({ 9, 20, 20 }, unit, std::numeric_limits<double>::quiet_NaN(), 0),
    "got nan");
  EXPECT_SAYS(
    ruc::FindImageLags({ 9, 20, 20 }, unit, 0.5, 0), "at least the edge of a voxel, 1, got 0.5");
  EXPECT_SAYS(ruc::FindImageLags({ 9, 20, 20 }, unit, 4.0, 5), "up to one lag a voxel, 4, got 5");
  EXPECT_SAYS(ruc::FindImageLags({ 9, 20, 20 }, unit, 4.0, -1), "got -1");
}
