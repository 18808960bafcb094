// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/ParticleLabels.h"

#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// Beyond so many radii and a voxel a voxel belongs to no ball
double ReachOf(const Ball& ball)
{
  return 1.5 * ball.Radius + 1.0;
}

std::pair<int, int> VoxelsWithin(double centre, double reach, double edge, int first, int last)
{
  return { std::max(first, static_cast<int>(std::ceil((centre - reach) / edge - 0.5))),
    std::min(last, static_cast<int>(std::floor((centre + reach) / edge - 0.5)) + 1) };
}

// Gives the voxels of a plane to a ball where it is nearer than what they have
void TakePlane(const Ball& ball, std::int32_t number, const Vector3& edges, int z,
  VoxelSlab<std::int32_t>& labels, std::vector<float>& nearest)
{
  const double reach = ReachOf(ball), dz = (z + 0.5) * edges[2] - ball.Centre[2];
  const double across = reach * reach - dz * dz;
  if (across <= 0.0)
  {
    return;
  }
  const auto [first, last] =
    VoxelsWithin(ball.Centre[1], std::sqrt(across), edges[1], 0, labels.Dimensions[1]);
  for (int y = first; y < last; ++y)
  {
    const double dy = (y + 0.5) * edges[1] - ball.Centre[1];
    const auto [begin, end] = VoxelsWithin(ball.Centre[0],
      std::sqrt(std::max(0.0, across - dy * dy)), edges[0], 0, labels.Dimensions[0]);
    std::int32_t* row = labels.Row(y, z);
    float* distance = nearest.data() + static_cast<std::size_t>(y) * labels.Dimensions[0];
    for (int x = begin; x < end; ++x)
    {
      const double dx = (x + 0.5) * edges[0] - ball.Centre[0];
      const float here = static_cast<float>(std::sqrt(dx * dx + dy * dy + dz * dz) - ball.Radius);
      if (here < distance[x])
      {
        distance[x] = here;
        row[x] = number;
      }
    }
  }
}

// Whether a voxel so far outside a ball's surface, with that residual, belongs to the ball
bool IsIn(double radius, double outside, double residual, const GreyModel& model)
{
  const auto ball = [&](double t, double r)
  {
    return 0.5 * std::erfc(-t / std::sqrt(2.0)) -
      model.Blur / r * std::exp(-0.5 * t * t) / std::sqrt(2.0 * Pi);
  };
  const double r = std::max(radius + outside, 0.5);
  return model.Contrast * (ball(-outside / model.Blur, r) - ball(0.0, radius)) + residual > 0.0;
}

// Half of the directions to the 26 neighbours
struct Direction
{
  int X, Y, Z, Kind; // 0 to 2: along how many axes, less one
};
constexpr Direction Directions[] = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 1, 1, 0, 1 },
  { -1, 1, 0, 1 }, { 1, 0, 1, 1 }, { -1, 0, 1, 1 }, { 0, 1, 1, 1 }, { 0, -1, 1, 1 }, { 1, 1, 1, 2 },
  { -1, 1, 1, 2 }, { 1, -1, 1, 2 }, { -1, -1, 1, 2 } };
// What share of all directions is nearest to one of them
constexpr double DirectionShares[] = { 0.0915557824, 0.0739612558, 0.0703912796 };

enum Counted
{
  VOXELS,
  PLACE_X,
  PLACE_Y,
  PLACE_Z,
  BORDERS, // and two more, of the kinds of directions
  NumberCounted = BORDERS + 3
};

// What is counted of each label, and where its voxels begin and end: the first along each axis, and
// the last with the other sign
struct LabelCounts
{
  explicit LabelCounts(std::int32_t labels)
    : Sums(static_cast<std::size_t>(labels) * NumberCounted, 0)
    , Ends(static_cast<std::size_t>(labels) * 6, std::numeric_limits<std::int32_t>::max())
  {
  }
  void Extend(std::int32_t label, const std::array<std::int32_t, 3>& voxel)
  {
    std::int32_t* ends = this->Ends.data() + static_cast<std::size_t>(label - 1) * 6;
    for (int q = 0; q < 3; ++q)
    {
      ends[q] = std::min(ends[q], voxel[q]);
      ends[3 + q] = std::min(ends[3 + q], -voxel[q]);
    }
  }
  void Add(const LabelCounts& other)
  {
    for (std::size_t n = 0; n < this->Sums.size(); ++n)
    {
      this->Sums[n] += other.Sums[n];
    }
    for (std::size_t n = 0; n < this->Ends.size(); ++n)
    {
      this->Ends[n] = std::min(this->Ends[n], other.Ends[n]);
    }
  }

  std::vector<std::int64_t> Sums;
  std::vector<std::int32_t> Ends;
};

void CountPlane(const VoxelSlab<std::int32_t>& labels, int z, LabelCounts& counts)
{
  const auto& n = labels.Dimensions;
  const auto count = [&](std::int32_t label, int what, std::int64_t value)
  {
    if (label > 0)
    {
      counts.Sums[static_cast<std::size_t>(label - 1) * NumberCounted + what] += value;
    }
  };
  for (int y = 0; y < n[1]; ++y)
  {
    const std::int32_t* row = labels.Row(y, z);
    for (int x = 0; x < n[0]; ++x)
    {
      const std::int32_t label = row[x];
      count(label, VOXELS, 1);
      count(label, PLACE_X, x);
      count(label, PLACE_Y, y);
      count(label, PLACE_Z, z);
      if (label > 0)
      {
        counts.Extend(label, { x, y, z });
      }
      for (const Direction& to : Directions)
      {
        const int u = x + to.X, v = y + to.Y, w = z + to.Z;
        if (u < 0 || u >= n[0] || v < 0 || v >= n[1] || w >= n[2])
        {
          continue;
        }
        const std::int32_t other = labels.Row(v, w)[u];
        if (other != label)
        {
          count(label, BORDERS + to.Kind, 1);
          count(other, BORDERS + to.Kind, 1);
        }
      }
    }
  }
}
}

VoxelSlab<std::int32_t> LabelVoxels(
  const VoxelSlab<float>& residual, const GreyModel& model, const std::vector<Ball>& balls)
{
  const Vector3& edges = model.Edges;
  VoxelSlab<std::int32_t> labels = { residual.Dimensions, residual.First, residual.Last, {} };
  labels.Values.assign(residual.Values.size(), 0);
  std::vector<std::vector<std::int32_t>> ofPlane(residual.Last - residual.First);
  for (std::size_t n = 0; n < balls.size(); ++n)
  {
    const auto [first, last] =
      VoxelsWithin(balls[n].Centre[2], ReachOf(balls[n]), edges[2], residual.First, residual.Last);
    for (int z = first; z < last; ++z)
    {
      ofPlane[z - residual.First].push_back(static_cast<std::int32_t>(n));
    }
  }
#pragma omp parallel
  {
    std::vector<float> nearest;
#pragma omp for schedule(dynamic)
    for (int z = residual.First; z < residual.Last; ++z)
    {
      nearest.assign(residual.PlaneSize(), std::numeric_limits<float>::infinity());
      for (std::int32_t n : ofPlane[z - residual.First])
      {
        TakePlane(balls[n], n + 1, edges, z, labels, nearest);
      }
      const float* left = residual.Row(0, z);
      std::int32_t* plane = labels.Row(0, z);
      for (std::size_t k = 0; k < residual.PlaneSize(); ++k)
      {
        plane[k] = plane[k] > 0 && IsIn(balls[plane[k] - 1].Radius, nearest[k], left[k], model)
          ? plane[k]
          : 0;
      }
    }
  }
  return labels;
}

double ParticleShape::EqualVolumeRadius() const
{
  return std::cbrt(3.0 * this->Volume / (4.0 * Pi));
}

double ParticleShape::Sphericity() const
{
  return this->Surface > 0.0
    ? std::cbrt(Pi) * std::pow(6.0 * this->Volume, 2.0 / 3.0) / this->Surface
    : std::numeric_limits<double>::quiet_NaN();
}

std::vector<ParticleShape> MeasureShapes(
  VoxelSlab<std::int32_t> labels, std::int32_t count, const Vector3& edges, Communicator& ranks)
{
  const int first = labels.First, last = labels.Last;
  SetHalo(labels, 1, ranks);
  LabelCounts counts(count);
#pragma omp parallel
  {
    LabelCounts own(count);
#pragma omp for schedule(dynamic) nowait
    for (int z = first; z < last; ++z)
    {
      CountPlane(labels, z, own);
    }
#pragma omp critical
    counts.Add(own);
  }
  ranks.Sum(counts.Sums.data(), counts.Sums.size());
  ranks.Minimum(counts.Ends.data(), counts.Ends.size());

  const double voxel = edges[0] * edges[1] * edges[2];
  std::vector<ParticleShape> shapes(count);
  for (std::int32_t n = 0; n < count; ++n)
  {
    const std::int64_t* of = counts.Sums.data() + static_cast<std::size_t>(n) * NumberCounted;
    const std::int32_t* ends = counts.Ends.data() + static_cast<std::size_t>(n) * 6;
    ParticleShape& shape = shapes[n];
    const double voxels = static_cast<double>(of[VOXELS]);
    shape.Volume = voxel * voxels;
    for (int q = 0; q < 3 && voxels > 0.0; ++q)
    {
      const int begin = ends[q], end = 1 - ends[3 + q];
      shape.Centre[q] = edges[q] * (static_cast<double>(of[PLACE_X + q]) / voxels + 0.5);
      shape.BorderFaces += (begin == 0 ? 1 : 0) + (end == labels.Dimensions[q] ? 1 : 0);
      shape.Reach = std::max(
        { shape.Reach, shape.Centre[q] - edges[q] * begin, edges[q] * end - shape.Centre[q] });
    }
    for (int kind = 0; kind < 3; ++kind)
    {
      // Half of the borders, times the area across a line, is the projected area; four times its
      // mean the surface
      shape.Surface += 2.0 * DirectionShares[kind] * static_cast<double>(of[BORDERS + kind]) *
        voxel / std::sqrt(kind + 1.0);
    }
  }
  return shapes;
}
}
