// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SpherePack.h"

#include "Oracles.h"

#include <limits>
#include <numeric>

namespace
{
using ruc::SpherePack;
using ruc::Window;

SpherePack ThreeSpheres()
{
  SpherePack pack;
  pack.X = { 1, 2, 3 };
  pack.Y = { 1, 1, 1 };
  pack.Z = { 1, 1, 1 };
  pack.Radius = { 0.3, 0.2, 0.3 };
  pack.Mode = { 2, 1, 2 };
  pack.Id = { 7, 8, 9 };
  return pack;
}

template <class Change>
std::string PackMessage(Change&& change, bool withModes = true)
{
  SpherePack pack = ThreeSpheres();
  change(pack);
  return oracle::MessageOf([&]() { ruc::ValidatePack(pack, withModes); });
}

void ExpectPart(const std::string& message, const std::string& part)
{
  EXPECT_NE(message.find(part), std::string::npos) << message << "\nwanted: " << part;
}

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();
}

TEST(SpherePack, AGoodPackPasses)
{
  EXPECT_NO_THROW(ruc::ValidatePack(ThreeSpheres(), true));
  EXPECT_NO_THROW(ruc::ValidateWindow(
    ThreeSpheres(), Window::MakeBox({ 0, 0, 0 }, { 4, 4, 4 }, { true, true, true })));
  EXPECT_EQ(ThreeSpheres().NumberOfModes(), 2);
  EXPECT_EQ(ThreeSpheres().LargestRadius(), 0.3);
  EXPECT_EQ(SpherePack().LargestRadius(), 0.0);
  EXPECT_EQ(SpherePack().NumberOfModes(), 0);
}

TEST(SpherePack, LengthsWhoseVolumesAreNoNumbersAreRefused)
{
  for (double bad : { 1e-150, 9e-51, 1.1e50, 1e150 })
  {
    ExpectPart(PackMessage([&](SpherePack& p) { p.Radius[1] = bad; }),
      "'Radius' requires values from 1e-50 to 1e+50, got ");
  }
  ExpectPart(PackMessage([&](SpherePack& p) { p.X[2] = -1e300; }),
    "Points require coordinates of at most 1e+50, got the sphere at (-1e+300, 1, 1)");
  ExpectPart(PackMessage([&](SpherePack& p) { p.Y[0] = 1.1e50; }), "coordinates of at most 1e+50");
  ExpectPart(PackMessage([&](SpherePack& p) { p.Z[0] = 1.1e50; }), "coordinates of at most 1e+50");
}

TEST(SpherePack, ValidationNamesTheSphere)
{
  EXPECT_SAYS(ruc::ValidatePack(SpherePack(), false), "at least one sphere");
  for (double bad : { NaN, Infinity, -Infinity })
  {
    ExpectPart(
      PackMessage([&](SpherePack& p) { p.X[1] = bad; }), "Points require finite coordinates");
    ExpectPart(
      PackMessage([&](SpherePack& p) { p.Y[2] = bad; }), "Points require finite coordinates");
    ExpectPart(
      PackMessage([&](SpherePack& p) { p.Z[0] = bad; }), "Points require finite coordinates");
    ExpectPart(PackMessage([&](SpherePack& p) { p.Radius[1] = bad; }),
      "'Radius' requires finite values > 0");
  }
  ExpectPart(
    PackMessage([](SpherePack& p) { p.Radius[1] = 0.0; }), "got 0 for the sphere at (2, 1, 1)");
  ExpectPart(
    PackMessage([](SpherePack& p) { p.Radius[2] = -1.5; }), "got -1.5 for the sphere at (3, 1, 1)");
  ExpectPart(PackMessage([](SpherePack& p) { p.X[1] = 1.0; }), "two spheres at (1, 1, 1)");
}

TEST(SpherePack, ModesHaveNoGap)
{
  ExpectPart(PackMessage(
               [](SpherePack& p) {
                 p.Mode = { 3, 1, 3 };
               }),
    "no sphere of mode 2 but some of mode 3");
  ExpectPart(PackMessage([](SpherePack& p) { p.Mode = { 2, 2, 2 }; }), "no sphere of mode 1");
  ExpectPart(PackMessage(
               [](SpherePack& p) {
                 p.Mode = { 0, 1, 2 };
               }),
    "got 0 for the sphere at (1, 1, 1)");
  ExpectPart(PackMessage(
               [](SpherePack& p) {
                 p.Mode = { 1, -1, 2 };
               }),
    "got -1 for the sphere at (2, 1, 1)");
  ExpectPart(PackMessage([](SpherePack& p) { p.Mode = { 1, 2, 2000000000 }; }), "got 2000000000");
  EXPECT_EQ(PackMessage([](SpherePack& p) { p.Mode = { 3, 1, 3 }; }, false), "<no exception>");
}

TEST(SpherePack, WindowNeedsEveryCentre)
{
  const std::array<bool, 3> none = { false, false, false };
  const SpherePack pack = ThreeSpheres();
  EXPECT_SAYS(ruc::ValidateWindow(pack, Window::MakeBox({ 0, 0, 0 }, { 1.5, 4, 4 }, none)),
    "got 2 of 3 outside, such as the sphere at (2, 1, 1)");
  EXPECT_SAYS(ruc::ValidateWindow(pack, Window::MakeCylinder({ 1, 1, 0 }, { 0, 0, 1 }, 1.5, 3)),
    "got 1 of 3 outside");
  EXPECT_NO_THROW(
    ruc::ValidateWindow(pack, Window::MakeCylinder({ 1, 1, 0 }, { 0, 0, 1 }, 2.0, 3)));
}

TEST(SpherePack, EdgesExceedTheLargestDiameter)
{
  const SpherePack pack = ThreeSpheres();
  EXPECT_SAYS(
    ruc::ValidateWindow(pack, Window::MakeBox({ 0, 0.7, 0 }, { 4, 0.6, 4 }, { true, true, true })),
    "BoxSize requires periodic edges");
  EXPECT_NO_THROW(ruc::ValidateWindow(
    pack, Window::MakeBox({ 0, 0.7, 0 }, { 4, 0.61, 4 }, { true, true, true })));
  // A layer of spheres has no volume fractions: they would be 22 and -79 in one that is 0.01 thick
  EXPECT_SAYS(
    ruc::ValidateWindow(pack, Window::MakeBox({ 0, 0.7, 0 }, { 4, 0.6, 4 }, { true, false, true })),
    "The window requires edges longer than the largest sphere's diameter, 0.6, got a partly");
  EXPECT_NO_THROW(ruc::ValidateWindow(
    pack, Window::MakeBox({ 0, 0.7, 0 }, { 4, 0.61, 4 }, { true, false, true })));
  EXPECT_SAYS(
    ruc::ValidateWindow(pack, Window::MakeCylinder({ 2, 0.7, 2 }, { 0.0, 1.0, 0.0 }, 10.0, 0.5)),
    "The window requires edges longer than the largest sphere's diameter, 0.6, got a cylinder");
}

TEST(SpherePack, ACentreAndItsImageAreOneSphere)
{
  SpherePack pack = ThreeSpheres();
  pack.X = { 0, 2, 4 };
  const Window periodic = Window::MakeBox({ 0, 0, 0 }, { 4, 4, 4 }, { true, true, true });
  EXPECT_SAYS(ruc::ValidateWindow(pack, periodic), "periodic image");
  EXPECT_NO_THROW(
    ruc::ValidateWindow(pack, Window::MakeBox({ 0, 0, 0 }, { 4, 4, 4 }, { false, true, true })));
}

TEST(SpherePack, CanonicalOrderIsTheOrderOfTheKeys)
{
  oracle::Uniform random(1);
  SpherePack pack;
  for (int i = 0; i < 200; ++i)
  {
    // Few values, so that every later key decides some comparisons
    pack.X.push_back(std::floor(random(0, 3)));
    pack.Y.push_back(std::floor(random(0, 3)));
    pack.Z.push_back(std::floor(random(0, 3)));
    pack.Radius.push_back(1.0 + std::floor(random(0, 3)));
    pack.Mode.push_back(static_cast<int>(random(1, 4)));
    pack.Id.push_back(i);
  }
  SpherePack sorted = pack;
  ruc::SortCanonically(sorted);
  std::vector<bool> seen(200, false);
  for (std::size_t i = 0; i < 200; ++i)
  {
    const std::size_t from = static_cast<std::size_t>(sorted.Id[i]);
    EXPECT_FALSE(seen[from]);
    seen[from] = true;
    EXPECT_EQ(sorted.Centre(i), pack.Centre(from)); // rows stay together
    EXPECT_EQ(sorted.Radius[i], pack.Radius[from]);
    EXPECT_EQ(sorted.Mode[i], pack.Mode[from]);
    if (i > 0)
    {
      const auto key = [&](std::size_t n)
      {
        return std::make_tuple(
          sorted.X[n], sorted.Y[n], sorted.Z[n], sorted.Radius[n], sorted.Mode[n]);
      };
      EXPECT_LE(key(i - 1), key(i));
    }
  }
  SpherePack bare = pack;
  bare.Mode.clear();
  bare.Id.clear();
  ruc::SortCanonically(bare);
  EXPECT_EQ(bare.X, sorted.X);
  EXPECT_TRUE(bare.Mode.empty());
}

TEST(SpherePack, WrappingMovesByWholeEdgesIntoTheBox)
{
  oracle::Uniform random(2);
  const Window box =
    Window::MakeBox({ -1.5, 0.25, 100.0 }, { 3.0, 0.7, 11.0 }, { true, false, true });
  SpherePack pack;
  for (int i = 0; i < 2000; ++i)
  {
    pack.X.push_back(random(-40, 40));
    pack.Y.push_back(random(-40, 40));
    pack.Z.push_back(random(-40, 400));
    pack.Radius.push_back(0.1);
  }
  SpherePack wrapped = pack;
  ruc::WrapIntoBox(wrapped, box);
  EXPECT_EQ(wrapped.Y, pack.Y);
  for (int i = 0; i < 2000; ++i)
  {
    EXPECT_GE(wrapped.X[i], -1.5);
    EXPECT_LT(wrapped.X[i], 1.5);
    EXPECT_GE(wrapped.Z[i], 100.0);
    EXPECT_LT(wrapped.Z[i], 111.0);
    const double edges = (wrapped.X[i] - pack.X[i]) / 3.0;
    EXPECT_NEAR(edges, std::round(edges), 1e-13); // rounding of coordinates up to 40
  }
}

TEST(SpherePack, WrappingAtTheBordersStaysHalfOpen)
{
  for (double edge : { 1.0, 3.0, 0.7, 399.632, 0.1 })
  {
    const Window box = oracle::PeriodicCube(edge);
    for (int n = -20; n <= 20; ++n)
    {
      for (double c : { n * edge, std::nextafter(n * edge, -1e9), std::nextafter(n * edge, 1e9),
             n * edge - 1e-300 })
      {
        SpherePack pack;
        pack.X = pack.Y = pack.Z = { c };
        pack.Radius = { 0.01 };
        ruc::WrapIntoBox(pack, box);
        EXPECT_GE(pack.X[0], 0.0) << "edge " << edge << " n " << n;
        EXPECT_LT(pack.X[0], edge) << "edge " << edge << " n " << n;
      }
    }
  }
}

TEST(SpherePack, CropKeepsWhatTheWindowContains)
{
  const Window room = Window::MakeBox({ 0, 0, 0 }, { 4, 4, 4 }, { false, false, false });
  SpherePack pack = oracle::RandomPack({ 100, 200 }, { 0.1, 0.2 }, room, 5);
  pack.Id.resize(300);
  std::iota(pack.Id.begin(), pack.Id.end(), 0);
  const SpherePack cropped =
    ruc::CropToWindow(pack, Window::MakeBox({ 1, 0.5, 0 }, { 2, 3, 1.5 }, { false, false, false }));
  std::size_t n = 0;
  for (std::size_t i = 0; i < 300; ++i)
  {
    if (pack.X[i] >= 1 && pack.X[i] <= 3 && pack.Y[i] >= 0.5 && pack.Y[i] <= 3.5 &&
      pack.Z[i] <= 1.5)
    {
      ASSERT_LT(n, cropped.Size());
      EXPECT_EQ(cropped.Id[n], pack.Id[i]);
      EXPECT_EQ(cropped.Centre(n), pack.Centre(i));
      EXPECT_EQ(cropped.Mode[n], pack.Mode[i]);
      ++n;
    }
  }
  EXPECT_EQ(n, cropped.Size());
  EXPECT_GT(n, 10u);
}
