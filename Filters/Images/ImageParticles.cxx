// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageParticles.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "VoxelOutput.h"
#include "ruc/Base/Require.h"
#include "ruc/Images/Fit/SphereCandidates.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
using ruc::Require;
using ruc::Text;

constexpr double MostLabel = 16777216.0; // up to which floats hold whole numbers

// Adds a point array of numbers find(n)
template <class Find>
void AddNumbers(vtkPolyData* data, const char* name, std::size_t count, Find&& find)
{
  double* values =
    VoxelOutput::Add<vtkDoubleArray>(data->GetPointData(), static_cast<vtkIdType>(count), name);
  for (std::size_t n = 0; n < count; ++n)
  {
    values[n] = find(n);
  }
}
}

void ImageParticles::NumberLabels(RankCommunicator& ranks)
{
  ruc::VoxelSlab<float>& image = this->Slab;
  std::vector<std::int64_t>& labels = this->Labels;
  ranks.Agree(
    [&]()
    {
      for (float value : image.Values)
      {
        Require(value >= 0.0f && value <= MostLabel && value == std::rint(value), "ImageArray",
          Text("labels that are whole numbers from 0 to ", MostLabel), value);
      }
    });
  std::vector<std::int64_t> own;
  float last = 0.0f;
  for (float value : image.Values)
  {
    if (value != last && value > 0.0f)
    {
      own.push_back(static_cast<std::int64_t>(value));
    }
    last = value;
  }
  const auto sort = [](std::vector<std::int64_t>& of)
  {
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
  };
  sort(own);
  labels = ranks.Concatenate(own);
  sort(labels);
  ruc::VoxelSlab<std::int32_t> numbers = { image.Dimensions, image.First, image.Last, {} };
  numbers.Values.reserve(image.Values.size());
  for (float& value : image.Values)
  {
    const auto place =
      std::lower_bound(labels.begin(), labels.end(), static_cast<std::int64_t>(value));
    numbers.Values.push_back(
      value > 0.0f ? static_cast<std::int32_t>(place - labels.begin()) + 1 : 0);
    value = value > 0.0f ? 1.0f : 0.0f;
  }
  this->Number = std::move(numbers);
}

void ImageParticles::NumberIds()
{
  this->Ids.resize(this->Found.Balls.size());
  std::iota(this->Ids.begin(), this->Ids.end(), std::int64_t(1));
}

void ImageParticles::TakeCut(ruc::CutParticles cut)
{
  const auto ballOf = [](const ruc::ParticleShape& shape)
  {
    ruc::FittedBall ball;
    ball.At = { shape.Centre, shape.EqualVolumeRadius() };
    return ball;
  };
  static_cast<ruc::TwoPhases&>(this->Found) = cut;
  this->Found.Model.Matrix = cut.MatrixValue;
  this->Found.Model.Contrast = cut.Contrast;
  this->Found.Margin = cut.Margin;
  this->Found.Stopped = cut.Stopped;
  for (const ruc::ParticleShape& shape : cut.Shapes)
  {
    this->Found.Balls.push_back(ballOf(shape));
  }
  for (const ruc::CutParticles::Dropped& other : cut.Others)
  {
    this->Found.Dropped.push_back({ ballOf(other.Shape), other.Reason });
  }
  this->Number = std::move(cut.Number);
  this->Shapes = std::move(cut.Shapes);
  this->AreCut = true;
  if (!this->HasLabels)
  {
    this->NumberIds();
    return;
  }
  for (std::int32_t label : cut.Labels)
  {
    this->Ids.push_back(this->Labels[label - 1]);
  }
}

// Gives voxels to the particles that were fitted
void ImageParticles::NumberVoxels()
{
  std::vector<ruc::Ball> all = ruc::BallsOf(this->Found.Balls);
  for (const ruc::DroppedBall& dropped : this->Found.Dropped)
  {
    if (dropped.IsParticle())
    {
      all.push_back(dropped.Ball.At);
    }
  }
  this->Number = ruc::LabelVoxels(this->Slab, this->Found.Model, all);
  const auto count = static_cast<std::int32_t>(this->Found.Balls.size());
  for (std::int32_t& number : this->Number.Values)
  {
    number = number > count ? NotInPack : number;
  }
}

// The voxels of a particle are those of its label
void ImageParticles::KeepShapesOfLabels()
{
  std::vector<std::int32_t> numbers(this->Labels.size() + 1, NotInPack);
  numbers[0] = 0;
  std::vector<ruc::ParticleShape> shapes;
  for (const ruc::FittedBall& ball : this->Found.Balls)
  {
    shapes.push_back(this->Shapes[ball.Start]);
    numbers[ball.Start + 1] = static_cast<std::int32_t>(shapes.size());
    this->Ids.push_back(this->Labels[ball.Start]);
  }
  this->Shapes = std::move(shapes);
  for (std::int32_t& number : this->Number.Values)
  {
    number = numbers[number];
  }
}

void ImageParticles::FindShapes(const std::function<bool(double)>& goOn, RankCommunicator& ranks)
{
  const auto leave = [&]()
  { this->Slab = ruc::ResidualOf(std::exchange(this->Slab, {}), this->Found, ranks); };
  if (this->HasLabels)
  {
    this->KeepShapesOfLabels();
    leave();
    return;
  }
  this->NumberIds();
  const auto count = static_cast<std::int32_t>(this->Found.Balls.size());
  ruc::ParticleShape unknown;
  unknown.Volume = std::numeric_limits<double>::quiet_NaN();
  this->Shapes.assign(count, unknown);
  this->AreMeasured = false;
  if (!goOn(0.0))
  {
    return;
  }
  leave();
  if (!goOn(0.5))
  {
    return;
  }
  this->NumberVoxels();
  if (!goOn(0.75))
  {
    return;
  }
  this->Shapes = ruc::MeasureShapes(this->Number, count, this->Edges, ranks);
  this->AreMeasured = true;
}

ruc::Vector3 ImageParticles::PlaceOf(const ruc::Ball& ball) const
{
  const ruc::Vector3& low = this->Input.Grid.Lower;
  return { low[0] + this->Edge * ball.Centre[0], low[1] + this->Edge * ball.Centre[1],
    low[2] + this->Edge * ball.Centre[2] };
}

int ImageParticles::FacesThatCut(const ruc::Ball& ball) const
{
  int faces = 0;
  for (int q = 0; q < 3; ++q)
  {
    const double end = this->Input.Grid.Dimensions[q] * this->Edges[q];
    faces += ball.Centre[q] < ball.Radius ? 1 : 0;
    faces += ball.Centre[q] > end - ball.Radius ? 1 : 0;
  }
  return faces;
}

ruc::Window ImageParticles::FindWindow() const
{
  const ruc::VoxelGrid& grid = this->Input.Grid;
  const double margin = this->Found.Margin * this->Edge;
  ruc::Vector3 low, size;
  for (int q = 0; q < 3; ++q)
  {
    low[q] = grid.Lower[q] + margin;
    size[q] = grid.Dimensions[q] * grid.Spacing[q] - 2.0 * margin;
  }
  return ruc::Window::MakeBox(low, size, { false, false, false });
}

void ImageParticles::FillPack(vtkPolyData* data) const
{
  const std::vector<ruc::FittedBall>& balls = this->Found.Balls;
  ruc::SpherePack pack;
  for (const ruc::FittedBall& ball : balls)
  {
    const ruc::Vector3 place = this->PlaceOf(ball.At);
    pack.X.push_back(place[0]);
    pack.Y.push_back(place[1]);
    pack.Z.push_back(place[2]);
    pack.Radius.push_back(this->Edge * ball.At.Radius);
  }
  pack.Id = this->Ids;
  PackData::FillPolyData(pack, data);
  const auto add = [&](const char* name, auto&& find)
  { AddNumbers(data, name, balls.size(), find); };
  add("EqualVolumeRadius",
    [&](std::size_t n) { return this->Edge * this->Shapes[n].EqualVolumeRadius(); });
  add("Sphericity", [&](std::size_t n) { return this->Shapes[n].Sphericity(); });
  if (!this->AreCut)
  {
    this->FillFit(data);
  }
  add("BorderFaces",
    [&](std::size_t n)
    {
      return static_cast<double>(
        this->AreCut ? this->Shapes[n].BorderFaces : this->FacesThatCut(balls[n].At));
    });
  data->GetPointData()->SetActiveScalars("Radius");
}

void ImageParticles::FillFit(vtkPolyData* data) const
{
  const std::vector<ruc::FittedBall>& balls = this->Found.Balls;
  const auto add = [&](const char* name, auto&& find)
  { AddNumbers(data, name, balls.size(), find); };
  const double edge = this->Edge, contrast = this->Found.Model.Contrast;
  const std::vector<double> depths = ruc::FindOverlapDepths(ruc::BallsOf(balls));
  add("Contrast", [&](std::size_t n) { return balls[n].Contrast; });
  add("FitResidual", [&](std::size_t n) { return balls[n].Residual / contrast; });
  add("CenterError", [&](std::size_t n) { return edge * balls[n].CenterError; });
  add("RadiusError", [&](std::size_t n) { return edge * balls[n].RadiusError; });
  add("OverlapDepth", [&](std::size_t n) { return edge * depths[n]; });
}

void ImageParticles::FillDropped(vtkPolyData* data) const
{
  const std::vector<ruc::DroppedBall>& dropped = this->Found.Dropped;
  ruc::SpherePack pack;
  for (const ruc::DroppedBall& ball : dropped)
  {
    const ruc::Vector3 place = this->PlaceOf(ball.Ball.At);
    pack.X.push_back(place[0]);
    pack.Y.push_back(place[1]);
    pack.Z.push_back(place[2]);
    pack.Radius.push_back(this->Edge * ball.Ball.At.Radius);
  }
  PackData::FillPolyData(pack, data);
  if (!this->AreCut)
  {
    AddNumbers(
      data, "Contrast", dropped.size(), [&](std::size_t n) { return dropped[n].Ball.Contrast; });
  }
  AddNumbers(data, "Reason", dropped.size(),
    [&](std::size_t n) { return static_cast<double>(dropped[n].Reason); });
  vtkNew<vtkStringArray> reasons;
  reasons->SetName("ReasonText");
  for (const ruc::DroppedBall& ball : dropped)
  {
    reasons->InsertNextValue(ruc::NameOf(ball.Reason));
  }
  data->GetPointData()->AddArray(reasons);
  data->GetPointData()->SetActiveScalars("Reason");
}
