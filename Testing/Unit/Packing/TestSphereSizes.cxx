// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/SphereSizes.h"

#include "Oracles.h"

#include <numeric>

namespace
{
void ExpectRefusal(const ruc::SphereSizes& sizes, int number, const std::string& word)
{
  try
  {
    sizes.Make(number);
    ADD_FAILURE() << "nothing was refused: " << word;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}
}

TEST(SphereSizes, Equal)
{
  ruc::SphereSizes sizes;
  sizes.MeanDiameter = 3.0;
  const ruc::SphereSizes::Spheres spheres = sizes.Make(5);
  EXPECT_EQ(spheres.Radius, std::vector<double>(5, 1.5));
  EXPECT_EQ(spheres.Mode, std::vector<int>(5, 1));
}

TEST(SphereSizes, ClassesByVolumeAndByNumber)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::Classes;
  sizes.Diameters = { 1.0, 2.0 };
  sizes.Shares = { 20.0, 80.0 };
  // 80 % of the volume in spheres of eight times the volume are a third of all spheres
  ruc::SphereSizes::Spheres spheres = sizes.Make(300);
  EXPECT_EQ(std::count(spheres.Radius.begin(), spheres.Radius.end(), 1.0), 100);
  EXPECT_EQ(spheres.Radius.front(), 1.0); // the largest first
  EXPECT_EQ(spheres.Mode.front(), 2);
  EXPECT_EQ(std::count(spheres.Mode.begin(), spheres.Mode.end(), 1), 200);
  sizes.SharesAre = ruc::ShareKind::Number;
  spheres = sizes.Make(300);
  EXPECT_EQ(std::count(spheres.Radius.begin(), spheres.Radius.end(), 1.0), 240);
}

// Without a cut the moments are those that were asked for
TEST(SphereSizes, MomentsOfLaws)
{
  for (ruc::SizeLaw law : { ruc::SizeLaw::LogNormal, ruc::SizeLaw::Gaussian })
  {
    ruc::SphereSizes sizes;
    sizes.Law = law;
    sizes.MeanDiameter = 10.0;
    sizes.StandardDeviation = 1.5;
    sizes.Cut = 6.0;
    const std::vector<double> radii = sizes.Make(20000).Radius;
    double mean = 0.0, square = 0.0;
    for (double r : radii)
    {
      mean += 2.0 * r / radii.size();
      square += 4.0 * r * r / radii.size();
    }
    EXPECT_NEAR(mean, 10.0, 1e-3);
    EXPECT_NEAR(std::sqrt(square - mean * mean), 1.5, 5e-3);
    EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
  }
}

TEST(SphereSizes, AreCut)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::LogNormal;
  sizes.StandardDeviation = 0.5;
  sizes.Cut = 1.0;
  const double width = std::sqrt(std::log(1.25));
  const std::vector<double> radii = sizes.Make(100000).Radius;
  EXPECT_NEAR(std::log(2.0 * radii.front()), width - 0.5 * width * width, 1e-4);
  EXPECT_NEAR(std::log(2.0 * radii.back()), -width - 0.5 * width * width, 1e-4);
}

TEST(SphereSizes, WhatCannotBe)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ruc::SphereSizes sizes;
  for (double mean : { 0.0, -1.0, nan, 1e60 })
  {
    sizes.MeanDiameter = mean;
    ExpectRefusal(sizes, 10, "MeanDiameter");
  }
  sizes = {};
  sizes.Law = ruc::SizeLaw::Gaussian;
  for (double deviation : { 0.0, -1.0, nan, 0.5 })
  {
    sizes.StandardDeviation = deviation;
    ExpectRefusal(sizes, 10, "StandardDeviation");
  }
  sizes = {};
  sizes.Law = ruc::SizeLaw::Classes;
  ExpectRefusal(sizes, 10, "Shares");
  sizes.Diameters = { 1.0, 2.0 };
  sizes.Shares = { 1.0 };
  ExpectRefusal(sizes, 10, "Shares");
  for (double share : { 0.0, -1.0, nan })
  {
    sizes.Shares = { 1.0, share };
    ExpectRefusal(sizes, 10, "Shares");
  }
  sizes.Shares = { 1.0, 1.0 };
  sizes.Diameters = { 1.0, 0.0 };
  ExpectRefusal(sizes, 10, "Diameters");
  sizes.Diameters = { 1.0, 100.0 };
  ExpectRefusal(sizes, 10, "NumberOfSpheres");
}
