// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/BlurredBalls.h"

#include "GreyScenes.h"
#include "ruc/Images/Fit/BallEquations.h"

namespace
{
using ruc::Ball;
using ruc::BallSums;
using ruc::GreyModel;
using ruc::VoxelSlab;

VoxelSlab<float> Empty(const std::array<int, 3>& n)
{
  VoxelSlab<float> image = { n, 0, n[2], {} };
  image.Values.resize(n[2] * image.PlaneSize() + ruc::BlurredBalls::ValuesAfter, 0.0f);
  return image;
}

void AddAll(const Ball& ball, const GreyModel& model, double times, VoxelSlab<float>& image)
{
  for (int z = 0; z < image.Dimensions[2]; ++z)
  {
    ruc::BlurredBalls(model).Add(ball, times, z, image);
  }
}

double SumOfSquares(const VoxelSlab<float>& target, const Ball& ball, const GreyModel& model)
{
  VoxelSlab<float> left = target;
  AddAll(ball, model, -1.0, left);
  double sum = 0.0;
  for (float value : left.Values)
  {
    sum += 0.5 * value * value;
  }
  return sum;
}
}

TEST(BlurredBalls, AreBallsUnderAGaussian)
{
  // By the integral over shells of a radius s, on each of which the Gaussian is known, for balls of
  // more than four blurs
  const auto exact = [](double r, double radius, double blur)
  {
    const auto normal = [&](double t) { return std::exp(-0.5 * t * t / (blur * blur)); };
    return oracle::Integrate(0.0, radius, { r - 4.0 * blur, r - blur, r, r + blur, r + 4.0 * blur },
             [&](double s) { return s * (normal(r - s) - normal(r + s)); }) /
      (r * blur * std::sqrt(2.0 * oracle::Pi));
  };
  for (double blur : { 0.3, 1.04, 2.0 })
  {
    GreyModel model;
    model.Blur = blur;
    const Ball ball = { { 0.5, 0.5, 0.5 }, 4.1 * blur + 1.0 };
    VoxelSlab<float> image = Empty({ 24, 1, 1 });
    AddAll(ball, model, 1.0, image);
    for (int x = 1; x < 24; ++x)
    {
      EXPECT_NEAR(image.Values[x], exact(x, ball.Radius, blur), 2e-5) << x << " " << blur;
    }
  }
}

TEST(BlurredBalls, AreWhatABlurMakesOfShares)
{
  // The model's deviation holds the voxel's own, 1/12. Shares of voxels have frequencies beyond
  // those that voxels can show, which leaves 1e-2
  for (double radius : { 4.0, 7.3 })
  {
    for (const ruc::Vector3& edges : { ruc::Vector3{ 1, 1, 1 }, ruc::Vector3{ 0.97, 1.0, 1.04 } })
    {
      oracle::GreyScene scene;
      scene.Dimensions = { 31, 30, 29 };
      scene.Noise = 0.0;
      scene.Edges = edges;
      const Ball ball = { { 15.2, 14.9, 14.3 }, radius };
      scene.Balls = { ball };
      const std::vector<float> values = oracle::GreysOf(scene);
      GreyModel model;
      model.Contrast = oracle::SceneContrast;
      model.Blur = std::sqrt(1.0 + 1.0 / 12.0);
      model.Edges = edges;
      VoxelSlab<float> image = Empty(scene.Dimensions);
      AddAll(ball, model, 1.0, image);
      double worst = 0.0;
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        worst = std::max(worst,
          std::abs(image.Values[k] + oracle::SceneMatrix - values[k]) / oracle::SceneContrast);
      }
      EXPECT_LT(worst, 1e-2) << radius;
    }
  }
}

TEST(BlurredBalls, SumsAreDerivatives)
{
  GreyModel model;
  model.Contrast = 3.0;
  model.Blur = 1.1;
  const Ball ball = { { 9.7, 10.4, 11.2 }, 5.0 };
  VoxelSlab<float> target = Empty({ 22, 23, 24 });
  AddAll({ { 10.1, 10.2, 11.0 }, 5.3 }, model, 1.0, target);
  VoxelSlab<float> left = target;
  AddAll(ball, model, -1.0, left);
  const BallSums sums = ruc::BlurredBalls(model).Sum(ball, left);

  const double step = 0.02;
  for (int q = 0; q < 4; ++q)
  {
    const auto moved = [&](double by)
    {
      Ball other = ball;
      (q < 3 ? other.Centre[q] : other.Radius) += by;
      return SumOfSquares(target, other, model);
    };
    const double slope = (moved(step) - moved(-step)) / (2.0 * step);
    EXPECT_NEAR(-slope, sums.Gradient[q], 0.01 * std::abs(sums.Gradient[q]) + 0.01) << q;
  }
  GreyModel wider = model, narrower = model;
  wider.Blur += step;
  narrower.Blur -= step;
  const double slope =
    (SumOfSquares(target, ball, wider) - SumOfSquares(target, ball, narrower)) / (2.0 * step);
  EXPECT_NEAR(-slope, sums.BlurGradient, 0.01 * std::abs(sums.BlurGradient) + 0.02);
  // Of a whole ball the information about the radius, C^2 4 pi R^2 / (2 sqrt(pi) Blur), up to terms
  // of (Blur / R)^2
  EXPECT_NEAR(sums.Normal[9], 9.0 * 4.0 * oracle::Pi * 25.0 / (2.0 * std::sqrt(oracle::Pi) * 1.1),
    0.05 * sums.Normal[9]);
  // and a third of it about each coordinate, which do not depend on one another
  EXPECT_NEAR(sums.Normal[0], sums.Normal[9] / 3.0, 0.12 * sums.Normal[0]);
  EXPECT_NEAR(sums.Normal[1], 0.0, 0.02 * sums.Normal[0]);
}

TEST(BlurredBalls, GoOnBeyondTheBorder)
{
  GreyModel model;
  const Ball ball = { { -1.5, 3.0, 22.0 }, 4.0 };
  VoxelSlab<float> image = Empty({ 20, 20, 20 });
  AddAll(ball, model, 1.0, image);
  EXPECT_GT(*std::max_element(image.Values.begin(), image.Values.end()), 0.5f);
  const BallSums sums = ruc::BlurredBalls(model).Sum(ball, image);
  EXPECT_GT(sums.Square, 0.0);
  EXPECT_TRUE(std::isfinite(sums.Gradient[0]));
  const Ball away = { { -100.0, 3.0, 22.0 }, 4.0 };
  EXPECT_EQ(ruc::BlurredBalls(model).Sum(away, image).Square, 0.0);
}

TEST(BallEquations, AreSolvedWhereTheyCanBe)
{
  // J J^T of five rows of numbers
  oracle::Uniform random(2);
  double full[4][4] = {};
  for (int row = 0; row < 5; ++row)
  {
    const double j[4] = { random(), random(), random(), random() };
    for (int n = 0; n < 16; ++n)
    {
      full[n / 4][n % 4] += j[n / 4] * j[n % 4];
    }
  }
  std::array<double, 10> upper;
  for (int i = 0, n = 0; i < 4; ++i)
  {
    for (int k = i; k < 4; ++k, ++n)
    {
      upper[n] = full[i][k];
    }
  }
  const ruc::BallEquations equations(upper);
  ASSERT_TRUE(equations.AreSolvable());
  const std::array<double, 4> right = { 1.0, -2.0, 0.5, 3.0 };
  const std::array<double, 4> x = equations.Solve(right);
  for (int i = 0; i < 4; ++i)
  {
    double sum = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      sum += full[i][k] * x[k];
    }
    EXPECT_NEAR(sum, right[i], 1e-9);
  }
  upper[9] = 0.0; // nothing tells of the radius
  upper[3] = upper[6] = upper[8] = 0.0;
  EXPECT_FALSE(ruc::BallEquations(upper).AreSolvable());
  EXPECT_FALSE(ruc::BallEquations({}).AreSolvable());
}
