// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/SamplingRegion.h"

#include "ruc/Base/Random.h"
#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ruc
{
namespace
{
// A region that fills less of its bounds is sparse: finding it by chance would take too many
// attempts
constexpr double SparseShare = 1e-3;

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

// Two directions across d, of the same length. The first is also across the axis that is farthest
// from d.
void FindAcross(const Vector3& d, Vector3& a, Vector3& b)
{
  const double x = std::abs(d[0]), y = std::abs(d[1]), z = std::abs(d[2]);
  a = x <= y && x <= z ? Vector3{ 0.0, -d[2], d[1] }
    : y <= z           ? Vector3{ d[2], 0.0, -d[0] }
                       : Vector3{ -d[1], d[0], 0.0 };
  b = { d[1] * a[2] - d[2] * a[1], d[2] * a[0] - d[0] * a[2], d[0] * a[1] - d[1] * a[0] };
}

// Narrows [begin, end] to the t for which low <= position + t slope <= high
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
}

namespace
{
// A box seen along lines that start at origin + i axisI + j axisJ, with the axes across each other:
// of a thin box only few of the places in the disc around it are to be looked at
class BoxOnLattice
{
public:
  BoxOnLattice(const Window& box, const Vector3& origin, const Vector3& axisI, const Vector3& axisJ)
  {
    const double i2 = Dot(axisI, axisI), j2 = Dot(axisJ, axisJ);
    for (int corner = 0; corner < 8; ++corner)
    {
      Vector3 from;
      for (int q = 0; q < 3; ++q)
      {
        from[q] = box.Origin[q] + (corner >> q & 1) * box.Size[q] - origin[q];
      }
      this->Corners[corner] = { Dot(from, axisI) / i2, Dot(from, axisJ) / j2 };
    }
  }

  // The first and the last j in [-last, last] on the part of the box between the rows beside i
  std::array<int, 2> PlacesInRow(int i, int last) const
  {
    double low = last + 1.0, high = -last - 1.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int q = 0; q < 3; ++q)
      {
        const auto &a = this->Corners[corner & ~(1 << q)], &b = this->Corners[corner | 1 << q];
        if (std::min(a[0], b[0]) <= i + 1.0 && std::max(a[0], b[0]) >= i - 1.0)
        {
          for (double row : { i - 1.0, i + 1.0 })
          {
            const double share = a[0] == b[0] ? row > i : (row - a[0]) / (b[0] - a[0]);
            const double j = a[1] + std::clamp(share, 0.0, 1.0) * (b[1] - a[1]);
            low = std::min(low, j);
            high = std::max(high, j);
          }
        }
      }
    }
    return { static_cast<int>(std::max(std::floor(low), -1.0 * last)),
      static_cast<int>(std::min(std::ceil(high), 1.0 * last)) };
  }

private:
  std::array<std::array<double, 2>, 8> Corners; // i and j
};
}

SamplingRegion::SamplingRegion(const Window& window, double margin)
  : Shape(window.Shrunk(margin))
  , Bounds(this->Shape.GetBounds())
{
  if (this->Shape.GetShape() == Window::Shape::Cylinder)
  {
    for (int q = 0; q < 3; ++q)
    {
      this->Centre[q] = this->Shape.Base[q] + 0.5 * this->Shape.Height * this->Shape.Axis[q];
    }
    this->Radius = std::hypot(this->Shape.Radius, 0.5 * this->Shape.Height);
    this->Sparse = this->Shape.Volume() < SparseShare * this->Bounds.Volume();
    return;
  }
  this->EncloseBounds();
}

SamplingRegion::SamplingRegion(const VoxelMask& mask, double margin)
{
  this->Mask = mask.Eroded(margin);
  this->Shape = this->Mask->GetBounds();
  this->Bounds = this->Shape;
  this->EncloseBounds();
  this->Sparse = this->Mask->Volume() < SparseShare * this->Bounds.Volume();
  if (this->Sparse)
  {
    this->Voxels = this->Mask->InsideVoxels();
  }
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

Vector3 SamplingRegion::PointAt(const Vector3& u) const
{
  if (this->Sparse)
  {
    return this->Mask ? this->PointOfVoxels(u) : this->PointOfCylinder(u);
  }
  Vector3 point;
  for (int q = 0; q < 3; ++q)
  {
    point[q] = this->Bounds.Origin[q] + u[q] * this->Bounds.Size[q];
  }
  return point;
}

Vector3 SamplingRegion::PointOfVoxels(const Vector3& u) const
{
  const double place = u[0] * this->Voxels.size();
  const std::size_t number = std::min(static_cast<std::size_t>(place), this->Voxels.size() - 1);
  const Vector3 within = { place - number, u[1], u[2] };
  std::size_t voxel = this->Voxels[number];
  Vector3 point;
  for (int q = 0; q < 3; ++q)
  {
    const int count = this->Mask->GetDimensions()[q];
    point[q] =
      this->Mask->GetLower()[q] + (voxel % count + within[q]) * this->Mask->GetSpacing()[q];
    voxel /= count;
  }
  return point;
}

Vector3 SamplingRegion::PointOfCylinder(const Vector3& u) const
{
  Vector3 a, b, point;
  FindAcross(this->Shape.Axis, a, b);
  const double lateral = this->Shape.Radius * std::sqrt(u[0]) / Length(a);
  const double x = lateral * std::cos(2.0 * Pi * u[1]), y = lateral * std::sin(2.0 * Pi * u[1]);
  const double along = u[2] * this->Shape.Height;
  for (int q = 0; q < 3; ++q)
  {
    point[q] = this->Shape.Base[q] + along * this->Shape.Axis[q] + x * a[q] + y * b[q];
  }
  return point;
}

Vector3 SamplingRegion::RandomPoint(std::uint32_t seed, std::uint32_t sample) const
{
  for (std::uint64_t attempt = 0;; ++attempt)
  {
    const Vector3 point =
      this->PointAt(UniformTriple(seed, RandomStream::SamplePoint, Attempt(sample, attempt)));
    if (this->Contains(point))
    {
      return point;
    }
  }
}

Vector3 SamplingRegion::RandomDirection(std::uint32_t seed, std::uint32_t sample)
{
  const std::array<double, 3> u = UniformTriple(seed, RandomStream::SampleDirection, sample);
  return IsotropicDirection(u[0], u[1]);
}

double SamplingRegion::RandomTurn(std::uint32_t seed, std::uint32_t sample)
{
  return UniformTriple(seed, RandomStream::SampleDirection, sample)[2];
}

LineBundle SamplingRegion::ParallelLines(
  std::uint32_t seed, std::uint32_t sample, double number, double maximumLag) const
{
  const std::array<double, 3> u = UniformTriple(seed, RandomStream::LineDirection, sample);
  return this->ParallelLinesAlong(
    IsotropicDirection(u[0], u[1]), 0, seed, sample, number, maximumLag);
}

LineBundle SamplingRegion::ParallelLinesAlong(const Vector3& direction, std::uint32_t set,
  std::uint32_t seed, std::uint32_t sample, double number, double maximumLag) const
{
  const std::array<double, 3> v = UniformTriple(seed, RandomStream::LinePlace, sample, set);
  if (this->IsFullyPeriodic())
  {
    return this->PeriodicLines(direction, v, number, maximumLag);
  }
  const Vector3& d = direction;
  Vector3 a, b;
  FindAcross(d, a, b);
  const double spacing = this->GridSpacing(number);
  const double norm = std::hypot(a[0], a[1], a[2]);
  const double c = spacing * std::cos(2.0 * Pi * v[2]) / norm;
  const double s = spacing * std::sin(2.0 * Pi * v[2]) / norm;
  Vector3 axisI, axisJ, origin;
  for (int q = 0; q < 3; ++q)
  {
    axisI[q] = c * a[q] + s * b[q];
    axisJ[q] = c * b[q] - s * a[q];
    origin[q] = this->Centre[q] - this->Radius * d[q] + v[0] * axisI[q] + v[1] * axisJ[q];
  }
  // Seen along the lines, the region lies in the disc of the bounding sphere
  const double reach = this->Radius / spacing;
  const int last = static_cast<int>(reach) + 1;
  LineBundle bundle(this->Bounds, direction, origin, axisI, axisJ, { -last, -last },
    { 2 * last + 1, 2 * last + 1 });
  const BoxOnLattice box(this->Bounds, origin, axisI, axisJ);
  std::vector<LineInterval> inside;
  for (int i = -last; i <= last; ++i)
  {
    const std::array<int, 2> row = box.PlacesInRow(i, last);
    for (int j = row[0]; j <= row[1]; ++j)
    {
      if (std::hypot(i + v[0], j + v[1]) <= reach)
      {
        this->Clip(bundle.StartOf(i, j), direction, 2.0 * this->Radius, inside);
        if (!inside.empty())
        {
          bundle.AddLine(i, j, inside);
        }
      }
    }
  }
  return bundle;
}

// The lines begin in a plane parallel to the face that is most nearly across them, at a random
// place; the lattice closes over the periodic edges.
LineBundle SamplingRegion::PeriodicLines(const Vector3& direction,
  const std::array<double, 3>& shift, double number, double maximumLag) const
{
  int across = 0;
  for (int q = 1; q < 3; ++q)
  {
    across = std::abs(direction[q]) > std::abs(direction[across]) ? q : across;
  }
  const int p = (across + 1) % 3, q = (across + 2) % 3;
  const Vector3& size = this->Bounds.Size;
  const int rows =
    std::max(1, static_cast<int>(std::lround(std::sqrt(number * size[p] / size[q]))));
  const int columns = std::max(1, static_cast<int>(std::lround(number / rows)));
  Vector3 axisI{}, axisJ{}, origin = this->Bounds.Origin;
  axisI[p] = size[p] / rows;
  axisJ[q] = size[q] / columns;
  origin[p] += shift[0] * axisI[p];
  origin[q] += shift[1] * axisJ[q];
  origin[across] += shift[2] * size[across];
  const double length = size[across] / std::abs(direction[across]) + maximumLag;
  LineBundle bundle(this->Bounds, direction, origin, axisI, axisJ, { 0, 0 }, { rows, columns });
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < columns; ++j)
    {
      bundle.AddLine(i, j, { { 0.0, length } });
    }
  }
  return bundle;
}

double SamplingRegion::LongestLine(double maximumLag) const
{
  const Vector3& size = this->Bounds.Size;
  return this->IsFullyPeriodic()
    ? maximumLag + std::sqrt(3.0) * *std::max_element(size.begin(), size.end())
    : 2.0 * this->Radius;
}

// By Cauchy's formula it is a quarter of the surface area
double SamplingRegion::ProjectedArea() const
{
  const Window& shape = this->Shape;
  const Vector3& size = shape.Size;
  return shape.GetShape() == Window::Shape::Cylinder
    ? 0.5 * Pi * shape.Radius * (shape.Radius + shape.Height)
    : 0.5 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
}

double SamplingRegion::GridSpacing(double number) const
{
  return std::sqrt(this->ProjectedArea() / number);
}

double SamplingRegion::LinesOfSpacing(double spacing) const
{
  // Periodic lines begin in a face, whose area is two thirds of the projected area in the mean
  return this->ProjectedArea() / (spacing * spacing) * (this->IsFullyPeriodic() ? 2.0 / 3.0 : 1.0);
}

double SamplingRegion::MostLines(double number) const
{
  if (this->IsFullyPeriodic())
  {
    // Rows and columns are rounded. With more rows than lines asked for there is one column.
    const Vector3& size = this->Bounds.Size;
    const auto [least, greatest] = std::minmax_element(size.begin(), size.end());
    return 2.0 * number + 2.0 * std::sqrt(number * *greatest / *least) + 2.0;
  }
  const double across = 2.0 * this->Radius / this->GridSpacing(number) + 1.0;
  return across * across;
}

void SamplingRegion::Clip(const Vector3& start, const Vector3& direction, double length,
  std::vector<LineInterval>& inside) const
{
  if (this->Mask)
  {
    this->Mask->Intersect(start, direction, length, inside);
    return;
  }
  double begin = 0.0, end = length;
  if (this->Shape.GetShape() == Window::Shape::Box)
  {
    for (int q = 0; q < 3; ++q)
    {
      ClipToSlab(start[q], direction[q], this->Shape.Origin[q],
        this->Shape.Origin[q] + this->Shape.Size[q], begin, end);
    }
  }
  else
  {
    const Vector3 from = { start[0] - this->Shape.Base[0], start[1] - this->Shape.Base[1],
      start[2] - this->Shape.Base[2] };
    const double position = Dot(from, this->Shape.Axis);
    const double slope = Dot(direction, this->Shape.Axis);
    ClipToSlab(position, slope, 0.0, this->Shape.Height, begin, end);
    // Across the axis the condition is |p + t w| <= radius
    Vector3 p, w;
    for (int q = 0; q < 3; ++q)
    {
      p[q] = from[q] - position * this->Shape.Axis[q];
      w[q] = direction[q] - slope * this->Shape.Axis[q];
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
  inside.clear();
  if (begin < end)
  {
    inside.push_back({ begin, end });
  }
}
}
