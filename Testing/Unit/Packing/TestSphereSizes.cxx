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

// With as many spheres as were measured, and with multiples, the very diameters come out
TEST(SphereSizes, MeasuredDiameters)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::Measured;
  sizes.Diameters = { 2.0, 8.0, 4.0 };
  EXPECT_EQ(sizes.Make(3).Radius, (std::vector<double>{ 4.0, 2.0, 1.0 }));
  EXPECT_EQ(sizes.Make(6).Radius, (std::vector<double>{ 4.0, 4.0, 2.0, 2.0, 1.0, 1.0 }));
  EXPECT_EQ(sizes.Make(2).Radius, (std::vector<double>{ 4.0, 1.0 }));
  EXPECT_EQ(sizes.Make(3).Mode, std::vector<int>(3, 1));
  // Of many, evenly spread from 1 to 2, few have the moments of that
  sizes.Diameters.clear();
  for (int n = 0; n < 100000; ++n)
  {
    sizes.Diameters.push_back(1.0 + (n + 0.5) / 100000.0);
  }
  const std::vector<double> radii = sizes.Make(50).Radius;
  const double sum = std::accumulate(radii.begin(), radii.end(), 0.0);
  EXPECT_NEAR(2.0 * sum / 50, 1.5, 1e-4);
}

// Where the volume is evenly spread from a to b, the number goes as D^-3: its mean is 2 a b / (a +
// b), and a sphere's mean of D^3 is 2 a^2 b^2 / (a + b)
TEST(SphereSizes, OneStepOfASieveCurve)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::Measured;
  sizes.Diameters = { 1.0, 3.0 };
  sizes.Passing = { 0.0, 100.0 };
  for (int number : { 1, 7, 20000 })
  {
    const std::vector<double> radii = sizes.Make(number).Radius;
    EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
    double mean = 0.0, cube = 0.0;
    for (double r : radii)
    {
      mean += 2.0 * r / number;
      cube += 8.0 * r * r * r / number;
    }
    EXPECT_NEAR(cube, 18.0 / 4.0, 1e-12);
    EXPECT_TRUE(number < 20000 || std::abs(mean - 6.0 / 4.0) < 1e-6) << mean;
  }
}

// Sieved again, the spheres give the curve that they were made of, to the volume of one sphere
TEST(SphereSizes, SievesGiveTheirCurve)
{
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::Measured;
  sizes.Diameters = { 0.063, 0.125, 0.25, 0.5, 0.6 };
  sizes.Passing = { 0.0, 20.0, 55.0, 55.0, 100.0 };
  const std::vector<double> radii = sizes.Make(5000).Radius;
  ASSERT_EQ(radii.size(), 5000u);
  const auto passing = [&](double opening)
  {
    double all = 0.0, passed = 0.0;
    for (double r : radii)
    {
      all += r * r * r;
      passed += 2.0 * r < opening ? r * r * r : 0.0;
    }
    return 100.0 * passed / all;
  };
  for (std::size_t s = 0; s < sizes.Diameters.size(); ++s)
  {
    EXPECT_NEAR(passing(sizes.Diameters[s]), sizes.Passing[s], 0.6) << sizes.Diameters[s];
  }
  EXPECT_NEAR(passing(0.4), 55.0, 0.6);  // none between 0.25 and 0.5
  EXPECT_NEAR(passing(0.55), 77.5, 0.6); // half of what lies between 0.5 and 0.6
}

TEST(SphereSizes, WhatCannotBeMeasured)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ruc::SphereSizes sizes;
  sizes.Law = ruc::SizeLaw::Measured;
  ExpectRefusal(sizes, 10, "Diameters");
  for (double diameter : { 0.0, -1.0, nan })
  {
    sizes.Diameters = { 1.0, diameter };
    ExpectRefusal(sizes, 10, "Diameters");
  }
  sizes.Diameters = { 1.0, 2.0, 3.0 };
  for (const std::vector<double>& passing : { std::vector<double>{ 0.0, 100.0 },
         { 0.0, 60.0, 50.0 }, { 0.0, nan, 100.0 }, { 1.0, 50.0, 100.0 }, { 0.0, 50.0, 99.0 } })
  {
    sizes.Passing = passing;
    ExpectRefusal(sizes, 10, "Passing");
  }
  sizes.Passing = { 0.0, 50.0, 100.0 };
  sizes.Diameters = { 1.0, 1.0, 2.0 };
  ExpectRefusal(sizes, 10, "Diameters");
  sizes.Diameters = { 1.0, 20.0, 30.0 };
  ExpectRefusal(sizes, 10, "NumberOfSpheres"); // none of the large
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
