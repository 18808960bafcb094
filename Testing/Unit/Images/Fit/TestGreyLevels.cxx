// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/GreyLevels.h"

#include "GreyScenes.h"

namespace
{
// Two halves with normal noise
std::vector<float> Halves(double noise, std::size_t count)
{
  oracle::Uniform random(9);
  std::vector<float> values(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const double normal =
      std::sqrt(-2.0 * std::log(1.0 - random())) * std::cos(2.0 * oracle::Pi * random());
    values[k] = static_cast<float>((k < count / 2 ? 10.0 : 30.0) + noise * normal);
  }
  return values;
}
}

TEST(GreyLevels, AreThoseOfTwoNormalPhases)
{
  const std::array<int, 3> n = { 40, 40, 40 };
  for (double noise : { 0.5, 2.0, 4.0 })
  {
    const std::vector<float> values = Halves(noise, 64000);
    ruc::Communicator one;
    const ruc::GreyLevels levels = ruc::FindGreyLevels(oracle::SlabOf(values, n, one), one);
    // Medians and noise to five standard errors of 32 000 values and what a class is wide
    const double error = 5.0 * 1.25 * noise / std::sqrt(32000.0) + 0.02;
    EXPECT_NEAR(
      levels.Below, 10.0, error + (noise > 3.0 ? 0.15 : 0.0)); // tails beyond the threshold
    EXPECT_NEAR(levels.Above, 30.0, error + (noise > 3.0 ? 0.15 : 0.0));
    EXPECT_NEAR(levels.Noise, noise, 0.02 * noise + 0.02);
    EXPECT_NEAR(levels.Threshold, 20.0, noise);
    EXPECT_FALSE(levels.TwoValues);
    for (int size : { 2, 3 })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          const ruc::GreyLevels other =
            ruc::FindGreyLevels(oracle::SlabOf(values, n, ranks), ranks);
          EXPECT_EQ(other.Threshold, levels.Threshold);
          EXPECT_EQ(other.Noise, levels.Noise);
          EXPECT_EQ(other.Below, levels.Below);
          EXPECT_EQ(other.Above, levels.Above);
        });
    }
  }
}

TEST(GreyLevels, DoNotHeedAFewOddVoxels)
{
  ruc::Communicator one;
  std::vector<float> values = Halves(1.0, 64000);
  values[100] = 1e6f;
  values[50000] = -1e6f;
  const auto levels = ruc::FindGreyLevels(oracle::SlabOf(values, { 40, 40, 40 }, one), one);
  EXPECT_NEAR(levels.Threshold, 20.0, 1.0);
  EXPECT_NEAR(levels.Below, 10.0, 0.1);
  EXPECT_NEAR(levels.Noise, 1.0, 0.05);
}

TEST(GreyLevels, KnowTwoValuesAndOne)
{
  ruc::Communicator one;
  std::vector<float> values(1000, 3.0f);
  EXPECT_SAYS(
    ruc::FindGreyLevels(oracle::SlabOf(values, { 10, 10, 10 }, one), one), "got one grey only, 3.");
  values[7] = 5.0f;
  const auto levels = ruc::FindGreyLevels(oracle::SlabOf(values, { 10, 10, 10 }, one), one);
  EXPECT_TRUE(levels.TwoValues);
  EXPECT_GT(levels.Threshold, 3.0);
  EXPECT_LT(levels.Threshold, 5.0);
  EXPECT_EQ(levels.Noise, 0.0);
}

TEST(GreyLevels, SmoothingIsTheMeanWithWeights121)
{
  const std::array<int, 3> n = { 5, 4, 6 };
  oracle::Uniform random(4);
  std::vector<float> values(5 * 4 * 6);
  std::generate(values.begin(), values.end(), [&]() { return static_cast<float>(random()); });
  const auto at = [&](int x, int y, int z)
  { return values[(std::clamp(z, 0, 5) * 4 + std::clamp(y, 0, 3)) * 5 + std::clamp(x, 0, 4)]; };
  std::vector<float> smooth;
  for (int k = 0; k < 120; ++k)
  {
    const int x = k % 5, y = k / 5 % 4, z = k / 20;
    double sum = 0.0;
    for (int d = 0; d < 27; ++d)
    {
      const int u = d % 3 - 1, v = d / 3 % 3 - 1, w = d / 9 - 1;
      sum += at(x + u, y + v, z + w) * (2 - std::abs(u)) * (2 - std::abs(v)) * (2 - std::abs(w));
    }
    smooth.push_back(static_cast<float>(sum / 64.0));
  }
  const auto run = [&](int size)
  {
    return oracle::Together<float>(size,
      [&](ruc::Communicator& ranks)
      {
        ruc::VoxelSlab<float> slab = oracle::SlabOf(values, n, ranks);
        ruc::SetHalo(slab, 1, ranks);
        ruc::Smooth(slab);
        ruc::SetHalo(slab, 0, ranks);
        return slab.Values;
      });
  };
  const std::vector<float> once = run(1);
  for (std::size_t k = 0; k < once.size(); ++k)
  {
    EXPECT_NEAR(once[k], smooth[k], 1e-6);
  }
  EXPECT_EQ(run(2), once);
  EXPECT_EQ(run(4), once);
}

TEST(GreyLevels, SmoothingIsAskedForByTheNoise)
{
  EXPECT_EQ(ruc::SmoothingFor(0.0), 0);
  EXPECT_EQ(ruc::SmoothingFor(0.11), 0);
  EXPECT_EQ(ruc::SmoothingFor(0.3), 1);
  EXPECT_EQ(ruc::SmoothingFor(0.8), 2);
  EXPECT_EQ(ruc::SmoothingFor(5.0), 3);
}
