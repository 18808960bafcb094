// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/SphereFit.h"

#include "ruc/Base/VectorClones.h"
#include "ruc/Images/Fit/BallEquations.h"

#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
constexpr double LongestStep = 0.5;
constexpr double LeastFactor = 0.3; // of a step
// A ball that moves less stays: in voxels, and in standard errors
constexpr double LeastStep = 0.001, LeastStepOfError = 0.05;
constexpr double LeastRadius = 0.6;
constexpr double SmallestThatTells = 3.0; // of the blur, in blurs
constexpr double LeastBlur = 0.3, GreatestBlur = 5.0, LongestBlurStep = 0.2;
// Changes of the model that are less are not made: of the blur, and of grey values over the
// contrast
constexpr double LeastBlurStep = 5e-4, LeastGreyStep = 1e-4;
constexpr double FixedScale = 1 << 20; // of residuals, over the contrast

// Plain voxels are taken from the lowest of these shares that has enough of them
constexpr double Shares[] = { 0.001, 0.003, 0.01, 0.03, 0.1, 0.3 };
constexpr int BorderOfPlain = 3;
constexpr double EnoughPlain = 20000.0, EnoughShare = 0.01;

// A message of a rank about a ball that it has fitted
struct BallNews
{
  std::int64_t Number = 0;
  FittedBall Now;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Number, self.Now);
  }
};

struct RowOfGreys
{
  float Matrix, Inverse; // of the contrast
  float Share, MostResidual;
  int Count;
};

// Sums up a row over voxels that are nearly all matrix, and over those that are nearly all particle
RUC_VECTOR_CLONES
void SumPlainRow(
  const RowOfGreys& row, const float* image, const float* residual, std::int32_t* sums)
{
  std::int32_t matrices = 0, particles = 0, inMatrix = 0, inParticles = 0;
  for (int n = 0; n < row.Count; ++n)
  {
    const float g = residual[n] * row.Inverse;
    const float balls = (image[n] - row.Matrix) * row.Inverse - g;
    const float size = std::fabs(g);
    const std::int32_t fixed =
      size < row.MostResidual ? static_cast<std::int32_t>(g * static_cast<float>(FixedScale)) : 0;
    const std::int32_t good = size < row.MostResidual ? 1 : 0;
    const std::int32_t matrix = balls < row.Share ? good : 0;
    const std::int32_t particle = std::fabs(balls - 1.0f) < row.Share ? good : 0;
    matrices += matrix;
    particles += particle;
    inMatrix += matrix * fixed;
    inParticles += particle * fixed;
  }
  sums[0] = matrices;
  sums[1] = particles;
  sums[2] = inMatrix;
  sums[3] = inParticles;
}
}

bool FittedBall::Moves() const
{
  return this->Step >=
    std::max(LeastStep, LeastStepOfError * std::max(this->CenterError, this->RadiusError));
}

namespace
{
// Neighbours that step together go too far, and come back. How much too far the one step was tells
// the next (Barzilai and Borwein 1988)
double NextFactor(const FittedBall& ball, const std::array<double, 4>& step)
{
  double square = 0.0, product = 0.0;
  for (int q = 0; q < 4; ++q)
  {
    square += ball.Last[q] * ball.Last[q];
    product += ball.Last[q] * step[q];
  }
  if (square == 0.0)
  {
    return 1.0;
  }
  const double curvature = (1.0 - product / square) / ball.Factor;
  return curvature > 1.0 ? std::max(1.0 / curvature, LeastFactor) : 1.0;
}
}

SphereFit::SphereFit(
  VoxelSlab<float> image, const GreyModel& model, bool fixed, double noise, Communicator& ranks)
  : Image(std::move(image))
  , Model(model)
  , Fixed(fixed)
  , Noise(noise)
  , Ranks(ranks)
  , Planes{ this->Image.Dimensions[2], ranks.Size() }
  , LargestRadius(std::numeric_limits<double>::infinity())
{
}

std::vector<Ball> BallsOf(const std::vector<FittedBall>& fitted)
{
  std::vector<Ball> balls;
  balls.reserve(fitted.size());
  for (const FittedBall& ball : fitted)
  {
    balls.push_back(ball.At);
  }
  return balls;
}

void SphereFit::Add(const std::vector<Ball>& balls)
{
  const bool first = this->Balls.empty();
  for (const Ball& ball : balls)
  {
    FittedBall& added = this->Balls.emplace_back();
    added.At = ball;
    added.Start = first ? static_cast<std::int64_t>(this->Balls.size()) - 1 : -1;
  }
}

void SphereFit::Keep(const std::function<bool(const FittedBall&)>& keep)
{
  this->Shown.clear();
  const auto end = std::remove_if(
    this->Balls.begin(), this->Balls.end(), [&](const FittedBall& ball) { return !keep(ball); });
  this->Balls.erase(end, this->Balls.end());
}

bool SphereFit::Owns(const FittedBall& ball) const
{
  const double plane = std::clamp(std::floor(ball.At.Centre[2] / this->Model.Edges[2]), 0.0,
    static_cast<double>(this->Planes.Count - 1));
  return plane >= static_cast<double>(this->Planes.Begin(this->Ranks.Rank())) &&
    plane < static_cast<double>(this->Planes.End(this->Ranks.Rank()));
}

void SphereFit::Widen()
{
  double reach = 0.0;
  for (const FittedBall& ball : this->Balls)
  {
    reach = std::max(reach, this->Reach(ball.At));
  }
  const int needed = static_cast<int>(reach / this->Model.Edges[2]) + 1;
  if (needed > this->Halo)
  {
    this->Halo = needed + 4; // not again for every small step
    this->Residual = {};
    SetHalo(this->Image, this->Halo, this->Ranks);
  }
  if (this->Residual.Values.empty())
  {
    this->Shown.clear();
    this->Residual = { this->Image.Dimensions, this->Image.First, this->Image.Last, {} };
    this->Residual.Values.resize(this->Image.Values.size() + BlurredBalls::ValuesAfter);
  }
}

void SphereFit::SumPlane(int z, double share, PlainSums& sums) const
{
  RowOfGreys row;
  row.Matrix = static_cast<float>(this->Model.Matrix);
  row.Inverse = static_cast<float>(1.0 / this->Model.Contrast);
  row.Share = static_cast<float>(share);
  row.MostResidual = static_cast<float>(this->MostResidual);
  // Not next to the border, where balls that hardly reach into the image may be missing
  const auto inside = [&](int q) { return std::min(BorderOfPlain, this->Image.Dimensions[q] / 4); };
  row.Count = this->Image.Dimensions[0] - 2 * inside(0);
  if (z < inside(2) || z >= this->Image.Dimensions[2] - inside(2))
  {
    return;
  }
  for (int y = inside(1); y < this->Image.Dimensions[1] - inside(1); ++y)
  {
    std::int32_t of[4];
    SumPlainRow(row, this->Image.Row(y, z) + inside(0), this->Residual.Row(y, z) + inside(0), of);
    for (int n = 0; n < 2; ++n)
    {
      sums.Count[n] += of[n];
      sums.Residual[n] += of[2 + n];
    }
  }
}

SphereFit::PlainSums SphereFit::SumPlain() const
{
  const int first = static_cast<int>(this->Planes.Begin(this->Ranks.Rank()));
  const int last = static_cast<int>(this->Planes.End(this->Ranks.Rank()));
  std::int64_t sums[4] = {};
#pragma omp parallel for schedule(static) reduction(+ : sums)
  for (int z = first; z < last; ++z)
  {
    PlainSums of;
    this->SumPlane(z, this->Share, of);
    for (int n = 0; n < 2; ++n)
    {
      sums[n] += of.Count[n];
      sums[2 + n] += of.Residual[n];
    }
  }
  this->Ranks.Sum(sums, 4);
  PlainSums all;
  std::copy_n(sums, 2, all.Count);
  std::copy_n(sums + 2, 2, all.Residual);
  return all;
}

void SphereFit::Render()
{
  this->Widen();
  std::vector<Change> changes;
  const bool all = this->Shown.empty() || !(this->ShownModel == this->Model);
  for (std::size_t n = 0; n < this->Balls.size(); ++n)
  {
    const Ball& now = this->Balls[n].At;
    if (!all && n < this->Shown.size() && !(this->Shown[n] == now))
    {
      changes.push_back({ this->Shown[n], 1.0 });
    }
    if (all || n >= this->Shown.size() || !(this->Shown[n] == now))
    {
      changes.push_back({ now, -1.0 });
    }
  }
  this->Shown = BallsOf(this->Balls);
  this->ShownModel = this->Model;
  this->Apply(changes, all);
}

void SphereFit::Apply(const std::vector<Change>& changes, bool all)
{
  const int first = this->Image.First, last = this->Image.Last;
  std::vector<std::vector<std::int32_t>> ofPlane(last - first);
  for (std::size_t n = 0; n < changes.size(); ++n)
  {
    const Ball& ball = changes[n].Of;
    const double reach = this->Reach(ball), edge = this->Model.Edges[2];
    const int from = std::max(first, static_cast<int>(std::floor((ball.Centre[2] - reach) / edge)));
    const int to = std::min(last, static_cast<int>(std::ceil((ball.Centre[2] + reach) / edge)) + 1);
    for (int z = from; z < to; ++z)
    {
      ofPlane[z - first].push_back(static_cast<std::int32_t>(n));
    }
  }
  const BlurredBalls balls(this->Model);
  const float matrix = static_cast<float>(this->Model.Matrix);
#pragma omp parallel for schedule(dynamic)
  for (int z = first; z < last; ++z)
  {
    if (all)
    {
      const float* image = this->Image.Row(0, z);
      std::transform(image, image + this->Image.PlaneSize(), this->Residual.Row(0, z),
        [matrix](float value) { return value - matrix; });
    }
    for (std::int32_t n : ofPlane[z - first])
    {
      balls.Add(changes[n].Of, changes[n].Times, z, this->Residual);
    }
  }
}

void SphereFit::ChooseShare()
{
  const double voxels =
    1.0 * this->Image.Dimensions[0] * this->Image.Dimensions[1] * this->Image.Dimensions[2];
  this->Render();
  for (double share : Shares)
  {
    this->Share = share;
    const PlainSums sums = this->SumPlain();
    if (std::min(sums.Count[0], sums.Count[1]) >= std::max(EnoughPlain, EnoughShare * voxels))
    {
      break;
    }
  }
}

void SphereFit::MoveGreys(const PlainSums& sums)
{
  if (this->Fixed || sums.Count[0] == 0 || sums.Count[1] == 0)
  {
    return;
  }
  const double unit = this->Model.Contrast / FixedScale;
  const double matrix = unit * sums.Residual[0] / sums.Count[0];
  const double particle = unit * sums.Residual[1] / sums.Count[1];
  if (std::max(std::abs(matrix), std::abs(particle)) > LeastGreyStep * this->Model.Contrast)
  {
    this->Model.Matrix += matrix;
    this->Model.Contrast += particle - matrix;
  }
}

FittedBall SphereFit::Moved(const FittedBall& ball, const BallSums& sums) const
{
  FittedBall moved = ball;
  moved.Contrast =
    sums.Square > 0.0 ? 1.0 + sums.Product / (this->Model.Contrast * sums.Square) : 0.0;
  moved.Residual = sums.Weights > 0.0 ? std::sqrt(sums.WeightedSquares / sums.Weights) : 0.0;
  moved.Signal = moved.Residual > 0.0
    ? moved.Contrast * this->Model.Contrast * std::sqrt(sums.Square) / moved.Residual
    : std::numeric_limits<double>::infinity();
  // The model of small balls is not good enough to tell of the blur
  const bool tells = ball.At.Radius > SmallestThatTells * this->Model.Blur;
  moved.BlurSquare = tells ? sums.BlurSquare : 0.0;
  moved.BlurGradient = tells ? sums.BlurGradient : 0.0;
  const BallEquations equations(sums.Normal);
  moved.Step = 0.0;
  if (!equations.AreSolvable())
  {
    moved.Contrast = 0.0;
    return moved;
  }
  const std::array<double, 4> step = equations.Solve(sums.Gradient);
  for (double part : step)
  {
    moved.Step = std::max(moved.Step, std::abs(part));
  }
  moved.Factor = NextFactor(ball, step);
  moved.Last = step;
  const double share = std::min(moved.Factor, LongestStep / std::max(moved.Step, 1e-300));
  for (int q = 0; q < 3; ++q)
  {
    moved.At.Centre[q] += share * step[q];
  }
  double centre = 0.0;
  for (int q = 0; q < 4; ++q)
  {
    std::array<double, 4> unit{};
    unit[q] = 1.0;
    const double variance = equations.Solve(unit)[q];
    centre += q < 3 ? variance / 3.0 : 0.0;
    moved.RadiusError = moved.Residual * std::sqrt(variance);
  }
  moved.CenterError = moved.Residual * std::sqrt(centre);
  moved.At.Radius = std::clamp(moved.At.Radius + share * step[3], LeastRadius, this->LargestRadius);
  return moved;
}

void SphereFit::MoveBalls()
{
  std::vector<std::int64_t> own;
  for (std::size_t n = 0; n < this->Balls.size(); ++n)
  {
    this->Balls[n].BlurGradient = 0.0; // that of balls that stay was taken before
    if (this->Balls[n].Moves() && this->Owns(this->Balls[n]))
    {
      own.push_back(static_cast<std::int64_t>(n));
    }
  }
  // Neighbours one after the other, whose voxels are then near
  const auto place = [&](std::int64_t n)
  {
    constexpr double block = 24.0;
    const Vector3& c = this->Balls[n].At.Centre;
    return std::tuple(std::floor(c[2] / block), std::floor(c[1] / block), c[0]);
  };
  std::sort(
    own.begin(), own.end(), [&](std::int64_t a, std::int64_t b) { return place(a) < place(b); });
  std::vector<BallNews> news(own.size());
#pragma omp parallel
  {
    const BlurredBalls balls(this->Model);
#pragma omp for schedule(dynamic, 16)
    for (std::size_t k = 0; k < own.size(); ++k)
    {
      const FittedBall& ball = this->Balls[own[k]];
      news[k] = { own[k], this->Moved(ball, balls.Sum(ball.At, this->Residual)) };
    }
  }
  const std::vector<BallNews> all = this->Ranks.Concatenate(news);
  const std::size_t moved = all.size();
  for (const BallNews& of : all)
  {
    this->Balls[of.Number] = of.Now;
  }
  double square = 0.0, gradient = 0.0;
  for (const FittedBall& ball : this->Balls)
  {
    square += ball.BlurSquare;
    gradient += ball.BlurGradient;
  }
  // Few balls, which may not be balls at all, are not asked
  if (!this->Fixed && square > 0.0 && 10 * moved > this->Balls.size())
  {
    const double step = std::clamp(gradient / square, -LongestBlurStep, LongestBlurStep);
    this->Model.Blur = std::abs(step) > LeastBlurStep
      ? std::clamp(this->Model.Blur + step, LeastBlur, GreatestBlur)
      : this->Model.Blur;
  }
}

bool SphereFit::Run(int most, double mostMoving, const std::function<bool()>& goOn)
{
  for (FittedBall& ball : this->Balls)
  {
    ball.Step = 1.0;
  }
  if (!this->Fixed)
  {
    this->ChooseShare();
    this->MoveGreys(this->SumPlain());
    this->MostResidual = std::clamp(3.0 * this->Noise / this->Model.Contrast, 0.05, 1.0);
  }
  for (int sweep = 0; sweep < most; ++sweep)
  {
    if (!goOn())
    {
      return false;
    }
    this->Render();
    const PlainSums sums = this->SumPlain();
    this->MoveBalls();
    this->MoveGreys(sums);
    ++this->Sweeps;
    const auto moving = std::count_if(
      this->Balls.begin(), this->Balls.end(), [](const FittedBall& ball) { return ball.Moves(); });
    if (moving <= mostMoving * this->Balls.size())
    {
      break;
    }
  }
  return true;
}

VoxelSlab<float> SphereFit::FindResidual(int halo)
{
  this->Render();
  this->Shown.clear();
  VoxelSlab<float> left = std::move(this->Residual);
  this->Residual = {};
  left.Values.resize(this->Image.Values.size());
  SetHalo(left, halo, this->Ranks);
  return left;
}

VoxelSlab<float> SphereFit::TakeImage()
{
  this->Residual = {};
  SetHalo(this->Image, 0, this->Ranks);
  return std::move(this->Image);
}
}
