// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/SamplingRegion.h"

#include "Random.h"
#include "Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

// Streams of UniformTriple; lines of set n take the n-th after these
constexpr std::uint32_t PointStream = 0x9017f500u;
constexpr std::uint32_t DirectionStream = 0xd14ec700u;
constexpr std::uint32_t LineDirectionStream = 0x71000000u;
constexpr std::uint32_t LinePlaceStream = 0x72000000u;

std::uint64_t Attempt(std::uint32_t sample, std::uint64_t attempt)
{
  return sample + (attempt << 32);
}

Vector3 IsotropicDirection(double u, double v)
{
  const double z = 2.0 * u - 1.0;
  const double lateral = std::sqrt(std::max(1.0 - z * z, 0.0));
  return { lateral * std::cos(2.0 * Pi * v), lateral * std::sin(2.0 * Pi * v), z };
}

void RequireMargin(double margin)
{
  if (!(margin >= 0.0 && std::isfinite(margin)))
  {
    throw std::invalid_argument(Text("Margin requires a finite number >= 0, got ", margin, "."));
  }
}

Window Shrunk(const Window& window, double margin)
{
  RequireMargin(margin);
  const auto require = [&](bool room)
  {
    if (!room)
    {
      throw std::invalid_argument(Text("The window requires room for a margin of ", margin,
        " along its border, got a ", window.Describe(), "."));
    }
  };
  if (window.GetShape() == Window::Shape::Cylinder)
  {
    require(window.Radius > margin && window.Height > 2.0 * margin);
    Vector3 base = window.Base;
    for (int q = 0; q < 3; ++q)
    {
      base[q] += margin * window.Axis[q];
    }
    return Window::MakeCylinder(
      base, window.Axis, window.Radius - margin, window.Height - 2.0 * margin);
  }
  Vector3 origin = window.Origin, size = window.Size;
  for (int q = 0; q < 3; ++q)
  {
    if (!window.Periodic[q])
    {
      require(size[q] > 2.0 * margin);
      origin[q] += margin;
      size[q] -= 2.0 * margin;
    }
  }
  return Window::MakeBox(origin, size, window.Periodic);
}

Window BoundsOf(const Window& window)
{
  if (window.GetShape() == Window::Shape::Box)
  {
    return window;
  }
  Vector3 origin, size;
  for (int q = 0; q < 3; ++q)
  {
    const double lateral =
      window.Radius * std::sqrt(std::max(1.0 - window.Axis[q] * window.Axis[q], 0.0));
    const double along = window.Height * window.Axis[q];
    origin[q] = window.Base[q] + std::min(along, 0.0) - lateral;
    size[q] = std::abs(along) + 2.0 * lateral;
  }
  return Window::MakeBox(origin, size, { false, false, false });
}

// Narrows [begin, end] to the t with low <= position + t slope <= high
void ClipToSlab(double position, double slope, double low, double high, double& begin, double& end)
{
  if (slope == 0.0)
  {
    end = position >= low && position <= high ? end : begin;
    return;
  }
  const double t0 = (low - position) / slope, t1 = (high - position) / slope;
  begin = std::max(begin, std::min(t0, t1));
  end = std::min(end, std::max(t0, t1));
}

double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
}

SamplingRegion::SamplingRegion(const Window& window, double margin)
  : Shape(Shrunk(window, margin))
  , Bounds(BoundsOf(this->Shape))
{
  if (this->Shape.GetShape() == Window::Shape::Cylinder)
  {
    for (int q = 0; q < 3; ++q)
    {
      this->Centre[q] = this->Shape.Base[q] + 0.5 * this->Shape.Height * this->Shape.Axis[q];
    }
    this->Radius = std::hypot(this->Shape.Radius, 0.5 * this->Shape.Height);
    return;
  }
  this->EncloseBounds();
}

SamplingRegion::SamplingRegion(const VoxelMask& mask, double margin)
{
  RequireMargin(margin);
  this->Mask = mask.Eroded(margin);
  this->Shape = this->Mask->GetBounds();
  this->Bounds = this->Shape;
  this->EncloseBounds();
}

void SamplingRegion::EncloseBounds()
{
  const Vector3& size = this->Bounds.Size;
  for (int q = 0; q < 3; ++q)
  {
    this->Centre[q] = this->Bounds.Origin[q] + 0.5 * size[q];
  }
  this->Radius = 0.5 * std::hypot(size[0], size[1], size[2]);
}

bool SamplingRegion::Contains(const Vector3& point) const
{
  return this->Mask ? this->Mask->Contains(point) : this->Shape.Contains(point);
}

double SamplingRegion::Volume() const
{
  return this->Mask ? this->Mask->Volume() : this->Shape.Volume();
}

double SamplingRegion::LargestLag() const
{
  return (this->IsFullyPeriodic() ? 4.0 : 0.999) * this->Shape.ShortestEdge();
}

Vector3 SamplingRegion::RandomPoint(std::uint32_t seed, std::uint32_t sample) const
{
  for (std::uint64_t attempt = 0;; ++attempt)
  {
    Vector3 point = UniformTriple(seed, PointStream, Attempt(sample, attempt));
    for (int q = 0; q < 3; ++q)
    {
      point[q] = this->Bounds.Origin[q] + point[q] * this->Bounds.Size[q];
    }
    if (this->Contains(point))
    {
      return point;
    }
  }
}

Vector3 SamplingRegion::RandomDirection(std::uint32_t seed, std::uint32_t sample)
{
  const std::array<double, 3> u = UniformTriple(seed, DirectionStream, sample);
  return IsotropicDirection(u[0], u[1]);
}

double SamplingRegion::RandomTurn(std::uint32_t seed, std::uint32_t sample)
{
  return UniformTriple(seed, DirectionStream, sample)[2];
}

void SamplingRegion::RandomLine(
  std::uint32_t seed, std::uint32_t sample, double maximumLag, SampleLine& line) const
{
  this->DrawLine(nullptr, 0, seed, sample, maximumLag, line);
}

void SamplingRegion::RandomLineAlong(const Vector3& direction, std::uint32_t set,
  std::uint32_t seed, std::uint32_t sample, double maximumLag, SampleLine& line) const
{
  this->DrawLine(&direction, set, seed, sample, maximumLag, line);
}

double SamplingRegion::LongestLine(double maximumLag) const
{
  return this->IsFullyPeriodic()
    ? maximumLag + *std::max_element(this->Bounds.Size.begin(), this->Bounds.Size.end())
    : 2.0 * this->Radius;
}

void SamplingRegion::DrawLine(const Vector3* direction, std::uint32_t set, std::uint32_t seed,
  std::uint32_t sample, double maximumLag, SampleLine& line) const
{
  const double length = this->LongestLine(maximumLag);
  for (std::uint64_t attempt = 0;; ++attempt)
  {
    const std::uint64_t counter = Attempt(sample, attempt);
    const std::array<double, 3> u = UniformTriple(seed, LineDirectionStream + set, counter);
    const std::array<double, 3> v = UniformTriple(seed, LinePlaceStream + set, counter);
    line.Direction = direction ? *direction : IsotropicDirection(u[0], u[1]);
    if (this->IsFullyPeriodic())
    {
      for (int q = 0; q < 3; ++q)
      {
        line.Start[q] = this->Bounds.Origin[q] + v[q] * this->Bounds.Size[q];
      }
      line.Inside.assign(1, { 0.0, length });
      return;
    }
    // Two directions across the line; the first from the axis that is furthest from along it
    const Vector3& d = line.Direction;
    const double x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
    Vector3 across = x <= y && x <= z ? Vector3{ 0.0, -d[2], d[1] }
      : y <= z                        ? Vector3{ d[2], 0.0, -d[0] }
                                      : Vector3{ -d[1], d[0], 0.0 };
    const double norm = std::hypot(across[0], across[1], across[2]);
    const double distance = this->Radius * std::sqrt(v[0]);
    const double c = distance * std::cos(2.0 * Pi * v[1]) / norm;
    const double s = distance * std::sin(2.0 * Pi * v[1]) / norm;
    const Vector3 other = { d[1] * across[2] - d[2] * across[1],
      d[2] * across[0] - d[0] * across[2], d[0] * across[1] - d[1] * across[0] };
    for (int q = 0; q < 3; ++q)
    {
      line.Start[q] = this->Centre[q] + c * across[q] + s * other[q] - this->Radius * d[q];
    }
    this->Clip(line, length);
    if (!line.Inside.empty())
    {
      return;
    }
  }
}

void SamplingRegion::Clip(SampleLine& line, double length) const
{
  if (this->Mask)
  {
    this->Mask->Intersect(line.Start, line.Direction, length, line.Inside);
    return;
  }
  double begin = 0.0, end = length;
  if (this->Shape.GetShape() == Window::Shape::Box)
  {
    for (int q = 0; q < 3; ++q)
    {
      ClipToSlab(line.Start[q], line.Direction[q], this->Shape.Origin[q],
        this->Shape.Origin[q] + this->Shape.Size[q], begin, end);
    }
  }
  else
  {
    const Vector3 from = { line.Start[0] - this->Shape.Base[0], line.Start[1] - this->Shape.Base[1],
      line.Start[2] - this->Shape.Base[2] };
    const double position = Dot(from, this->Shape.Axis);
    const double slope = Dot(line.Direction, this->Shape.Axis);
    ClipToSlab(position, slope, 0.0, this->Shape.Height, begin, end);
    // Across the axis: |p + t w| <= radius
    Vector3 p, w;
    for (int q = 0; q < 3; ++q)
    {
      p[q] = from[q] - position * this->Shape.Axis[q];
      w[q] = line.Direction[q] - slope * this->Shape.Axis[q];
    }
    const double radius2 = this->Shape.Radius * this->Shape.Radius;
    const double w2 = Dot(w, w);
    if (w2 > 0.0)
    {
      const double nearest = -Dot(p, w) / w2;
      const Vector3 foot = { p[0] + nearest * w[0], p[1] + nearest * w[1], p[2] + nearest * w[2] };
      const double half2 = (radius2 - Dot(foot, foot)) / w2;
      const double half = half2 > 0.0 ? std::sqrt(half2) : 0.0;
      begin = std::max(begin, nearest - half);
      end = std::min(end, nearest + half);
    }
    else if (Dot(p, p) > radius2)
    {
      end = begin;
    }
  }
  line.Inside.clear();
  if (begin < end)
  {
    line.Inside.push_back({ begin, end });
  }
}
}
