// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/FindSpheres.h"

#include "ruc/Base/Text.h"
#include "ruc/Images/Fit/DistanceMap.h"
#include "ruc/Images/Fit/SphereCandidates.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr int Rounds = 3;
constexpr int FirstSweeps = 6, SweepsOfRound = 4, LastSweeps = 12;
constexpr double MovingOfRound = 0.1; // the share of balls that may still move in a round
// Of a million voxels of noise, smoothed, some reach six deviations, and the fit looks for the
// place where they reach more
constexpr double LeastSignal = 10.0;
constexpr double LeastContrast = 0.5, BlurOfBinary = 0.3;
constexpr double LeastCandidate = 1.0; // the radius of one that is fitted

bool IsCandidate(const FittedBall& ball)
{
  return ball.Contrast > LeastContrast && ball.At.Radius > LeastCandidate;
}

// A run on all ranks, which any of them may stop
class Search
{
public:
  Search(const SphereSearch& how, Communicator& ranks,
    const std::function<bool(double, const std::string&)>& progress)
    : How(how)
    , Ranks(ranks)
    , Progress(progress)
  {
  }

  FoundSpheres Find(VoxelSlab<float>& image, const std::vector<Ball>& starts);

private:
  bool GoOn(double done, const std::string& what)
  {
    const bool yes = !this->Progress || this->Progress(done, what);
    this->Found.Stopped = !this->Ranks.All(yes) || this->Found.Stopped;
    return !this->Found.Stopped;
  }
  GreyModel FindLevels(const VoxelSlab<float>& image);
  std::vector<Ball> FindCandidates(const VoxelSlab<float>& image);
  std::vector<Ball> FindMissing(SphereFit& fit);
  bool Run(SphereFit& fit, int most, double mostMoving, double from, double to);
  void Fit(SphereFit& fit, const std::vector<Ball>& starts, bool more);
  // Moves the balls for which there is a reason from the fit to those dropped
  using Reason = std::function<std::optional<DropReason>(const FittedBall& ball, std::size_t n)>;
  void Drop(SphereFit& fit, const Reason& find);
  void DropFalse(SphereFit& fit);
  // Those outside are fitted to the end, as they are seen in the image
  void DropOutside(SphereFit& fit);
  // Whether the centre is not within the image less a margin
  bool IsOutside(const FittedBall& ball, double margin) const;

  const SphereSearch& How;
  Communicator& Ranks;
  const std::function<bool(double, const std::string&)>& Progress;
  std::array<int, 3> Dimensions{};
  FoundSpheres Found;
};

GreyModel Search::FindLevels(const VoxelSlab<float>& image)
{
  static_cast<TwoPhases&>(this->Found) = FindPhases(image, this->How, this->Ranks);
  GreyModel model;
  model.Edges = this->How.Edges;
  model.Matrix = this->Found.MatrixValue;
  model.Contrast = this->Found.Contrast;
  model.Blur = this->Found.Binary ? BlurOfBinary : 1.0;
  return model;
}

std::vector<Ball> Search::FindCandidates(const VoxelSlab<float>& image)
{
  const int times = this->Found.Smoothing;
  const auto threshold = static_cast<float>(this->Found.Threshold);
  VoxelSlab<std::uint8_t> above = times == 0
    ? FindAbove(image, threshold)
    : FindAbove(Smoothed(image, times, this->Ranks), threshold);
  return KeepFirstOfEach(FindMaxima(SquaredDistances(std::move(above), this->Ranks),
    0.5 * this->How.LeastDiameter, this->How.Edges, this->Ranks));
}

std::vector<Ball> Search::FindMissing(SphereFit& fit)
{
  VoxelSlab<float> left = fit.FindResidual(1);
  Smooth(left);
  SetHalo(left, 0, this->Ranks);
  VoxelSlab<std::uint8_t> above =
    FindAbove(std::exchange(left, {}), static_cast<float>(0.5 * fit.GetModel().Contrast));
  return KeepFirstOfEach(FindMaxima(
    SquaredDistances(std::move(above), this->Ranks), LeastCandidate, this->How.Edges, this->Ranks));
}

bool Search::Run(SphereFit& fit, int most, double mostMoving, double from, double to)
{
  int sweep = 0;
  return fit.Run(most, mostMoving,
    [&]() { return this->GoOn(from + (to - from) * sweep++ / most, "fitting spheres"); });
}

void Search::Fit(SphereFit& fit, const std::vector<Ball>& starts, bool more)
{
  fit.Add(starts);
  double largest = 0.0;
  for (const Ball& ball : starts)
  {
    largest = std::max(largest, ball.Radius);
  }
  fit.LimitRadius(1.25 * largest + 2.0);
  bool going = this->Run(fit, FirstSweeps, MovingOfRound, 0.1, 0.5);
  for (int round = 0; round < Rounds && more && going; ++round)
  {
    fit.Keep(IsCandidate);
    const std::vector<Ball> missing = this->FindMissing(fit);
    if (missing.empty())
    {
      break;
    }
    fit.Add(missing);
    going = this->Run(fit, SweepsOfRound, MovingOfRound, 0.5 + 0.1 * round, 0.6 + 0.1 * round);
  }
  this->DropFalse(fit);
  if (going)
  {
    this->Run(fit, LastSweeps, 0.0, 0.8, 1.0);
    this->DropFalse(fit);
  }
  this->DropOutside(fit);
}

bool Search::IsOutside(const FittedBall& ball, double margin) const
{
  bool outside = false;
  for (int q = 0; q < 3; ++q)
  {
    const double end = this->Dimensions[q] * this->How.Edges[q] - margin;
    outside = outside || ball.At.Centre[q] < margin || ball.At.Centre[q] > end;
  }
  return outside;
}

void Search::Drop(SphereFit& fit, const Reason& find)
{
  std::size_t next = 0;
  fit.Keep(
    [&](const FittedBall& ball)
    {
      const std::optional<DropReason> reason = find(ball, next++);
      if (reason)
      {
        this->Found.Dropped.push_back({ ball, *reason });
      }
      return !reason;
    });
}

void Search::DropFalse(SphereFit& fit)
{
  const std::vector<bool> deep =
    FindDeepOverlaps(BallsOf(fit.GetBalls()), this->How.OverlapTolerance);
  this->Drop(fit,
    [&](const FittedBall& ball, std::size_t n) -> std::optional<DropReason>
    {
      if (!(ball.Contrast > LeastContrast) || ball.Signal < LeastSignal)
      {
        return DropReason::LowContrast;
      }
      if (2.0 * ball.At.Radius < this->How.LeastDiameter)
      {
        return DropReason::Small;
      }
      return deep[n] ? std::optional(DropReason::Overlaps) : std::nullopt;
    });
}

void Search::DropOutside(SphereFit& fit)
{
  for (const FittedBall& ball : fit.GetBalls())
  {
    const bool counts = this->How.WholeOnly && !this->IsOutside(ball, 0.0);
    this->Found.Margin = counts ? std::max(this->Found.Margin, ball.At.Radius) : this->Found.Margin;
  }
  this->Drop(fit,
    [&](const FittedBall& ball, std::size_t) -> std::optional<DropReason>
    {
      if (this->IsOutside(ball, 0.0))
      {
        return DropReason::Outside;
      }
      return this->IsOutside(ball, this->Found.Margin) ? std::optional(DropReason::NearBorder)
                                                       : std::nullopt;
    });
}

FoundSpheres Search::Find(VoxelSlab<float>& image, const std::vector<Ball>& starts)
{
  this->Dimensions = image.Dimensions;
  this->GoOn(0.0, "finding the two phases");
  const GreyModel model = this->FindLevels(image);
  const bool fixed = this->Found.Binary || (this->How.MatrixValue && this->How.ParticleValue);
  const bool going = this->GoOn(0.02, "looking for particles");
  const std::vector<Ball> candidates =
    starts.empty() && going ? this->FindCandidates(image) : starts;
  if (candidates.empty() && going)
  {
    throw std::invalid_argument(Text("found no particle of a diameter of ", this->How.LeastDiameter,
      " voxels or more above the grey value ", this->Found.Threshold, "; are particles dark?"));
  }
  SphereFit fit(std::move(image), model, fixed, this->Found.Levels.Noise, this->Ranks);
  this->Fit(fit, candidates, starts.empty());
  this->Found.Balls = fit.GetBalls();
  this->Found.Model = fit.GetModel();
  this->Found.Sweeps = fit.GetSweeps();
  image = fit.TakeImage();
  if (starts.empty())
  {
    std::sort(this->Found.Balls.begin(), this->Found.Balls.end(),
      [](const FittedBall& a, const FittedBall& b)
      {
        const Vector3 &p = a.At.Centre, &q = b.At.Centre;
        return std::tie(p[2], p[1], p[0]) < std::tie(q[2], q[1], q[0]);
      });
  }
  return std::move(this->Found);
}
}

const char* NameOf(DropReason reason)
{
  constexpr const char* names[] = { "low contrast", "small", "overlaps a larger one",
    "centre outside", "near the border" };
  return names[static_cast<int>(reason)];
}

FoundSpheres FindSpheres(VoxelSlab<float>& image, const SphereSearch& search,
  const std::vector<Ball>& starts, Communicator& ranks,
  const std::function<bool(double, const std::string&)>& progress)
{
  return Search(search, ranks, progress).Find(image, starts);
}

Estimate EstimateSpheres(const std::array<int, 3>& dimensions, int ranks)
{
  constexpr double secondsOfVoxel = 8e-7, bytesOfVoxel = 16.0;
  constexpr int halo = 24;
  return { secondsOfVoxel * MostVoxels(dimensions, 0, 1),
    bytesOfVoxel * MostVoxels(dimensions, halo, ranks) / BytesOfMegabyte, 0.0 };
}

VoxelSlab<float> ResidualOf(VoxelSlab<float> image, const FoundSpheres& found, Communicator& ranks)
{
  SphereFit fit(std::move(image), found.Model, true, 0.0, ranks);
  fit.Add(BallsOf(found.Balls));
  for (const DroppedBall& dropped : found.Dropped)
  {
    if (dropped.IsParticle())
    {
      fit.Add({ dropped.Ball.At });
    }
  }
  return fit.FindResidual(0);
}
}
