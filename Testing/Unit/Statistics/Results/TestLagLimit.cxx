// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/LagLimit.h"

#include "Oracles.h"

using ruc::LagLimit;
using ruc::Window;

namespace
{
const Window Periodic = oracle::PeriodicCube(10.0);
const Window Open = Window::MakeBox({ 0, 0, 0 }, { 10, 12, 14 }, { false, false, false });
const Window Slab = Window::MakeBox({ 0, 0, 0 }, { 10, 12, 14 }, { true, true, false });
}

TEST(LagLimit, OfAPairSumLeavesADiameter)
{
  EXPECT_DOUBLE_EQ(LagLimit::ForPairSum(Periodic, 1.0).Largest, 40.0);
  EXPECT_NEAR(LagLimit::ForPairSum(Open, 1.0).Largest, 0.999 * 8.0, 1e-12);
  EXPECT_NEAR(LagLimit::ForPairSum(Slab, 1.0).Largest, 0.999 * 12.0, 1e-12);
  EXPECT_LT(LagLimit::ForPairSum(Slab, 1.0).Largest, 12.0);
}

TEST(LagLimit, OfDistancesLeavesHalfABin)
{
  const double largest = LagLimit::ForDistances(Open, 5).Largest;
  EXPECT_NEAR(largest + 0.5 * largest / 5, 0.999 * 10.0, 1e-12);
}

TEST(LagLimit, OfSamplesLeavesTheirMargins)
{
  EXPECT_DOUBLE_EQ(LagLimit::ForSampling(Open, Open.Shrunk(1.0)).Largest, 0.999 * 8.0);
  EXPECT_DOUBLE_EQ(LagLimit::ForFans(Open, Open.Shrunk(1.0)).Largest, 0.4995 * 8.0);
  EXPECT_DOUBLE_EQ(LagLimit::ForSampling(Periodic, Periodic.Shrunk(1.0)).Largest, 40.0);
  EXPECT_DOUBLE_EQ(LagLimit::ForFans(Periodic, Periodic).Largest, 40.0);
}

TEST(LagLimit, AutomaticIsHalfTheWindowWhereThatIsAllowed)
{
  EXPECT_EQ(LagLimit::ForPairSum(Open, 1.0).Automatic, 5.0);
  EXPECT_EQ(LagLimit::ForPairSum(Open, 4.0).Automatic, LagLimit::ForPairSum(Open, 4.0).Largest);
  EXPECT_EQ(LagLimit::ForSampling(Open, Open.Shrunk(1.0)).Automatic, 5.0);
  EXPECT_DOUBLE_EQ(LagLimit::ForSampling(Open, Open.Shrunk(4.0)).Automatic, 0.999 * 2.0);
  EXPECT_EQ(LagLimit::ForFans(Open, Open.Shrunk(1.0)).Automatic, 2.5);
  EXPECT_EQ(LagLimit::ForFans(Periodic, Periodic).Automatic, 5.0);
  EXPECT_EQ(LagLimit::ForMap(Open, 1.0, 3.0).Automatic, 3.0);
  EXPECT_EQ(LagLimit::ForMap(Open, 1.0, 9.0).Automatic, LagLimit::ForMap(Open, 1.0).Largest);
  EXPECT_EQ(LagLimit::ForCell(7.0).Automatic, 3.5);
}

TEST(LagLimit, GridsReachTheLagThatIsAskedFor)
{
  const LagLimit limit = LagLimit::ForPairSum(Open, 1.0);
  EXPECT_EQ(limit.MakeGrid(0.0, 10).Spacing, 0.5);
  EXPECT_EQ(limit.MakeGrid(2.0, 10).Spacing, 0.2);
  EXPECT_EQ(limit.MakeGrid(2.0, 10).Count, 10);
  EXPECT_SAYS(limit.MakeGrid(-1.0, 10), "MaximumLag requires a finite number >= 0");
  EXPECT_SAYS(limit.MakeGrid(std::nan(""), 10), "MaximumLag requires a finite number >= 0");
  EXPECT_SAYS(limit.MakeGrid(1.0, 0), "NumberOfLags requires 1 <= NumberOfLags <= 100000, got 0");
  EXPECT_SAYS(limit.MakeGrid(1.0, 100001), "got 100001");
  EXPECT_SAYS(LagLimit::ForPairSum(Open, 5.0).MakeGrid(0.0, 10),
    "edges longer than the largest sphere's diameter, 10, got a box window 10 x 12 x 14.");
}

TEST(LagLimit, ChecksSayWhatIsAllowed)
{
  const LagLimit limit = LagLimit::ForPairSum(Periodic, 1.0);
  EXPECT_NO_THROW(limit.Check(40.0));
  EXPECT_NO_THROW(limit.Check(40.0 * (1.0 + 1e-13))); // K spacings that were rounded
  EXPECT_SAYS(limit.Check(40.1), "MaximumLag requires 0 < MaximumLag <= 40 for this periodic box");
  EXPECT_SAYS(limit.Check(0.0), "MaximumLag requires 0 < MaximumLag <= 40");
  EXPECT_SAYS(limit.Check(std::nan("")), "got nan");
  EXPECT_SAYS(LagLimit::ForPairSum(Open, 5.0).Check(1.0), "edges longer than the largest sphere");
  EXPECT_SAYS(LagLimit::ForMap(Open, 1.0).Check(9.0),
    "Spacing x Resolution requires a length > 0 and <= 7.992");
  EXPECT_SAYS(
    LagLimit::ForDistances(Open, 5).Check(10.0), "for distances of centres in this box window");
}

TEST(LagLimit, LagsThatRoundingWouldMixAreRefused)
{
  const LagLimit limit = LagLimit::ForPairSum(Periodic, 1.0);
  EXPECT_NO_THROW(limit.Check(ruc::LagGrid{ 1.1e-8, 277 }));
  EXPECT_SAYS(limit.Check(ruc::LagGrid{ 0.9e-8, 277 }),
    "MaximumLag / NumberOfLags requires at least 1e-08 for this periodic box");
  EXPECT_SAYS(limit.Check(ruc::LagGrid{ 1e-300, 10 }), "got 1e-300");
  EXPECT_SAYS(LagLimit::ForMap(Open, 1.0).CheckSpacing(1e-300), "Spacing requires at least 1e-08");
  EXPECT_SAYS(LagLimit::ForSampling(Open, Open).Check(ruc::LagGrid{ 1e-300, 10 }), "at least");
  EXPECT_SAYS(LagLimit::ForFans(Open, Open).Check(ruc::LagGrid{ 1e-300, 10 }), "at least");
  EXPECT_SAYS(LagLimit::ForDistances(Open, 5).Check(ruc::LagGrid{ 1e-300, 10 }), "at least");
}

TEST(LagLimit, OfACellIsTwoOfItsEdges)
{
  EXPECT_NO_THROW(LagLimit::ForCell(184.0).Check(ruc::LagGrid{ 3.67, 100 }));
  EXPECT_SAYS(LagLimit::ForCell(184.0).Check(ruc::LagGrid{ 5.0, 100 }),
    "MaximumLag requires 0 < MaximumLag <= 368 for a cell of edge 184, got 500.");
}

TEST(LagLimit, ReachIsWhatTheWindowAllows)
{
  const std::vector<Window> windows = {
    Window::MakeBox({ 0, 0, 0 }, { 10, 12, 14 }, { false, false, false }),
    Window::MakeBox({ 0, 0, 0 }, { 10, 12, 14 }, { true, false, true }),
    Window::MakeCylinder({ 0, 0, 0 }, { 0, 0, 1 }, 5.0, 30.0),
    Window::MakeCylinder({ 0, 0, 0 }, { 0.3, -0.2, 1.0 }, 50.0, 8.0),
    Window::MakeCylinder({ 0, 0, 0 }, { -1.0, 0.7, 0.1 }, 5.0, 30.0),
  };
  for (const Window& window : windows)
  {
    const double reach = LagLimit::ForMap(window, 0.5).Largest;
    double least[2] = { 1e300, 1e300 };
    oracle::Uniform random(3);
    for (int n = 0; n < 200000; ++n)
    {
      const ruc::Vector3 u = random.Direction();
      for (int longer : { 0, 1 })
      {
        const double edge = longer ? 1.01 * reach : reach;
        ruc::Vector3 d;
        for (int q = 0; q < 3; ++q)
        {
          d[q] = (n >> q & 1 ? edge : -edge) + u[q];
        }
        least[longer] = std::min(least[longer], window.SetCovariance(d[0], d[1], d[2]));
      }
    }
    EXPECT_GT(least[0], 0.0) << window.Describe();
    EXPECT_EQ(least[1], 0.0) << window.Describe();
  }
  EXPECT_EQ(LagLimit::ForMap(oracle::PeriodicCube(10.0), 0.5).Largest, 40.0);
}
