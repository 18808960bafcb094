// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/ParticleLabels.h"

#include "GreyScenes.h"
#include "ruc/Images/Fit/FindSpheres.h"

namespace
{
using ruc::Ball;
using ruc::ParticleShape;

std::vector<ParticleShape> Measure(
  const std::vector<std::int32_t>& labels, const std::array<int, 3>& n, int count, int size = 1)
{
  std::vector<ParticleShape> shapes;
  oracle::ThreadRanks::Run(size,
    [&](ruc::Communicator& ranks)
    {
      const auto own =
        ruc::MeasureShapes(oracle::SlabOf(labels, n, ranks), count, { 1, 1, 1 }, ranks);
      if (ranks.Rank() == size - 1)
      {
        shapes = own;
      }
    });
  return shapes;
}
}

TEST(ParticleLabels, AreThoseOfTheNearestSurface)
{
  const oracle::GreyScene scene = oracle::SpheresInCells(3, 9.0, 0.0, 8);
  const std::vector<float> shares = oracle::SharesOf(scene);
  std::vector<float> residual = shares;
  for (std::size_t k = 0; k < shares.size(); ++k)
  {
    const int n = scene.Dimensions[0];
    const double x = k % n + 0.5, y = k / n % n + 0.5, z = k / n / n + 0.5;
    for (const Ball& ball : scene.Balls)
    {
      residual[k] -=
        std::hypot(x - ball.Centre[0], y - ball.Centre[1], z - ball.Centre[2]) < ball.Radius;
    }
  }
  const auto run = [&](int size)
  {
    return oracle::Together<std::int32_t>(size,
      [&](ruc::Communicator& ranks)
      {
        // Hardly blurred, so that only the shares decide
        ruc::GreyModel model;
        model.Blur = 1e-6;
        return ruc::LabelVoxels(
          oracle::SlabOf(residual, scene.Dimensions, ranks), model, scene.Balls)
          .Values;
      });
  };
  const std::vector<std::int32_t> labels = run(1);
  for (std::size_t k = 0; k < labels.size(); ++k)
  {
    const int n = scene.Dimensions[0];
    const double x = k % n + 0.5, y = k / n % n + 0.5, z = k / n / n + 0.5;
    double nearest = 1e9;
    int number = 0;
    for (std::size_t b = 0; b < scene.Balls.size(); ++b)
    {
      const Ball& ball = scene.Balls[b];
      const double away =
        std::hypot(x - ball.Centre[0], y - ball.Centre[1], z - ball.Centre[2]) - ball.Radius;
      number = away < nearest ? static_cast<int>(b) + 1 : number;
      nearest = std::min(nearest, away);
    }
    ASSERT_EQ(labels[k], shares[k] > 0.5f ? number : 0) << x << " " << y << " " << z;
  }
  EXPECT_EQ(run(2), labels);
  EXPECT_EQ(run(4), labels);
  const auto shapes = Measure(labels, scene.Dimensions, static_cast<int>(scene.Balls.size()));
  for (std::size_t b = 0; b < shapes.size(); ++b)
  {
    // The volume of a ball to what its surface makes uncertain; Crofton's formula to some per cent
    EXPECT_NEAR(shapes[b].EqualVolumeRadius(), scene.Balls[b].Radius, 0.06);
    EXPECT_NEAR(shapes[b].Sphericity(), 1.0, 0.05);
    for (int q = 0; q < 3; ++q)
    {
      EXPECT_NEAR(shapes[b].Centre[q], scene.Balls[b].Centre[q], 0.1);
    }
  }
}

TEST(ParticleLabels, OfABlurredBallHaveItsVolume)
{
  oracle::GreyScene scene = oracle::SpheresInCells(3, 6.0, 0.0, 9);
  scene.Blur = 1.5;
  ruc::GreyModel model;
  model.Matrix = oracle::SceneMatrix;
  model.Contrast = oracle::SceneContrast;
  model.Blur = std::sqrt(1.5 * 1.5 + 1.0 / 12.0);
  ruc::Communicator one;
  ruc::FoundSpheres found;
  found.Model = model;
  for (const Ball& ball : scene.Balls)
  {
    found.Balls.emplace_back().At = ball;
  }
  const auto residual =
    ruc::ResidualOf(oracle::SlabOf(oracle::GreysOf(scene), scene.Dimensions, one), found, one);
  const auto labels = ruc::LabelVoxels(residual, model, scene.Balls);
  const auto shapes = Measure(labels.Values, scene.Dimensions, 27);
  // By the middle of both values they would be 0.4 to 0.7 voxels less, and with the neighbours'
  // blur 0.2 more. How many centres of voxels a ball of 250 has depends on its place
  double mean = 0.0;
  for (std::size_t b = 0; b < shapes.size(); ++b)
  {
    const double more = shapes[b].EqualVolumeRadius() - scene.Balls[b].Radius;
    EXPECT_NEAR(more, 0.0, 0.2);
    mean += more / static_cast<double>(shapes.size());
  }
  EXPECT_NEAR(mean, 0.0, 0.02);
}

TEST(ParticleLabels, ShapesOfABlock)
{
  // A cube of 20 voxels: its sphericity is (pi / 6)^(1/3) = 0.806; 13 directions see its surface,
  // 2400, too small by up to a tenth
  const std::array<int, 3> n = { 30, 30, 30 };
  std::vector<std::int32_t> labels(27000, 0);
  for (int k = 0; k < 8000; ++k)
  {
    labels[((k / 400 + 5) * 30 + k / 20 % 20 + 4) * 30 + k % 20 + 3] = 2;
  }
  const auto shapes = Measure(labels, n, 3);
  EXPECT_EQ(shapes[1].Volume, 8000.0);
  EXPECT_NEAR(shapes[1].Surface, 2400.0, 240.0);
  EXPECT_NEAR(shapes[1].Sphericity(), 0.806, 0.09);
  EXPECT_EQ(shapes[1].Centre, (ruc::Vector3{ 13.0, 14.0, 15.0 }));
  EXPECT_EQ(shapes[0].Volume, 0.0);
  EXPECT_TRUE(std::isnan(shapes[2].Sphericity()));
  for (int size : { 2, 4 })
  {
    const auto other = Measure(labels, n, 3, size);
    EXPECT_EQ(other[1].Surface, shapes[1].Surface);
    EXPECT_EQ(other[1].Centre, shapes[1].Centre);
  }
}
