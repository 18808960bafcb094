// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/CheckedPiece.h"

#include "Oracles.h"

#include <array>

namespace
{
using ruc::CheckedPiece;
using ruc::SpherePack;
using ruc::Window;

SpherePack AtX(std::vector<double> x)
{
  SpherePack pack;
  pack.X = std::move(x);
  pack.Y.assign(pack.X.size(), 5.0);
  pack.Z.assign(pack.X.size(), 5.0);
  pack.Radius.assign(pack.X.size(), 0.1);
  return pack;
}

CheckedPiece Check(const std::vector<double>& x, std::array<bool, 3> periodic, bool crop = false)
{
  ruc::Communicator alone;
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, periodic);
  return CheckedPiece(
    AtX(x), false, [&](const SpherePack&) { return box; }, crop, alone);
}
}

TEST(CheckedPiece, CentresOutsideAPeriodicBoxAreMovedIntoIt)
{
  // The centres are outside by rounding and by a few edges, at the border, and inside
  const CheckedPiece piece = Check({ -1e-4, 23.5, -40.0, 10.0, 7.25 }, { true, false, false });
  EXPECT_EQ(piece.NumberMoved(), 3);
  const std::vector<double>& x = piece.Spheres().X;
  EXPECT_NEAR(x[0], 9.9999, 1e-12);
  EXPECT_EQ(x[1], 3.5);
  EXPECT_EQ(x[2], 0.0);
  EXPECT_EQ(x[3], 10.0) << "a centre on the upper face is in the box";
  EXPECT_EQ(x[4], 7.25);
  // The centre is a float just above the edge
  EXPECT_EQ(Check({ 10.000001f }, { true, true, true }).NumberMoved(), 1);
}

TEST(CheckedPiece, OtherAxesHaveNoImages)
{
  EXPECT_SAYS(Check({ 5.0, 23.5 }, { false, true, true }), "got 1 of 2 outside");
}

TEST(CheckedPiece, CroppingNeverDropsASphereAlongAPeriodicAxis)
{
  EXPECT_EQ(Check({ -1e-4, 23.5, 5.0 }, { true, true, true }, true).NumberOfSpheres(), 3);
  EXPECT_EQ(Check({ -1e-4, 23.5, 5.0 }, { false, true, true }, true).NumberOfSpheres(), 1);
}

TEST(CheckedPiece, ACentreWhosePlaceWouldBeRoundingIsNotMoved)
{
  EXPECT_EQ(Check({ 9.9e6 }, { true, true, true }).NumberMoved(), 1);
  EXPECT_SAYS(Check({ 1.1e7 }, { true, true, true }), "requires every centre inside");
}
