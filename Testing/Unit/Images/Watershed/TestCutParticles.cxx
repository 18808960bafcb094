// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Watershed/CutParticles.h"

#include "Images/Fit/GreyScenes.h"

namespace
{
using oracle::GreyScene;
using ruc::CutParticles;
using ruc::ParticleSearch;
using ruc::ParticleShape;
using ruc::Vector3;

struct Cut
{
  CutParticles Found;
  std::vector<std::int32_t> Number; // of the whole image
};

Cut CutValues(const std::vector<float>& values, const std::array<int, 3>& dimensions,
  const ParticleSearch& search = {}, int size = 1)
{
  Cut cut;
  cut.Number = oracle::Together<std::int32_t>(size,
    [&](ruc::Communicator& ranks)
    {
      CutParticles found = ruc::CutImage(oracle::SlabOf(values, dimensions, ranks), search, ranks);
      const std::vector<std::int32_t> number = std::move(found.Number.Values);
      if (ranks.Rank() == size - 1)
      {
        cut.Found = std::move(found);
      }
      return number;
    });
  return cut;
}

double Between(const Vector3& a, const Vector3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** An ellipsoid with the axes of space turned by 45 degrees about z. */
struct Ellipsoid
{
  Vector3 Centre, Axes;

  bool Has(const Vector3& p) const
  {
    const double x = p[0] - this->Centre[0], y = p[1] - this->Centre[1];
    const double u = (x + y) / std::sqrt(2.0), v = (y - x) / std::sqrt(2.0);
    return std::pow(u / this->Axes[0], 2) + std::pow(v / this->Axes[1], 2) +
      std::pow((p[2] - this->Centre[2]) / this->Axes[2], 2) <
      1.0;
  }
  double Volume() const
  {
    return 4.0 / 3.0 * oracle::Pi * this->Axes[0] * this->Axes[1] * this->Axes[2];
  }
  /** The surface of a spheroid, whose first two axes are equal, over that of its ball. */
  double Sphericity() const
  {
    const double a = this->Axes[0], c = this->Axes[2];
    const double e = std::sqrt(1.0 - std::pow(std::min(a, c) / std::max(a, c), 2));
    const double surface = c > a
      ? 2.0 * oracle::Pi * a * a * (1.0 + c / (a * e) * std::asin(e))
      : 2.0 * oracle::Pi * a * a * (1.0 + (1.0 - e * e) / e * std::atanh(e));
    return std::cbrt(oracle::Pi) * std::pow(6.0 * this->Volume(), 2.0 / 3.0) / surface;
  }
};

std::vector<float> ValuesOf(const std::vector<Ellipsoid>& ellipsoids, const std::array<int, 3>& n)
{
  std::vector<float> values;
  for (int k = 0; k < n[0] * n[1] * n[2]; ++k)
  {
    const Vector3 p = { k % n[0] + 0.5, k / n[0] % n[1] + 0.5, k / n[0] / n[1] + 0.5 };
    values.push_back(std::any_of(ellipsoids.begin(), ellipsoids.end(),
                       [&](const Ellipsoid& of) { return of.Has(p); })
        ? 1.0f
        : 0.0f);
  }
  return values;
}
}

TEST(CutParticles, SpheresInNoise)
{
  for (double noise : { 0.1, 0.3 })
  {
    const GreyScene scene = oracle::SpheresInCells(4, 9.0, noise, 11);
    const Cut cut = CutValues(oracle::GreysOf(scene), scene.Dimensions);
    const std::vector<ParticleShape>& shapes = cut.Found.Shapes;
    EXPECT_EQ(shapes.size(), scene.Balls.size());
    for (const CutParticles::Dropped& other : cut.Found.Others) // of noise
    {
      EXPECT_EQ(other.Reason, ruc::DropReason::Small);
    }
    double mean = 0.0;
    for (const ruc::Ball& ball : scene.Balls)
    {
      const auto nearest = std::min_element(shapes.begin(), shapes.end(),
        [&](const ParticleShape& a, const ParticleShape& b)
        { return Between(a.Centre, ball.Centre) < Between(b.Centre, ball.Centre); });
      EXPECT_LT(Between(nearest->Centre, ball.Centre), 0.3);
      // What is above the threshold ends within a part of a voxel of the surface
      const double more = nearest->EqualVolumeRadius() - ball.Radius;
      EXPECT_LT(std::abs(more), 0.25);
      mean += more / static_cast<double>(scene.Balls.size());
      EXPECT_GT(nearest->Sphericity(), 0.87); // its surface is rough
      EXPECT_EQ(nearest->BorderFaces, 0);
      EXPECT_NEAR(nearest->Reach, ball.Radius, 3.0); // voxels of noise may hang on to it
    }
    EXPECT_LT(std::abs(mean), 0.1);
    EXPECT_EQ(cut.Found.Smoothing, noise > 0.2 ? 1 : 0);
  }
}

TEST(CutParticles, EllipsoidsThatOverlap)
{
  // Two flat ones side by side and two long ones end to end, which share a hundredth of a volume
  const std::array<int, 3> n = { 90, 90, 70 };
  const std::vector<Ellipsoid> ellipsoids = { { { 20, 20, 20 }, { 14, 14, 7 } },
    { { 37.4, 37.4, 20 }, { 14, 14, 7 } }, { { 65, 25, 20 }, { 8, 8, 15 } },
    { { 65, 25, 48 }, { 8, 8, 15 } } };
  const Cut cut = CutValues(ValuesOf(ellipsoids, n), n);
  ASSERT_EQ(cut.Found.Shapes.size(), ellipsoids.size());
  for (const Ellipsoid& of : ellipsoids)
  {
    const auto nearest = std::min_element(cut.Found.Shapes.begin(), cut.Found.Shapes.end(),
      [&](const ParticleShape& a, const ParticleShape& b)
      { return Between(a.Centre, of.Centre) < Between(b.Centre, of.Centre); });
    EXPECT_LT(Between(nearest->Centre, of.Centre), 0.3);
    EXPECT_NEAR(nearest->Volume, of.Volume(), 0.02 * of.Volume());
    EXPECT_NEAR(nearest->Sphericity(), of.Sphericity(), 0.04);
  }
}

TEST(CutParticles, AreEqualOnAnyNumberOfRanks)
{
  const GreyScene scene = oracle::SpheresInCells(4, 6.0, 0.3, 12);
  const std::vector<float> values = oracle::GreysOf(scene);
  ParticleSearch search;
  search.WholeOnly = true;
  const Cut one = CutValues(values, scene.Dimensions, search);
  EXPECT_GT(one.Found.Shapes.size(), 5u);
  EXPECT_GT(one.Found.Others.size(), 5u);
  for (int size : { 2, 3, 4 })
  {
    const Cut other = CutValues(values, scene.Dimensions, search, size);
    EXPECT_EQ(other.Number, one.Number);
    EXPECT_EQ(other.Found.Margin, one.Found.Margin);
    ASSERT_EQ(other.Found.Shapes.size(), one.Found.Shapes.size());
    for (std::size_t n = 0; n < one.Found.Shapes.size(); ++n)
    {
      EXPECT_EQ(other.Found.Shapes[n].Centre, one.Found.Shapes[n].Centre);
      EXPECT_EQ(other.Found.Shapes[n].Surface, one.Found.Shapes[n].Surface);
      EXPECT_EQ(other.Found.Shapes[n].Reach, one.Found.Shapes[n].Reach);
    }
    EXPECT_EQ(other.Found.Others.size(), one.Found.Others.size());
  }
}

TEST(CutParticles, WhatIsNotKeptIsToldWhy)
{
  GreyScene scene;
  scene.Dimensions = { 60, 60, 60 };
  scene.Noise = 0.0;
  scene.Balls = { { { 20, 20, 20 }, 9.0 }, { { 45, 20, 20 }, 7.0 }, { { 20, 45, 40 }, 3.0 },
    { { 45, 45, 8.6 }, 8.0 }, { { 45, 57, 35 }, 7.0 } };
  const std::vector<float> values = oracle::GreysOf(scene);
  const Cut all = CutValues(values, scene.Dimensions);
  EXPECT_EQ(all.Found.Shapes.size(), 5u);
  EXPECT_EQ(all.Found.Shapes.back().BorderFaces, 0);
  ParticleSearch search;
  search.LeastDiameter = 8.0;
  search.WholeOnly = true;
  const Cut whole = CutValues(values, scene.Dimensions, search);
  // The window lies 9 voxels within the image
  EXPECT_NEAR(whole.Found.Margin, 9.0, 0.6);
  EXPECT_EQ(whole.Found.Shapes.size(), 2u);
  int reasons[2] = {};
  for (const CutParticles::Dropped& other : whole.Found.Others)
  {
    reasons[0] += other.Reason == ruc::DropReason::Small ? 1 : 0;
    reasons[1] += other.Reason == ruc::DropReason::NearBorder ? 1 : 0;
  }
  EXPECT_EQ(reasons[0], 1);
  EXPECT_EQ(reasons[1], 2);
  EXPECT_EQ(*std::min_element(whole.Number.begin(), whole.Number.end()), CutParticles::NotKept);
  EXPECT_EQ(*std::max_element(whole.Number.begin(), whole.Number.end()), 2);
}

TEST(CutParticles, StopsWhereAnyRankSaysSo)
{
  const GreyScene scene = oracle::SpheresInCells(2, 6.0, 0.1, 7);
  const std::vector<float> values = oracle::GreysOf(scene);
  std::vector<std::string> phases;
  for (int calls : { 0, 1, 2, 3, 4 })
  {
    oracle::ThreadRanks::Run(2,
      [&](ruc::Communicator& ranks)
      {
        int asked = 0;
        const CutParticles cut =
          ruc::CutImage(oracle::SlabOf(values, scene.Dimensions, ranks), {}, ranks,
            [&](double done, const std::string& what)
            {
              EXPECT_GE(done, 0.0);
              EXPECT_LT(done, 1.0);
              if (ranks.Rank() == 1 && calls == 4)
              {
                phases.push_back(what);
              }
              return ranks.Rank() == 0 || asked++ < calls;
            });
        EXPECT_EQ(cut.Stopped, calls < 4);
        EXPECT_EQ(cut.Shapes.empty(), calls < 4);
      });
  }
  EXPECT_EQ(phases.size(), 4u);
}

TEST(CutParticles, RefusesWhatHasNoParticles)
{
  const std::array<int, 3> n = { 20, 20, 20 };
  EXPECT_SAYS(CutValues(std::vector<float>(8000, 4.0f), n), "got one grey only, 4.");
  std::vector<float> speck(8000, 0.0f);
  speck[4000] = 1.0f;
  EXPECT_SAYS(CutValues(speck, n), "found no particle of a diameter of 3 voxels or more");
  ParticleSearch search;
  search.Threshold = 1.0;
  EXPECT_SAYS(CutValues(speck, n, search), "Threshold requires a value between those of the image");
}
