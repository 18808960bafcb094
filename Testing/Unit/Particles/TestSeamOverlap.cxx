// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SeamOverlap.h"

#include "EnclosedPacks.h"

#include <gtest/gtest.h>

namespace
{
using ruc::SpherePack;
using ruc::Window;

const std::vector<double>& Radii()
{
  static const std::vector<double> radii = oracle::LognormalRadii(2000, 0.2, 1);
  return radii;
}
Window Cube(bool periodic)
{
  return oracle::CubeFor(Radii(), 0.55, { periodic, periodic, periodic });
}
}

TEST(SeamOverlap, OfPacksThatArePeriodicOrNot)
{
  const SpherePack periodic = oracle::PackBetweenWalls(Radii(), Cube(true), 2, 150);
  EXPECT_FALSE(ruc::OverlapsAcrossSeams(periodic, Cube(true)));
  EXPECT_FALSE(ruc::OverlapsAcrossSeams(periodic, Cube(false)));
  // A part of it that is said to be periodic
  Window part = Cube(true);
  part.Size[1] *= 0.7;
  const SpherePack cut = CropToWindow(periodic, part);
  EXPECT_TRUE(ruc::OverlapsAcrossSeams(cut, part));
  part.Periodic[1] = false;
  EXPECT_FALSE(ruc::OverlapsAcrossSeams(cut, part));
}

TEST(SeamOverlap, SpheresThatOverlapEverywhereAreNoSign)
{
  std::vector<double> radii(2000, 1.0);
  const Window cube = oracle::CubeFor(radii, 0.9, { true, true, true });
  EXPECT_FALSE(ruc::OverlapsAcrossSeams(oracle::PackBetweenWalls(radii, cube, 3, 0), cube));
}

TEST(SeamOverlap, OfNoSpheresAndOfPoints)
{
  EXPECT_FALSE(ruc::OverlapsAcrossSeams({}, Cube(true)));
  SpherePack points;
  points.Append({ { 0 }, { 0 }, { 0 }, { 0 }, {}, {} }, 0);
  EXPECT_FALSE(ruc::OverlapsAcrossSeams(points, Cube(true)));
}
