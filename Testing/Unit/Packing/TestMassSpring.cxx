// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/MassSpring.h"

#include "Oracles.h"
#include "ruc/Packing/OverlapRemoval.h"

namespace
{
void ExpectInBox(const ruc::SpherePack& pack, const ruc::Window& box)
{
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    for (int q = 0; q < 3; ++q)
    {
      EXPECT_GE(pack.Centre(i)[q], box.Origin[q]);
      EXPECT_LT(pack.Centre(i)[q], box.Origin[q] + box.Size[q]);
    }
  }
}
}

TEST(MassSpring, EndsWithoutOverlap)
{
  struct Case
  {
    std::vector<int> Counts;
    std::vector<double> Radii;
  };
  const Case cases[] = { { { 150 }, { 1.0 } }, { { 1000 }, { 1.0 } },
    { { 200, 800 }, { 1.0, 0.55 } }, { { 20, 60, 100 }, { 1.2, 0.8, 0.5 } } };
  for (const Case& c : cases)
  {
    for (double fraction : { 0.3, 0.55, 0.6, 0.62 })
    {
      const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor(c.Counts, c.Radii, fraction));
      ruc::SpherePack pack = oracle::RandomPack(c.Counts, c.Radii, box, 33);
      EXPECT_FALSE(ruc::MeasureOverlap(pack, box).IsNone());
      EXPECT_TRUE(ruc::MoveBySpringsUntilFree(pack, box, 7)) << fraction;
      EXPECT_TRUE(ruc::MeasureOverlap(pack, box).IsNone()) << fraction;
      EXPECT_GE(pack.Size() < 200 ? oracle::LeastGap(pack, box) : 0.0, 0.0) << fraction;
      ExpectInBox(pack, box);
    }
  }
}

TEST(MassSpring, TwoSpheresPartAlongTheirLineOfCentresThroughAFace)
{
  ruc::SpherePack pack;
  pack.X = { 0.3, 9.6 };
  pack.Y = { 5.0, 5.3 };
  pack.Z = { 5.0, 5.0 };
  pack.Radius = { 1.0, 0.5 };
  const ruc::Window box = oracle::PeriodicCube(10.0);
  EXPECT_LT(ruc::MoveBySprings(pack, box, 1000), 1000);
  EXPECT_GE(oracle::LeastGap(pack, box), 0.0);
  const double dx = pack.X[1] - 10.0 - pack.X[0], dy = pack.Y[1] - pack.Y[0];
  // Forces are opposite, so the centre of equal masses stays; and they lie on the line
  EXPECT_NEAR(pack.X[0] + pack.X[1] - 10.0, -0.1, 1e-12);
  EXPECT_NEAR(pack.Y[0] + pack.Y[1], 10.3, 1e-12);
  EXPECT_NEAR(dy / dx, 0.3 / -0.7, 1e-12);
  EXPECT_EQ(pack.Z, (std::vector<double>{ 5.0, 5.0 }));
  // No farther than the inertia of a damped motion takes them
  EXPECT_LT(std::hypot(dx, dy), 1.5 * 1.5);
}

TEST(MassSpring, APackWithoutOverlapStaysAsItIs)
{
  const ruc::Window box = oracle::PeriodicCube(12.0);
  const ruc::SpherePack free = oracle::RelaxedPack({ 20, 30 }, { 1.0, 0.6 }, box, 3);
  ruc::SpherePack pack = free;
  EXPECT_EQ(ruc::MoveBySprings(pack, box, 10), 0);
  EXPECT_TRUE(ruc::MoveBySpringsUntilFree(pack, box, 1));
  EXPECT_EQ(pack.X, free.X);
  EXPECT_EQ(pack.Y, free.Y);
  EXPECT_EQ(pack.Z, free.Z);
  ruc::SpherePack none;
  EXPECT_EQ(ruc::MoveBySprings(none, box, 10), 0);
}

TEST(MassSpring, EndsAfterTheStepsItIsGiven)
{
  const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor({ 16 }, { 1.0 }, 0.8)); // impossible
  ruc::SpherePack pack = oracle::RandomPack({ 16 }, { 1.0 }, box, 3);
  EXPECT_EQ(ruc::MoveBySprings(pack, box, 50), 50);
  EXPECT_FALSE(ruc::MeasureOverlap(pack, box).IsNone());
  ExpectInBox(pack, box);
}

TEST(MassSpring, StopsWhenItIsTold)
{
  const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor({ 16 }, { 1.0 }, 0.8)); // impossible
  const ruc::SpherePack start = oracle::RandomPack({ 16 }, { 1.0 }, box, 3);
  // It is stopped among the steps, and while overlap is removed another way after the 2000th
  for (int stopAt : { 1, 5, 250 })
  {
    ruc::SpherePack pack = start;
    int calls = 0;
    EXPECT_FALSE(ruc::MoveBySpringsUntilFree(pack, box, 1, [&]() { return ++calls < stopAt; }));
    EXPECT_GE(calls, stopAt);
    EXPECT_LE(calls, stopAt + 1); // one call by springs, and one by the other way
  }
}

TEST(MassSpring, LessOverlapWithMoreSteps)
{
  const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor({ 200 }, { 1.0 }, 0.6));
  const ruc::SpherePack start = oracle::RandomPack({ 200 }, { 1.0 }, box, 3);
  double last = ruc::MeasureOverlap(start, box).Percent;
  for (int steps : { 10, 30, 100 })
  {
    ruc::SpherePack pack = start;
    ruc::MoveBySprings(pack, box, steps);
    EXPECT_LT(ruc::MeasureOverlap(pack, box).Percent, last);
    last = ruc::MeasureOverlap(pack, box).Percent;
  }
}

TEST(MassSpring, WorksInABoxOfAnyPlaceAndIsReproducible)
{
  const ruc::Window box = ruc::Window::MakeBox({ -7, 100, 3 }, { 4, 9, 6 }, { true, true, true });
  ruc::SpherePack a = oracle::RandomPack({ 50 }, { 0.75 }, box, 3), b = a;
  EXPECT_TRUE(ruc::MoveBySpringsUntilFree(a, box, 1));
  EXPECT_TRUE(ruc::MoveBySpringsUntilFree(b, box, 1));
  EXPECT_GE(oracle::LeastGap(a, box), 0.0);
  ExpectInBox(a, box);
  EXPECT_EQ(a.X, b.X);
  EXPECT_EQ(a.Y, b.Y);
  EXPECT_EQ(a.Z, b.Z);
}
