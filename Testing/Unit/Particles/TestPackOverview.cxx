// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackOverview.h"

#include "Oracles.h"

namespace
{
using ruc::PackOverview;
using ruc::SpherePack;
using ruc::Window;

// 8 spheres at (1, 2, 3) + {0, 4} x {0, 5} x {0, 6}, of the radii 0.5 and 1
SpherePack Eight()
{
  SpherePack pack;
  for (int i = 0; i < 8; ++i)
  {
    pack.X.push_back(1 + 4 * (i % 2));
    pack.Y.push_back(2 + 5 * (i / 2 % 2));
    pack.Z.push_back(3 + 6 * (i / 4));
    pack.Radius.push_back(i % 2 == 0 ? 0.5 : 1.0);
  }
  return pack;
}

Window Cube(double edge)
{
  return Window::MakeBox({ 0, 0, 0 }, { edge, edge, edge }, { true, true, true });
}

void ExpectWarning(const PackOverview& overview, const std::string& part)
{
  ASSERT_EQ(overview.Warnings.size(), 1u) << overview.Text;
  EXPECT_NE(overview.Warnings[0].find(part), std::string::npos) << overview.Warnings[0];
}
}

TEST(PackOverview, TellsNumberSizesExtentWindowAndFraction)
{
  // 4 (1/8 + 1) 4/3 pi = 18.8496 in 1000, and in 4 x 5 x 6
  const PackOverview inBox(Eight(), Cube(10.0), "Box Size", "mm");
  EXPECT_EQ(inBox.Text,
    "8 spheres of diameter 1 to 2 mm, centres over 4 x 5 x 6 mm from (1, 2, 3), periodic box "
    "10 x 10 x 10 by Box Size, fraction 0.0188496 of the window.");
  EXPECT_TRUE(inBox.Warnings.empty());
  const PackOverview alone(Eight(), {}, "", "");
  EXPECT_EQ(alone.Text,
    "8 spheres of diameter 1 to 2, centres over 4 x 5 x 6 from (1, 2, 3), no window given, "
    "fraction "
    "0.15708 of the bounds of the centres.");
  EXPECT_TRUE(alone.Warnings.empty());
}

TEST(PackOverview, WarnsOfUnitsThatDoNotFit)
{
  ExpectWarning(PackOverview(Eight(), Cube(60.0), "Box Size", ""),
    "the centres extend over 4 x 5 x 6, a tenth or less of the periodic box 60 x 60 x 60");
  EXPECT_TRUE(PackOverview(Eight(), Cube(55.0), "Box Size", "").Warnings.empty());
  SpherePack smallRadii = Eight();
  for (double& radius : smallRadii.Radius)
  {
    radius *= 0.001;
  }
  ExpectWarning(PackOverview(smallRadii, Cube(10.0), "Box Size", ""),
    "take no more than the fraction 1.88496e-11 of the window");
  ExpectWarning(PackOverview(smallRadii, {}, "", ""), "of the bounds of the centres, 4 x 5 x 6;");
}

TEST(PackOverview, WarnsOfDiametersAndPoints)
{
  SpherePack pack = Eight();
  for (double& radius : pack.Radius)
  {
    radius *= 4.0;
  }
  ExpectWarning(
    PackOverview(pack, Cube(10.0), "Box Size", ""), "add up to 1.20637 of the periodic");
  pack = Eight();
  pack.Radius[3] = pack.Radius[6] = 0.0;
  ExpectWarning(PackOverview(pack, Cube(10.0), "Box Size", ""), "2 of 8 radii are 0");
}

TEST(PackOverview, OneSphereIsEnoughForACell)
{
  SpherePack one;
  one.Append(Eight(), 1);
  const PackOverview overview(one, Cube(3.0), "Box Size", "");
  EXPECT_EQ(overview.Text,
    "1 sphere of diameter 2 to 2, centres over 0 x 0 x 0 from (5, 2, 3), periodic box 3 x 3 x 3 by "
    "Box "
    "Size, fraction 0.15514 of the window.");
  EXPECT_TRUE(overview.Warnings.empty());
  EXPECT_TRUE(PackOverview(one, {}, "", "").Warnings.empty());
}
