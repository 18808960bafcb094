// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/FilledShare.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Packing/OverlapRemoval.h"

#include <functional>

namespace
{
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;

Window Box(double x, double y, double z, bool periodic = false)
{
  return Window::MakeBox({ 0, 0, 0 }, { x, y, z }, { periodic, periodic, periodic });
}

// Independent centres, the most uneven that a pack can be
SpherePack Scattered(int count, const Window& box, double radius, std::uint64_t seed)
{
  oracle::Uniform random(seed);
  SpherePack pack;
  for (int i = 0; i < count; ++i)
  {
    pack.X.push_back(box.Origin[0] + box.Size[0] * random());
    pack.Y.push_back(box.Origin[1] + box.Size[1] * random());
    pack.Z.push_back(box.Origin[2] + box.Size[2] * random());
    pack.Radius.push_back(radius);
  }
  return pack;
}

// 1000 spheres that take 0.55 of a periodic cube of edge 10
const SpherePack& Dense()
{
  static const SpherePack pack = []()
  {
    const Window box = Box(10, 10, 10, true);
    SpherePack made = Scattered(1000, box, std::cbrt(0.55 / (4.0 / 3.0 * M_PI)), 3);
    ruc::RemoveOverlap(made, box, 1, [] { return true; });
    return made;
  }();
  return pack;
}

SpherePack Cut(const SpherePack& pack, const std::function<bool(const Vector3&)>& keep)
{
  SpherePack part;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (keep(pack.Centre(i)))
    {
      part.Append(pack, i);
    }
  }
  return part;
}

double Share(const SpherePack& pack, const Window& window)
{
  ruc::Communicator alone;
  return ruc::FindFilledShare(pack, window, alone);
}
}

TEST(FilledShare, ACutPackFillsWhatIsLeft)
{
  const Window box = Box(10, 10, 10, true);
  EXPECT_EQ(Share(Dense(), box), 1.0);
  // A cell is as wide as 2 spheres and more, 1.25, and the last ones are partly filled
  EXPECT_NEAR(Share(Cut(Dense(), [](const Vector3& c) { return c[0] < 5.0; }), box), 0.5, 0.13);
  EXPECT_NEAR(Share(Cut(Dense(), [](const Vector3& c) { return c[0] < 8.0; }), box), 0.8, 0.13);
  EXPECT_NEAR(
    Share(Cut(Dense(), [](const Vector3& c) { return c[0] + c[1] + c[2] < 15.0; }), box), 0.5, 0.2);
  EXPECT_NEAR(
    Share(Cut(Dense(),
            [](const Vector3& c) { return std::hypot(c[0] - 5.0, c[1] - 5.0, c[2] - 5.0) < 5.0; }),
      box),
    M_PI / 6.0, 0.25);
  // The empty part is inside, as a threshold may leave it
  EXPECT_LT(
    Share(Cut(Dense(), [](const Vector3& c) { return std::abs(c[2] - 5.0) > 2.0; }), box), 0.8);
}

TEST(FilledShare, FewSpheresAreEnough)
{
  const Window box = Box(10, 10, 10);
  const auto told = [&](int spheres)
  {
    int number = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
    {
      const SpherePack half =
        Cut(Scattered(spheres, box, 0.5, seed), [](const Vector3& c) { return c[2] < 5.0; });
      number += Share(half, box) < 1.0;
    }
    return number;
  };
  EXPECT_GE(told(60), 50) << "of which about 30 are left";
  EXPECT_EQ(told(120), 100);
}

TEST(FilledShare, ChanceRaisesNoAlarm)
{
  int alarms = 0;
  std::uint64_t seed = 0;
  for (int count : { 1, 2, 3, 5, 10, 20, 50, 100, 300, 1000 })
  {
    for (int n = 0; n < 400; ++n)
    {
      alarms += Share(Scattered(count, Box(1, 1, 1), 1e-3, ++seed), Box(1, 1, 1)) < 1.0;
      alarms += Share(Scattered(count, Box(30, 3, 1), 1e-3, ++seed), Box(30, 3, 1, true)) < 1.0;
    }
  }
  EXPECT_EQ(alarms, 0) << "of 8000, each with a risk below 1e-6";
}

TEST(FilledShare, LargeSpheresFillWhatIsInsideThem)
{
  const Window box = Box(10, 10, 10);
  // Half of the volume of all spheres is in one, which takes 0.4 of the box
  SpherePack pack = Cut(Scattered(20000, box, 0.1, 5),
    [](const Vector3& c) { return std::hypot(c[0] - 5.0, c[1] - 5.0, c[2] - 5.0) > 4.6; });
  const SpherePack small = pack;
  pack.X.push_back(5.0);
  pack.Y.push_back(5.0);
  pack.Z.push_back(5.0);
  pack.Radius.push_back(4.57);
  EXPECT_EQ(Share(pack, box), 1.0);
  EXPECT_NEAR(Share(small, box), 0.6, 0.1) << "the same without it";

  // Large spheres are in one half, ten times smaller ones in the other
  SpherePack halves = Cut(Scattered(30000, box, 0.1, 7), [](const Vector3& c) { return c[2] < 5; });
  SpherePack large = Scattered(80, Box(10, 10, 5), 1.0, 8);
  for (double& z : large.Z)
  {
    z += 5.0;
  }
  halves.Append(large);
  EXPECT_EQ(Share(halves, box), 1.0);
}

TEST(FilledShare, WallsOfAContainerAreNoCut)
{
  // Centres stay a radius away from the walls, while the window is that of the container
  for (double radii : { 4.0, 8.0, 16.0 })
  {
    const double edge = 2.0 * radii;
    const int count = static_cast<int>(0.6 * edge * edge * edge / (4.0 / 3.0 * M_PI));
    SpherePack box = Scattered(count, Box(edge - 2.0, edge - 2.0, edge - 2.0), 1.0, 11);
    for (std::vector<double>* axis : { &box.X, &box.Y, &box.Z })
    {
      for (double& c : *axis)
      {
        c += 1.0;
      }
    }
    EXPECT_EQ(Share(box, Box(edge, edge, edge)), 1.0) << radii;
    const Window can = Window::MakeCylinder({ radii, radii, 0 }, { 0, 0, 1 }, radii, edge);
    const SpherePack round = Cut(
      box, [&](const Vector3& c) { return std::hypot(c[0] - radii, c[1] - radii) < radii - 1.0; });
    EXPECT_EQ(Share(round, can), 1.0) << radii;
  }
}

TEST(FilledShare, OfACylinderInAnyPlace)
{
  const Window can = Window::MakeCylinder({ 5, 5, 10 }, { 0, 0, -2 }, 5.0, 10.0);
  const SpherePack whole = Cut(Dense(), [&](const Vector3& c) { return can.Contains(c); });
  EXPECT_EQ(Share(whole, can), 1.0);
  EXPECT_NEAR(Share(Cut(whole, [](const Vector3& c) { return c[2] < 5.0; }), can), 0.5, 0.2);
  EXPECT_NEAR(Share(Cut(whole, [](const Vector3& c) { return c[0] < 5.0; }), can), 0.5, 0.2);
}

TEST(FilledShare, IsTheSameOnAnyNumberOfRanks)
{
  const Window box = Box(10, 10, 10, true);
  const SpherePack part = Cut(Dense(), [](const Vector3& c) { return c[0] < 5.0; });
  const double alone = Share(part, box);
  oracle::ThreadRanks::Run(3,
    [&](ruc::Communicator& ranks)
    {
      SpherePack own; // rank 0 has none
      for (std::size_t i = 0; i < part.Size(); ++i)
      {
        if (static_cast<int>(1 + i % 2) == ranks.Rank())
        {
          own.Append(part, i);
        }
      }
      EXPECT_EQ(ruc::FindFilledShare(own, box, ranks), alone);
    });
}
