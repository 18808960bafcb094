// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FormatFiles.h"

#include "ruc/Formats/TiltedCell.h"

namespace
{
using ruc::FrameBox;
using ruc::FramePack;
using ruc::PackFrame;
using ruc::Vector3;
using Doubles = std::vector<double>;

FrameBox Tilted(const Vector3& tilts, const std::array<bool, 3>& periodic = { true, true, true })
{
  return { { -1, 2, 0.5 }, { 10, 9, 8 }, tilts, periodic, true };
}

// Spheres at random places, far beyond the cell as well
PackFrame RandomFrame(int count, const FrameBox& box)
{
  oracle::Uniform random(7);
  PackFrame frame;
  frame.Box = box;
  for (int n = 0; n < count; ++n)
  {
    frame.X.push_back(random(-50, 50));
    frame.Y.push_back(random(-50, 50));
    frame.Z.push_back(random(-50, 50));
    frame.Radius.push_back(0.1);
  }
  return frame;
}

PackFrame Spheres(const Doubles& x, const Doubles& radii)
{
  PackFrame frame;
  frame.X = x;
  frame.Y = Doubles(x.size(), 1.0);
  frame.Z = Doubles(x.size(), 1.0);
  frame.Radius = radii;
  return frame;
}
}

TEST(TiltedCell, WrappingMovesByWholeEdges)
{
  for (const Vector3& tilts :
    { Vector3{ 2.5, -1.5, 3 }, Vector3{ -4.9, 4.9, -4.4 }, Vector3{ 0, 0, 0 } })
  {
    const FrameBox box = Tilted(tilts);
    const PackFrame before = RandomFrame(2000, box);
    PackFrame after = before;
    EXPECT_GT(ruc::WrapIntoBrick(after, box), 1900u);
    for (std::size_t i = 0; i < before.Size(); ++i)
    {
      const Vector3 d = { before.X[i] - after.X[i], before.Y[i] - after.Y[i],
        before.Z[i] - after.Z[i] };
      const double c = std::round(d[2] / 8), b = std::round((d[1] - c * tilts[2]) / 9);
      const double a = std::round((d[0] - c * tilts[1] - b * tilts[0]) / 10);
      ASSERT_NEAR(d[0], 10 * a + tilts[0] * b + tilts[1] * c, 1e-12);
      ASSERT_NEAR(d[1], 9 * b + tilts[2] * c, 1e-12);
      ASSERT_NEAR(d[2], 8 * c, 1e-12);
      ASSERT_TRUE(after.X[i] >= -1 && after.X[i] < 9 && after.Y[i] >= 2 && after.Y[i] < 11 &&
        after.Z[i] >= 0.5 && after.Z[i] < 8.5);
    }
    EXPECT_EQ(ruc::WrapIntoBrick(after, box), 0u); // and stays there
  }
}

TEST(TiltedCell, WhatIsPeriodicInTheBrick)
{
  const auto periodic = [](const Vector3& tilts) { return ruc::BrickOf(Tilted(tilts)).Periodic; };
  using Axes = std::array<bool, 3>;
  EXPECT_EQ(periodic({ 0, 0, 0 }), (Axes{ true, true, true }));
  EXPECT_EQ(periodic({ 2.5, 0, 0 }), (Axes{ true, false, true }));
  EXPECT_EQ(periodic({ 0, 2.5, 0 }), (Axes{ true, true, false }));
  EXPECT_EQ(periodic({ 0, 0, 3 }), (Axes{ true, true, false }));
  EXPECT_EQ(periodic({ -10, 20, 9 }), (Axes{ true, true, true }));   // whole edges
  EXPECT_EQ(periodic({ 2.5, 2.5, 9 }), (Axes{ true, false, true })); // c less b is along z
  EXPECT_EQ(periodic({ 2.5, -1.5, 3 }), (Axes{ true, false, false }));
  EXPECT_EQ(
    ruc::BrickOf(Tilted({ 0, 0, 0 }, { true, false, true })).Periodic, (Axes{ true, false, true }));
}

TEST(TiltedCell, FarAwayIsRefused)
{
  PackFrame frame = Spheres({ 1e300 }, { 1 });
  EXPECT_SAYS(ruc::WrapIntoBrick(frame, Tilted({})), "at most 10^9 edges away");
  frame.X[0] = -1e-17; // rounds to the far face
  FrameBox box = { { 0, 0, 0 }, { 10, 10, 10 }, {}, { true, true, true }, true };
  EXPECT_EQ(ruc::WrapIntoBrick(frame, box), 1u);
  EXPECT_EQ(frame.X[0], 0.0);
}

TEST(FramePack, TiltedCellsBecomeBricks)
{
  const FramePack pack = ruc::MakePack(RandomFrame(500, Tilted({ 2.5, -1.5, 3 })), {});
  EXPECT_EQ(pack.Pack.Size(), 500u);
  EXPECT_TRUE(pack.BoxIsWindow);
  EXPECT_EQ(*pack.Box, ruc::Window::MakeBox({ -1, 2, 0.5 }, { 10, 9, 8 }, { true, false, false }));
  ASSERT_EQ(pack.Warnings.size(), 1u);
  EXPECT_NE(pack.Warnings[0].find("along y and z its faces cut"), std::string::npos);
  EXPECT_FALSE(
    ruc::MakePack(RandomFrame(50, Tilted({ 2.5, 0, 0 }, { false, true, true })), {}).Box);
}

TEST(FramePack, ComesInTheOrderOfIds)
{
  PackFrame frame = Spheres({ 1, 2, 3 }, { 0.1, 0.2, 0.3 });
  frame.Id = { 30, -10, 20 };
  frame.Type = { 3, 1, 2 };
  frame.Mode = { 1, 1, 2 };
  frame.Step = 5;
  const FramePack pack = ruc::MakePack(frame, {});
  EXPECT_EQ(pack.Pack.X, (Doubles{ 2, 3, 1 }));
  EXPECT_EQ(pack.Pack.Radius, (Doubles{ 0.2, 0.3, 0.1 }));
  EXPECT_EQ(pack.Pack.Id, (std::vector<std::int64_t>{ -10, 20, 30 }));
  EXPECT_EQ(pack.Type, (std::vector<int>{ 1, 2, 3 }));
  EXPECT_EQ(pack.Pack.Mode, (std::vector<int>{ 1, 2, 1 }));
  EXPECT_EQ(pack.Time, 5.0);
  frame.Id.clear();
  EXPECT_EQ(ruc::MakePack(frame, {}).Pack.Id, (std::vector<std::int64_t>{ 0, 1, 2 }));
}

TEST(FramePack, Refusals)
{
  PackFrame frame = Spheres({ 1, 2, 3, 4, 5 }, Doubles(5, 0.1));
  frame.Id = { 4, 5, 6, 4, 7 };
  EXPECT_SAYS(ruc::MakePack(frame, {}), "Id 4 stands in rows 1 and 4.");
  EXPECT_SAYS(ruc::MakePack(Spheres({ 1, 2, 1, 4 }, Doubles(4, 0.1)), {}),
    "Spheres 0 and 2 have one centre, (1, 1, 1).");
  EXPECT_SAYS(ruc::MakePack(Spheres({ 0.0, 2, -0.0, 4 }, Doubles(4, 0.1)), {}), "have one centre");
  EXPECT_SAYS(ruc::MakePack(Spheres({ 1, 2, 3, 4, 5 }, { 0.1, 0.1, 9, 0.1, 0.1 }), {}),
    "Row 3 holds all others: a container?");
  EXPECT_NO_THROW(ruc::MakePack(Spheres({ 1, 2, 3, 4, 50 }, { 0.1, 0.1, 9, 0.1, 0.1 }), {}));
  // Two spheres whose centres are one after wrapping, though their radii differ
  PackFrame periodic = Spheres({ 1, 11, 3, 4 }, { 0.1, 0.2, 0.1, 0.1 });
  periodic.Box = FrameBox{ { 0, 0, 0 }, { 10, 10, 10 }, {}, { true, true, true }, true };
  EXPECT_SAYS(ruc::MakePack(periodic, {}), "have one centre");
  periodic.Radius[1] = 0.1; // a copy
  EXPECT_EQ(ruc::MakePack(periodic, {}).Ghosts, 1u);
}

TEST(FramePack, SpheresWiderThanTheBoxAreNotSearchedForCopies)
{
  PackFrame frame = Spheres({ 1, 12, 3 }, Doubles(3, 1e23));
  frame.Box = FrameBox{ { 0, 0, 0 }, { 10, 10, 10 }, {}, { true, true, true }, true };
  const FramePack pack = ruc::MakePack(frame, {});
  EXPECT_EQ(pack.Ghosts, 0u);
  EXPECT_EQ(pack.Pack.X, (Doubles{ 1, 2, 3 }));
  frame.X[1] = 1e22;
  EXPECT_SAYS(ruc::MakePack(frame, {}), "at most 10^9 edges away");
}

TEST(FramePack, LengthsAreScaledFirst)
{
  PackFrame frame = Spheres({ 1, 2, 13 }, {});
  frame.Box = FrameBox{ { 0, 0, 0 }, { 10, 10, 10 }, {}, { true, true, true }, true };
  ruc::PackSettings settings;
  settings.Scale = 0.5;
  settings.UniformRadius = 0.1; // is not scaled
  const FramePack pack = ruc::MakePack(frame, settings);
  EXPECT_EQ(pack.Pack.X, (Doubles{ 0.5, 1, 1.5 }));
  EXPECT_EQ(pack.Pack.Radius, Doubles(3, 0.1));
  EXPECT_EQ(*pack.Box, ruc::Window::MakeBox({ 0, 0, 0 }, { 5, 5, 5 }, { true, true, true }));
  frame.Radius = { 1, 0, 1e-200 };
  settings.Scale = 1e-200;
  EXPECT_SAYS(ruc::MakePack(frame, settings), "Row 1: coordinates of at most 1e+50 and");
  for (double bad : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    settings.Scale = bad;
    EXPECT_SAYS(ruc::MakePack(frame, settings), "Scale requires a finite number > 0");
  }
}

TEST(FramePack, WindowOfSettings)
{
  PackFrame frame = Spheres({ 1, 12, 11, -1e-9 }, Doubles(4, 0.1));
  frame.Box = FrameBox{ { 0, 0, 0 }, { 30, 30, 30 }, {}, { true, true, true }, true };
  ruc::PackSettings settings;
  settings.Observed = ruc::Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { true, true, true });
  const FramePack pack = ruc::MakePack(frame, settings);
  EXPECT_EQ(*pack.Box, *settings.Observed);
  EXPECT_TRUE(pack.BoxIsWindow);
  EXPECT_EQ(pack.Ghosts, 1u);
  EXPECT_EQ(pack.Wrapped, 1u);
  EXPECT_EQ(pack.Pack.X, (Doubles{ 1, 2, -1e-9 })); // on the face, as far as digits tell
  settings.Observed = ruc::Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, {});
  EXPECT_SAYS(ruc::MakePack(frame, settings),
    "BoxOrigin and BoxSize require every centre inside the box, got that of sphere 1 at (12, 1, "
    "1)");
}

TEST(FramePack, RadiiOfSettings)
{
  PackFrame frame = Spheres({ 1, 2, 3 }, {});
  ruc::PackSettings settings;
  EXPECT_SAYS(ruc::MakePack(frame, settings), "requires radii: ");
  EXPECT_SAYS(ruc::MakePack(frame, settings), "got neither radii nor types.");
  settings.UniformRadius = 0.25;
  EXPECT_EQ(ruc::MakePack(frame, settings).Pack.Radius, Doubles(3, 0.25));
  settings.UniformRadius = -1;
  EXPECT_SAYS(ruc::MakePack(frame, settings), "UniformRadius requires a finite number >= 0");
  settings.UniformRadius = 0;
  frame.Type = { 2, 1, 2 };
  settings.RadiusByType = " 1=0.1;2=0.2 ;";
  EXPECT_EQ(ruc::MakePack(frame, settings).Pack.Radius, (Doubles{ 0.2, 0.1, 0.2 }));
  frame.TypeNames = { "glass", "steel" };
  settings.RadiusByType = "steel=0.2, glass=0.1";
  EXPECT_EQ(ruc::MakePack(frame, settings).Pack.Radius, (Doubles{ 0.2, 0.1, 0.2 }));
  settings.RadiusByType = "1=0.1; 2=0.2; 1=0.3";
  EXPECT_SAYS(
    ruc::MakePack(frame, settings), "RadiusByType requires one radius of each type, got '1=0.3'");
  for (const char* bad : { "1", "=1", "1=", "1=a", "1=0", "1=-1", "1=inf" })
  {
    settings.RadiusByType = bad;
    EXPECT_SAYS(ruc::MakePack(frame, settings), "RadiusByType requires types and radii > 0");
  }
  settings.RadiusByType = "steel=0.2"; // the others are uniform
  EXPECT_SAYS(ruc::MakePack(frame, settings), "RadiusByType requires a radius of type glass");
  settings.UniformRadius = 0.5;
  EXPECT_EQ(ruc::MakeRadii(3, frame.Type, frame.TypeNames, settings), (Doubles{ 0.2, 0.5, 0.2 }));
  settings.RadiusByType = "steel";
  EXPECT_SAYS(ruc::MakeRadii(0, {}, {}, settings), "RadiusByType requires types and radii > 0");
  frame.Radius = { 1, 2, 3 }; // the file's go first
  settings.RadiusByType = "steel=0.2";
  EXPECT_EQ(
    ruc::MakePack(Spheres({ 1, 20, 30 }, { 1, 2, 3 }), settings).Pack.Radius, (Doubles{ 1, 2, 3 }));
}

TEST(FramePack, SettingsThatAreNotUsedAreTold)
{
  const auto warnings = [](const PackFrame& frame, const ruc::PackSettings& settings)
  { return ruc::MakePack(frame, settings).Warnings; };
  const PackFrame sized = Spheres({ 1, 20, 30 }, { 1, 2, 3 });
  ruc::PackSettings settings;
  EXPECT_TRUE(warnings(sized, settings).empty());
  settings.UniformRadius = 0.5;
  EXPECT_EQ(warnings(sized, settings),
    std::vector<std::string>{
      "UniformRadius and RadiusByType are not used, since the file tells radii." });
  const PackFrame bare = Spheres({ 1, 20, 30 }, {});
  EXPECT_TRUE(warnings(bare, settings).empty());
  settings.RadiusByType = "1=2";
  EXPECT_EQ(warnings(bare, settings),
    std::vector<std::string>{ "RadiusByType is not used, since the file tells no types." });
  settings = {};
  settings.Periodic = { true, true, true };
  EXPECT_EQ(warnings(sized, settings),
    std::vector<std::string>{
      "BoxPeriodic is not used, since neither BoxSize nor the file tells a box." });
}
