// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/OverlapRemoval.h"

#include "Oracles.h"

namespace
{
const auto Always = []() { return true; };

void ExpectOverlapOfBruteForce(const ruc::SpherePack& pack, const ruc::Window& box)
{
  double shared = 0.0, total = 0.0, deepest = -1.0;
  std::int64_t pairs = 0;
  for (double r : pack.Radius)
  {
    total += 4.0 / 3.0 * oracle::Pi * r * r * r;
  }
  oracle::ForEachPair(pack, box, 2.0 * pack.LargestRadius(),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    {
      const double contact = pack.Radius[i] + pack.Radius[j];
      if (d < contact)
      {
        ++pairs;
        shared += oracle::LensVolume(pack.Radius[i], pack.Radius[j], d);
        deepest = std::max(deepest, 1.0 - d / contact);
      }
    });
  const ruc::PackOverlap overlap = ruc::MeasureOverlap(pack, box);
  EXPECT_EQ(overlap.Pairs, pairs);
  EXPECT_NEAR(overlap.Percent, 100.0 * shared / total,
    1e-10 * (1.0 + 100.0 * shared / total)); // rounding, fixed point 2^-50
  EXPECT_NEAR(overlap.Deepest, deepest, 1e-13);
  EXPECT_FALSE(overlap.IsNone());
}
}

TEST(OverlapRemoval, TwoSpheresThroughAPeriodicFace)
{
  ruc::SpherePack pack;
  pack.X = { 0.3, 9.6 }; // 0.7 apart through the face
  pack.Y = pack.Z = { 5.0, 5.0 };
  pack.Radius = { 1.0, 0.5 };
  const double lens = oracle::LensVolume(1.0, 0.5, 0.7);
  const double total = 4.0 / 3.0 * oracle::Pi * 1.125;
  const ruc::PackOverlap overlap = ruc::MeasureOverlap(pack, oracle::PeriodicCube(10.0));
  EXPECT_EQ(overlap.Pairs, 1);
  EXPECT_NEAR(overlap.Percent, 100.0 * lens / total, 1e-11);
  EXPECT_NEAR(overlap.Deepest, 0.8 / 1.5, 1e-14);
  const ruc::PackOverlap closed = ruc::MeasureOverlap(
    pack, ruc::Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, true, true }));
  EXPECT_EQ(closed.Pairs, 0);
  EXPECT_EQ(closed.Percent, 0.0);
  EXPECT_EQ(closed.Deepest, -1.0);
  EXPECT_TRUE(closed.IsNone());
}

TEST(OverlapRemoval, MeasureAgreesWithBruteForce)
{
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ true, true, true }, { false, false, false }, { false, true, false } })
  {
    const ruc::Window box = ruc::Window::MakeBox({ -1, 2, 0 }, { 5, 6, 4.5 }, periodic);
    ExpectOverlapOfBruteForce(oracle::RandomPack({ 20, 60 }, { 0.9, 0.4 }, box, 12), box);
  }
}

TEST(OverlapRemoval, TheBorderOfNoOverlap)
{
  ruc::SpherePack pack;
  pack.X = { 1.0, 3.0 };
  pack.Y = pack.Z = { 5.0, 5.0 };
  pack.Radius = { 1.0, 1.0 };
  const ruc::Window box = oracle::PeriodicCube(10.0);
  EXPECT_TRUE(ruc::MeasureOverlap(pack, box).IsNone());
  pack.X[1] = 3.0 * (1.0 - 4e-13); // 0.6e-12 of the contact
  EXPECT_TRUE(ruc::MeasureOverlap(pack, box).IsNone());
  pack.X[1] = 3.0 - 4e-12;
  EXPECT_FALSE(ruc::MeasureOverlap(pack, box).IsNone());
}

TEST(OverlapRemoval, LeavesNoOverlap)
{
  struct Case
  {
    std::vector<int> Counts;
    std::vector<double> Radii;
  };
  const Case cases[] = { { { 150 }, { 1.0 } }, { { 40, 150 }, { 1.0, 0.55 } },
    { { 20, 60, 100 }, { 1.2, 0.8, 0.5 } } };
  for (const Case& c : cases)
  {
    for (double fraction : { 0.3, 0.55, 0.62 })
    {
      const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor(c.Counts, c.Radii, fraction));
      ruc::SpherePack pack = oracle::RandomPack(c.Counts, c.Radii, box, 33);
      EXPECT_LT(oracle::LeastGap(pack, box), 0.0);
      EXPECT_TRUE(ruc::RemoveOverlap(pack, box, 7, Always)) << fraction;
      EXPECT_GE(oracle::LeastGap(pack, box), 0.0) << fraction << " of " << c.Radii.size();
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        for (int q = 0; q < 3; ++q)
        {
          EXPECT_GE(pack.Centre(i)[q], 0.0);
          EXPECT_LT(pack.Centre(i)[q], box.Size[q]);
        }
      }
    }
  }
}

TEST(OverlapRemoval, KeepsSizesAndAPackWithoutOverlap)
{
  const ruc::Window box = oracle::PeriodicCube(9.0);
  ruc::SpherePack pack = oracle::RandomPack({ 20, 30 }, { 1.0, 0.6 }, box, 3);
  const ruc::SpherePack before = pack;
  ASSERT_TRUE(ruc::RemoveOverlap(pack, box, 7, Always));
  EXPECT_EQ(pack.Radius, before.Radius);
  EXPECT_EQ(pack.Mode, before.Mode);
  const ruc::SpherePack free = pack;
  EXPECT_TRUE(ruc::RemoveOverlap(pack, box, 8,
    []()
    {
      ADD_FAILURE() << "nothing to do";
      return true;
    }));
  EXPECT_EQ(pack.X, free.X);
  EXPECT_EQ(pack.Z, free.Z);
}

TEST(OverlapRemoval, WorksAcrossABoxThatIsNotACube)
{
  const ruc::Window box = ruc::Window::MakeBox({ -7, 100, 3 }, { 4, 9, 6 }, { true, true, true });
  ruc::SpherePack pack = oracle::RandomPack({ 50 }, { 0.75 }, box, 3); // a fraction of 0.41
  EXPECT_TRUE(ruc::RemoveOverlap(pack, box, 1, Always));
  EXPECT_GE(oracle::LeastGap(pack, box), 0.0);
}

TEST(OverlapRemoval, ImpossibleIsReported)
{
  const ruc::Window box = oracle::PeriodicCube(
    oracle::EdgeFor({ 16 }, { 1.0 }, 0.8)); // above the densest packing, 0.7405
  ruc::SpherePack pack = oracle::RandomPack({ 16 }, { 1.0 }, box, 3);
  EXPECT_FALSE(ruc::RemoveOverlap(pack, box, 1, Always));
  EXPECT_LT(oracle::LeastGap(pack, box), 0.0);
}

TEST(OverlapRemoval, StopsWhenItIsTold)
{
  const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor({ 200 }, { 1.0 }, 0.6));
  const ruc::SpherePack start = oracle::RandomPack({ 200 }, { 1.0 }, box, 3);
  ruc::SpherePack pack = start;
  int calls = 0;
  EXPECT_FALSE(ruc::RemoveOverlap(pack, box, 1, [&]() { return ++calls < 2; }));
  EXPECT_EQ(calls, 2);
  EXPECT_LT(ruc::MeasureOverlap(pack, box).Percent,
    ruc::MeasureOverlap(start, box).Percent); // what was reached stays
  EXPECT_LT(oracle::LeastGap(pack, box), 0.0);
}

TEST(OverlapRemoval, IsReproducible)
{
  const ruc::Window box = oracle::PeriodicCube(oracle::EdgeFor({ 100 }, { 1.0 }, 0.6));
  ruc::SpherePack a = oracle::RandomPack({ 100 }, { 1.0 }, box, 5), b = a;
  ruc::RemoveOverlap(a, box, 4, Always);
  ruc::RemoveOverlap(b, box, 4, Always);
  EXPECT_EQ(a.X, b.X);
  EXPECT_EQ(a.Y, b.Y);
  EXPECT_EQ(a.Z, b.Z);
}
