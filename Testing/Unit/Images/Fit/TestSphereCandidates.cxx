// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/SphereCandidates.h"

#include "GreyScenes.h"
#include "ruc/Images/Fit/DistanceMap.h"

namespace
{
using ruc::Ball;

std::vector<Ball> RandomBalls(int count)
{
  oracle::Uniform random(11);
  std::vector<Ball> balls;
  for (int n = 0; n < count; ++n)
  {
    balls.push_back(
      { { random(-3.0, 30.0), random(-3.0, 30.0), random(-3.0, 30.0) }, random(1.0, 4.0) });
  }
  return balls;
}

double Apart(const Ball& a, const Ball& b)
{
  return std::hypot(
    a.Centre[0] - b.Centre[0], a.Centre[1] - b.Centre[1], a.Centre[2] - b.Centre[2]);
}
}

TEST(SphereCandidates, AreTheMaximaOfDistances)
{
  const oracle::GreyScene scene = oracle::SpheresInCells(3, 7.0, 0.0, 5);
  const std::vector<float> shares = oracle::SharesOf(scene);
  std::vector<Ball> whole;
  for (int size : { 1, 2, 3, 4 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const auto map = ruc::SquaredDistances(
          ruc::FindAbove(oracle::SlabOf(shares, scene.Dimensions, ranks), 0.5f), ranks);
        const std::vector<Ball> found =
          ruc::KeepFirstOfEach(ruc::FindMaxima(map, 2.0, { 1, 1, 1 }, ranks));
        if (size == 1)
        {
          whole = found;
        }
        EXPECT_TRUE(found == whole) << size;
      });
  }
  // Each sphere is found once, to two voxels
  EXPECT_EQ(whole.size(), scene.Balls.size());
  for (const Ball& ball : scene.Balls)
  {
    EXPECT_EQ(std::count_if(whole.begin(), whole.end(),
                [&](const Ball& other)
                { return Apart(ball, other) < 2.0 && std::abs(ball.Radius - other.Radius) < 1.0; }),
      1);
  }
}

TEST(SphereCandidates, OfThoseOfOneParticleTheFirstIsKept)
{
  const std::vector<Ball> balls = RandomBalls(400);
  std::vector<Ball> expected;
  for (const Ball& ball : balls)
  {
    const bool known = std::any_of(expected.begin(), expected.end(),
      [&](const Ball& other)
      {
        return Apart(ball, other) <
          std::max({ ball.Radius, other.Radius, 0.6 * (ball.Radius + other.Radius) });
      });
    if (!known)
    {
      expected.push_back(ball);
    }
  }
  EXPECT_TRUE(ruc::KeepFirstOfEach(balls) == expected);
}

TEST(SphereCandidates, DeepOverlapsFallFromTheSmallestOn)
{
  const std::vector<Ball> balls = { { { 0, 0, 0 }, 5.0 }, { { 6.0, 0, 0 }, 3.0 },
    { { 8.4, 0, 0 }, 1.0 }, { { 0, 9.5, 0 }, 5.0 }, { { 0, 0, 20.0 }, 2.0 } };
  // The second overlaps the first by 2, a third of its diameter; the third only the second, which
  // falls; the fourth by 0.5, a twentieth
  EXPECT_EQ(
    ruc::FindDeepOverlaps(balls, 0.2), (std::vector<bool>{ false, true, false, false, false }));
  // The second is kept, which the third overlaps by 1.6 of its diameter of 2
  EXPECT_EQ(
    ruc::FindDeepOverlaps(balls, 0.5), (std::vector<bool>{ false, false, true, false, false }));
}

TEST(SphereCandidates, DepthsOfOverlapAreThoseOfAllPairs)
{
  const std::vector<Ball> balls = RandomBalls(300);
  const std::vector<double> depths = ruc::FindOverlapDepths(balls);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    double deepest = 0.0;
    for (std::size_t j = 0; j < balls.size(); ++j)
    {
      deepest = i == j
        ? deepest
        : std::max(deepest, balls[i].Radius + balls[j].Radius - Apart(balls[i], balls[j]));
    }
    EXPECT_NEAR(depths[i], deepest, 1e-12);
  }
}
