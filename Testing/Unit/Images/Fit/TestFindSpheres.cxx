// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/FindSpheres.h"

#include "GreyScenes.h"

#include <omp.h>

namespace
{
using oracle::GreyScene;
using ruc::Ball;
using ruc::FittedBall;
using ruc::FoundSpheres;
using ruc::SphereSearch;

FoundSpheres Find(const GreyScene& scene, const std::vector<float>& values,
  const SphereSearch& search = {}, int size = 1, const std::vector<Ball>& starts = {})
{
  FoundSpheres found;
  oracle::ThreadRanks::Run(size,
    [&](ruc::Communicator& ranks)
    {
      ruc::VoxelSlab<float> image = oracle::SlabOf(values, scene.Dimensions, ranks);
      const std::vector<float> before = image.Values;
      FoundSpheres own = ruc::FindSpheres(image, search, starts, ranks);
      EXPECT_EQ(image.Values, before); // it comes back
      if (ranks.Rank() == size - 1)
      {
        found = std::move(own);
      }
    });
  return found;
}

/** Root mean squares over the balls of a scene that are whole in it. */
struct Errors
{
  int Balls = 0, Missing = 0, False = 0;
  double Radius = 0.0, Centre = 0.0;         // over the least that is possible
  double RadiusPull = 0.0, CentrePull = 0.0; // over the errors that the fit tells
  double Bias = 0.0;                         // of the radius, its mean share
};

Errors Compare(const GreyScene& scene, const std::vector<FittedBall>& found)
{
  Errors errors;
  std::vector<bool> used(found.size(), false);
  const double blur = std::sqrt(scene.Blur * scene.Blur + 1.0 / 12.0);
  for (const Ball& ball : scene.Balls)
  {
    const FittedBall* nearest = nullptr;
    double least = 0.5 * ball.Radius;
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      const ruc::Vector3& c = found[n].At.Centre;
      const double away =
        std::hypot(c[0] - ball.Centre[0], c[1] - ball.Centre[1], c[2] - ball.Centre[2]);
      if (away < least)
      {
        least = away;
        nearest = &found[n];
        used[n] = true;
      }
    }
    if (!nearest)
    {
      ++errors.Missing;
      continue;
    }
    // Cramer and Rao: the information of a sphere in blurred white noise
    const double bound = scene.Noise *
      std::sqrt(
        2.0 * std::sqrt(oracle::Pi) * blur / (4.0 * oracle::Pi * ball.Radius * ball.Radius));
    const double error = nearest->At.Radius - ball.Radius;
    ++errors.Balls;
    errors.Radius += error * error / (bound * bound);
    errors.Centre +=
      least * least / (9.0 * bound * bound); // three coordinates of sqrt(3) the bound
    errors.RadiusPull += std::pow(error / nearest->RadiusError, 2);
    errors.CentrePull += least * least / (3.0 * nearest->CenterError * nearest->CenterError);
    errors.Bias += error / ball.Radius;
  }
  errors.False = static_cast<int>(std::count(used.begin(), used.end(), false));
  for (double* sum : { &errors.Radius, &errors.Centre, &errors.RadiusPull, &errors.CentrePull })
  {
    *sum = std::sqrt(*sum / errors.Balls);
  }
  errors.Bias /= errors.Balls;
  return errors;
}

void ExpectSame(const FoundSpheres& a, const FoundSpheres& b)
{
  ASSERT_EQ(a.Balls.size(), b.Balls.size());
  EXPECT_EQ(a.Sweeps, b.Sweeps);
  EXPECT_TRUE(a.Model == b.Model);
  EXPECT_TRUE(ruc::BallsOf(a.Balls) == ruc::BallsOf(b.Balls));
  for (std::size_t n = 0; n < a.Balls.size(); ++n)
  {
    EXPECT_EQ(a.Balls[n].RadiusError, b.Balls[n].RadiusError);
    EXPECT_EQ(a.Balls[n].CenterError, b.Balls[n].CenterError);
    EXPECT_EQ(a.Balls[n].Contrast, b.Balls[n].Contrast);
  }
  ASSERT_EQ(a.Dropped.size(), b.Dropped.size());
  for (std::size_t n = 0; n < a.Dropped.size(); ++n)
  {
    EXPECT_TRUE(a.Dropped[n].Ball.At == b.Dropped[n].Ball.At);
    EXPECT_EQ(a.Dropped[n].Reason, b.Dropped[n].Reason);
  }
}
}

TEST(FindSpheres, FindsAllAsWellAsIsPossible)
{
  // 343 spheres of diameters around 12.8 voxels: a root mean square is within 1 / sqrt(2 * 343) of
  // its expectation in two thirds of all images, 4 % for radii and 2 % for centres
  const GreyScene scene = oracle::SpheresInCells(7, 8.0, 0.1, 1);
  const FoundSpheres found = Find(scene, oracle::GreysOf(scene));
  const Errors errors = Compare(scene, found.Balls);
  EXPECT_EQ(errors.Missing, 0);
  EXPECT_EQ(errors.False, 0);
  EXPECT_LT(errors.Radius, 1.15);
  EXPECT_LT(errors.Centre, 1.15);
  EXPECT_GT(errors.Radius, 0.85); // less is not possible but for chance
  EXPECT_GT(errors.Centre, 0.9);
  EXPECT_LT(std::abs(errors.Bias), 5e-4);
  // The fit knows how good it is
  EXPECT_NEAR(errors.RadiusPull, 1.0, 0.12);
  EXPECT_NEAR(errors.CentrePull, 1.0, 0.12);
  EXPECT_NEAR(found.Model.Matrix, oracle::SceneMatrix, 1.0);
  EXPECT_NEAR(found.Model.Contrast, oracle::SceneContrast, 1.5);
  EXPECT_NEAR(found.Model.Blur, std::sqrt(1.0 + 1.0 / 12.0), 0.01);
  EXPECT_NEAR(found.Levels.Noise, 50.0, 1.0);
}

TEST(FindSpheres, ErrorsAreCalibratedInStrongNoise)
{
  GreyScene scene = oracle::SpheresInCells(6, 8.0, 0.4, 2);
  const FoundSpheres found = Find(scene, oracle::GreysOf(scene));
  const Errors errors = Compare(scene, found.Balls);
  EXPECT_GE(found.Smoothing, 1);
  EXPECT_EQ(errors.Missing, 0);
  EXPECT_EQ(errors.False, 0);
  EXPECT_NEAR(errors.RadiusPull, 1.0, 0.16); // of 216 spheres
  EXPECT_NEAR(errors.CentrePull, 1.0, 0.13);
}

TEST(FindSpheres, IsEqualOnAnyNumberOfRanksAndThreads)
{
  GreyScene scene = oracle::SpheresInCells(4, 6.0, 0.15, 3);
  scene.Dimensions[2] -= 4; // some are cut
  const std::vector<float> values = oracle::GreysOf(scene);
  const FoundSpheres one = Find(scene, values);
  EXPECT_GT(one.Balls.size(), 50u);
  for (int size : { 2, 3, 4 })
  {
    ExpectSame(Find(scene, values, {}, size), one);
  }
  for (int threads : { 1, 3 })
  {
    omp_set_num_threads(threads);
    ExpectSame(Find(scene, values), one);
  }
  omp_set_num_threads(1);
}

TEST(FindSpheres, WhatIsLeftIsNoise)
{
  GreyScene scene = oracle::SpheresInCells(4, 6.0, 0.1, 4);
  const std::vector<float> values = oracle::GreysOf(scene);
  const FoundSpheres found = Find(scene, values);
  const auto left = [&](int size)
  {
    return oracle::Together<float>(size,
      [&](ruc::Communicator& ranks) {
        return ruc::ResidualOf(oracle::SlabOf(values, scene.Dimensions, ranks), found, ranks)
          .Values;
      });
  };
  const std::vector<float> residual = left(1);
  double square = 0.0;
  for (float value : residual)
  {
    square += value * value;
  }
  EXPECT_NEAR(std::sqrt(square / residual.size()), 50.0, 0.5);
  EXPECT_EQ(left(3), residual);
}

TEST(FindSpheres, OfTwoValues)
{
  // Voxels by their centres alone: the radius is uncertain by the voxels at the surface
  GreyScene scene = oracle::SpheresInCells(4, 10.0, 0.0, 5);
  std::vector<float> values = oracle::SharesOf(scene);
  for (float& value : values)
  {
    value = value > 0.5f ? 7.0f : 2.0f;
  }
  SphereSearch search;
  search.Binary = true;
  const FoundSpheres found = Find(scene, values, search);
  EXPECT_EQ(found.Model.Matrix, 2.0);
  EXPECT_EQ(found.Model.Contrast, 5.0);
  ASSERT_EQ(found.Balls.size(), scene.Balls.size());
  for (const FittedBall& ball : found.Balls)
  {
    const bool known = std::any_of(scene.Balls.begin(), scene.Balls.end(),
      [&](const Ball& other)
      {
        return std::hypot(ball.At.Centre[0] - other.Centre[0], ball.At.Centre[1] - other.Centre[1],
                 ball.At.Centre[2] - other.Centre[2]) < 0.15 &&
          std::abs(ball.At.Radius - other.Radius) < 0.015 * other.Radius;
      });
    EXPECT_TRUE(known);
  }
}

TEST(FindSpheres, VoxelsThatAreNearlyCubes)
{
  GreyScene scene = oracle::SpheresInCells(3, 7.0, 0.05, 6);
  scene.Edges = { 0.97, 1.0, 1.0309 };
  for (int q = 0; q < 3; ++q)
  {
    scene.Dimensions[q] = static_cast<int>(std::ceil(scene.Dimensions[q] / scene.Edges[q]));
  }
  SphereSearch search;
  search.Edges = scene.Edges;
  const Errors errors = Compare(scene, Find(scene, oracle::GreysOf(scene), search).Balls);
  EXPECT_EQ(errors.Missing + errors.False, 0);
  EXPECT_LT(std::abs(errors.Bias), 1e-3);
  EXPECT_LT(errors.Centre, 1.3);
}

TEST(FindSpheres, WhatIsNoParticleIsToldWhy)
{
  GreyScene scene;
  scene.Dimensions = { 60, 60, 60 };
  scene.Noise = 0.02;
  scene.Balls = { { { 20, 20, 20 }, 9.0 }, { { 45, 20, 20 }, 7.0 }, { { 20, 45, 40 }, 8.0 },
    { { 61.5, 40, 40 }, 9.0 }, { { 45, 45, 8.5 }, 9.0 } };
  const std::vector<float> values = oracle::GreysOf(scene);
  const auto count = [](const FoundSpheres& found, ruc::DropReason reason)
  {
    return std::count_if(found.Dropped.begin(), found.Dropped.end(),
      [&](const ruc::DroppedBall& ball) { return ball.Reason == reason; });
  };
  const FoundSpheres found = Find(scene, values);
  EXPECT_EQ(found.Balls.size(), 4u);
  EXPECT_EQ(count(found, ruc::DropReason::Outside), 1);
  SphereSearch search;
  search.WholeOnly = true;
  const FoundSpheres whole = Find(scene, values, search);
  // Only those with centres 9 voxels and more from the border, of which none is cut
  EXPECT_EQ(whole.Balls.size(), 3u);
  EXPECT_EQ(count(whole, ruc::DropReason::NearBorder), 1);
  EXPECT_NEAR(whole.Margin, 9.0, 0.1);
  EXPECT_EQ(found.Margin, 0.0);
  search = {};
  search.LeastDiameter = 15.0;
  const FoundSpheres large = Find(scene, values, search);
  EXPECT_EQ(large.Balls.size(), 3u);
  EXPECT_GE(count(large, ruc::DropReason::Small), 1);
  EXPECT_STREQ(ruc::NameOf(ruc::DropReason::Overlaps), "overlaps a larger one");
}

TEST(FindSpheres, FitsWhatItIsGiven)
{
  const GreyScene scene = oracle::SpheresInCells(3, 6.0, 0.1, 7);
  std::vector<Ball> starts(scene.Balls.begin(), scene.Balls.begin() + 20);
  for (Ball& ball : starts)
  {
    ball.Centre[0] += 0.6;
    ball.Radius *= 1.05;
  }
  const FoundSpheres found = Find(scene, oracle::GreysOf(scene), {}, 1, starts);
  ASSERT_EQ(found.Balls.size(), 20u);
  for (int n = 0; n < 20; ++n) // in the same order
  {
    EXPECT_EQ(found.Balls[n].Start, n);
    EXPECT_NEAR(found.Balls[n].At.Centre[0], scene.Balls[n].Centre[0], 0.1);
    EXPECT_NEAR(found.Balls[n].At.Radius, scene.Balls[n].Radius, 0.1);
  }
}

TEST(FindSpheres, StopsWhereAnyRankSaysSo)
{
  const GreyScene scene = oracle::SpheresInCells(3, 6.0, 0.1, 7);
  const std::vector<float> values = oracle::GreysOf(scene);
  for (int calls : { 0, 1, 3, 8 })
  {
    oracle::ThreadRanks::Run(2,
      [&](ruc::Communicator& ranks)
      {
        ruc::VoxelSlab<float> image = oracle::SlabOf(values, scene.Dimensions, ranks);
        int asked = 0;
        const FoundSpheres found = ruc::FindSpheres(image, {}, {}, ranks,
          [&](double done, const std::string&)
          {
            EXPECT_GE(done, 0.0);
            EXPECT_LE(done, 1.0);
            return ranks.Rank() == 0 || asked++ < calls;
          });
        EXPECT_TRUE(found.Stopped);
        EXPECT_LE(found.Sweeps, calls);
      });
  }
}

TEST(FindSpheres, RefusesWhatHasNoParticles)
{
  GreyScene scene;
  scene.Dimensions = { 20, 20, 20 };
  EXPECT_SAYS(Find(scene, std::vector<float>(8000, 4.0f)), "got one grey only, 4.");
  std::vector<float> speck(8000, 0.0f);
  speck[4000] = 1.0f;
  SphereSearch search;
  search.Binary = true;
  EXPECT_SAYS(Find(scene, speck, search), "found no particle of a diameter of 3 voxels or more");
  search.Threshold = 1.0;
  EXPECT_SAYS(Find(scene, speck, search), "Threshold requires a value between those of the image");
  search = {};
  search.MatrixValue = 5.0;
  search.ParticleValue = 3.0;
  EXPECT_SAYS(
    Find(scene, speck, search), "ParticleValue requires a value above that of the matrix");
}
