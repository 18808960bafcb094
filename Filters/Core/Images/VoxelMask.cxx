// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/VoxelMask.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ruc
{
namespace
{
// The number of parts of a mask whose distances are found one after another, so that they take a
// byte for each voxel
constexpr int Parts = 8;

/**
 * Computes values[i] = min over j of values[j] + (spacing (i - j))^2, where all values are finite,
 * by the lower envelope of parabolas (Felzenszwalb and Huttenlocher, Theory of Computing 8, 2012).
 */
class ParabolaEnvelope
{
public:
  explicit ParabolaEnvelope(std::size_t count)
    : Values(count)
    , Vertex(count)
    , From(count)
  {
  }

  void Transform(double* values, std::size_t stride, double spacing)
  {
    const int count = static_cast<int>(this->Values.size());
    const double square = spacing * spacing;
    int last = -1;
    for (int i = 0; i < count; ++i)
    {
      this->Values[i] = values[i * stride];
      double from = -std::numeric_limits<double>::infinity();
      while (last >= 0)
      {
        const int j = this->Vertex[last];
        from = 0.5 * ((this->Values[i] - this->Values[j]) / (square * (i - j)) + i + j);
        if (from > this->From[last])
        {
          break;
        }
        --last;
      }
      ++last;
      this->Vertex[last] = i;
      this->From[last] = last == 0 ? -std::numeric_limits<double>::infinity() : from;
    }
    int part = 0;
    for (int i = 0; i < count; ++i)
    {
      while (part < last && this->From[part + 1] < i)
      {
        ++part;
      }
      const double away = i - this->Vertex[part];
      values[i * stride] = this->Values[this->Vertex[part]] + square * away * away;
    }
  }

private:
  std::vector<double> Values;
  std::vector<int> Vertex;
  std::vector<double> From;
};

void CheckImage(const std::array<int, 3>& dimensions, const Vector3& lower, const Vector3& spacing,
  std::size_t voxels)
{
  double product = 1.0;
  for (int q = 0; q < 3; ++q)
  {
    if (dimensions[q] < 1)
    {
      throw std::invalid_argument(Text("Mask requires three dimensions >= 1, got ", dimensions[0],
        " ", dimensions[1], " ", dimensions[2], "."));
    }
    if (!(spacing[q] > 0.0 && std::isfinite(spacing[q]) && std::isfinite(lower[q])))
    {
      throw std::invalid_argument(
        Text("Mask requires a finite origin and finite spacings > 0, got ", lower[0], " ", lower[1],
          " ", lower[2], " and ", spacing[0], " ", spacing[1], " ", spacing[2], "."));
    }
    product *= dimensions[q];
  }
  Require(product == static_cast<double>(voxels), "Mask", Text(product, " voxels"), voxels);
}

std::array<std::size_t, 3> StridesOf(const std::array<int, 3>& dimensions)
{
  const std::size_t row = dimensions[0];
  return { 1, row, row * dimensions[1] };
}

// Keeps the inside voxels that touch neither the border of the image nor, by a face, an edge or a
// corner, an outside voxel
std::vector<std::uint8_t> WithoutRim(
  const std::vector<std::uint8_t>& inside, const std::array<int, 3>& dimensions)
{
  const std::array<std::size_t, 3> strides = StridesOf(dimensions);
  std::vector<std::uint8_t> apart = inside;
  for (int q = 0; q < 3; ++q)
  {
    // The former values of the voxels before, which are overwritten
    std::vector<std::uint8_t> before(strides[q]);
    for (std::size_t n = 0; n < apart.size(); ++n)
    {
      const int along = static_cast<int>(n / strides[q] % dimensions[q]);
      const std::uint8_t last = std::exchange(before[n % strides[q]], apart[n]);
      apart[n] =
        along > 0 && along + 1 < dimensions[q] && apart[n] && last && apart[n + strides[q]];
    }
  }
  return apart;
}

/**
 * The squared distances of the voxels' centres from the nearest centre of a voxel that is 0, for
 * some planes of voxels with the same x at a time. They take eight bytes for each of these voxels.
 */
class SquaredDistances
{
public:
  SquaredDistances(const std::vector<std::uint8_t>& voxels, const std::array<int, 3>& dimensions,
    const Vector3& spacing)
    : Voxels(voxels)
    , Dimensions(dimensions)
    , Spacing(spacing)
    , Far(std::hypot(
        dimensions[0] * spacing[0], dimensions[1] * spacing[1], dimensions[2] * spacing[2]))
  {
  }

  // Finds the distances in the planes first to last - 1, in the order of the voxels
  const std::vector<double>& Find(int first, int last)
  {
    const std::array<int, 3> part = { last - first, this->Dimensions[1], this->Dimensions[2] };
    const std::array<std::size_t, 3> strides = StridesOf(part);
    const std::int64_t lines = static_cast<std::int64_t>(part[1]) * part[2];
    this->Distance2.resize(lines * part[0]);
#pragma omp parallel
    {
      std::vector<int> away(this->Dimensions[0]);
#pragma omp for schedule(static)
      for (std::int64_t line = 0; line < lines; ++line)
      {
        this->FindAlongLine(line, away);
        for (int x = first; x < last; ++x)
        {
          const double distance = away[x];
          this->Distance2[line * part[0] + x - first] = away[x] < 0
            ? this->Far * this->Far
            : this->Spacing[0] * this->Spacing[0] * distance * distance;
        }
      }
      for (int q : { 1, 2 })
      {
        ParabolaEnvelope envelope(part[q]);
#pragma omp for schedule(static)
        for (int a = 0; a < part[3 - q]; ++a)
        {
          for (int x = 0; x < part[0]; ++x)
          {
            envelope.Transform(
              this->Distance2.data() + a * strides[3 - q] + x, strides[q], this->Spacing[q]);
          }
        }
      }
    }
    return this->Distance2;
  }

private:
  // Finds, for each voxel of a line along x, how many voxels away the nearest 0 of the line is; -1
  // if there is none
  void FindAlongLine(std::int64_t line, std::vector<int>& away) const
  {
    const int count = this->Dimensions[0];
    const std::uint8_t* voxels = &this->Voxels[line * count];
    int last = -1;
    for (int x = 0; x < count; ++x)
    {
      last = voxels[x] == 0 ? x : last;
      away[x] = last < 0 ? -1 : x - last;
    }
    last = -1;
    for (int x = count - 1; x >= 0; --x)
    {
      last = voxels[x] == 0 ? x : last;
      if (last >= 0 && (away[x] < 0 || last - x < away[x]))
      {
        away[x] = last - x;
      }
    }
  }

  const std::vector<std::uint8_t>& Voxels;
  std::array<int, 3> Dimensions;
  Vector3 Spacing;
  double Far;
  std::vector<double> Distance2;
};

// Appends a part, or continues the last interval where the part follows it
void Append(const LineInterval& part, std::vector<LineInterval>& intervals)
{
  if (!intervals.empty() && intervals.back().End == part.Begin)
  {
    intervals.back().End = part.End;
  }
  else
  {
    intervals.push_back(part);
  }
}
}

VoxelMask::VoxelMask(const std::array<int, 3>& dimensions, const Vector3& lower,
  const Vector3& spacing, std::vector<std::uint8_t> inside)
  : Dimensions(dimensions)
  , Lower(lower)
  , Spacing(spacing)
  , Inside(std::move(inside))
{
  CheckImage(dimensions, lower, spacing, this->Inside.size());
  std::array<int, 3> first = dimensions, last = { -1, -1, -1 };
  std::size_t n = 0;
  for (int z = 0; z < dimensions[2]; ++z)
  {
    for (int y = 0; y < dimensions[1]; ++y)
    {
      for (int x = 0; x < dimensions[0]; ++x)
      {
        if (this->Inside[n++])
        {
          ++this->NumberInside;
          const int voxel[3] = { x, y, z };
          for (int q = 0; q < 3; ++q)
          {
            first[q] = std::min(first[q], voxel[q]);
            last[q] = std::max(last[q], voxel[q]);
          }
        }
      }
    }
  }
  if (this->NumberInside == 0)
  {
    throw std::invalid_argument("Mask requires at least one inside voxel, got none.");
  }
  Vector3 corner, size;
  for (int q = 0; q < 3; ++q)
  {
    corner[q] = lower[q] + first[q] * spacing[q];
    size[q] = (last[q] + 1 - first[q]) * spacing[q];
  }
  this->Bounds = Window::MakeBox(corner, size, { false, false, false });
}

bool VoxelMask::Contains(const Vector3& point) const
{
  int voxel[3];
  for (int q = 0; q < 3; ++q)
  {
    const double v = std::floor((point[q] - this->Lower[q]) / this->Spacing[q]);
    if (!(v >= 0.0 && v < this->Dimensions[q]))
    {
      return false;
    }
    voxel[q] = static_cast<int>(v);
  }
  return this->Inside[this->VoxelAt(voxel[0], voxel[1], voxel[2])] != 0;
}

double VoxelMask::Volume() const
{
  return this->NumberInside * this->Spacing[0] * this->Spacing[1] * this->Spacing[2];
}

VoxelMask VoxelMask::Eroded(double margin) const
{
  RequireMargin(margin);
  if (margin == 0.0)
  {
    return *this;
  }
  // Voxels that touch an outside one, or the border, are at no distance from it. The distance
  // between any other voxel, as a box, and the outside is the distance between its centre and the
  // nearest centre of such a voxel, as one spacing along each axis is taken off either way.
  const std::vector<std::uint8_t> apart = WithoutRim(this->Inside, this->Dimensions);
  SquaredDistances distances(apart, this->Dimensions, this->Spacing);
  std::vector<std::uint8_t> kept(this->Inside.size());
  const double least = margin * (1.0 - 1e-9);
  bool any = false;
  const int planes = (this->Dimensions[0] + Parts - 1) / Parts;
  for (int first = 0; first < this->Dimensions[0]; first += planes)
  {
    const int last = std::min(first + planes, this->Dimensions[0]);
    auto distance2 = distances.Find(first, last).begin();
    for (std::size_t row = 0; row < kept.size(); row += this->Dimensions[0])
    {
      for (std::size_t n = row + first; n < row + last; ++n, ++distance2)
      {
        kept[n] = this->Inside[n] && *distance2 >= least * least;
        any = any || kept[n];
      }
    }
  }
  if (!any)
  {
    throw std::invalid_argument(Text("The mask requires inside voxels at least ", margin,
      " from every outside one and from the border of the image, got none."));
  }
  return VoxelMask(this->Dimensions, this->Lower, this->Spacing, std::move(kept));
}

LineInterval VoxelMask::ClipToImage(
  const Vector3& start, const Vector3& direction, double length) const
{
  LineInterval part = { 0.0, length };
  for (int q = 0; q < 3; ++q)
  {
    const double low = this->Lower[q];
    const double high = low + this->Dimensions[q] * this->Spacing[q];
    if (direction[q] == 0.0)
    {
      if (start[q] < low || start[q] >= high)
      {
        return { 0.0, 0.0 };
      }
      continue;
    }
    const double t0 = (low - start[q]) / direction[q], t1 = (high - start[q]) / direction[q];
    part.Begin = std::max(part.Begin, std::min(t0, t1));
    part.End = std::min(part.End, std::max(t0, t1));
  }
  return part;
}

void VoxelMask::Intersect(const Vector3& start, const Vector3& direction, double length,
  std::vector<LineInterval>& intervals) const
{
  intervals.clear();
  const LineInterval image = this->ClipToImage(start, direction, length);
  if (!(image.Begin < image.End))
  {
    return;
  }
  int voxel[3], step[3];
  double next[3]; // where the line leaves the voxel along each axis
  const auto leaves = [&](int q)
  {
    return step[q] == 0
      ? std::numeric_limits<double>::infinity()
      : (this->Lower[q] + (voxel[q] + (step[q] > 0)) * this->Spacing[q] - start[q]) / direction[q];
  };
  for (int q = 0; q < 3; ++q)
  {
    const double place =
      (start[q] + image.Begin * direction[q] - this->Lower[q]) / this->Spacing[q];
    voxel[q] = std::clamp(static_cast<int>(std::floor(place)), 0, this->Dimensions[q] - 1);
    step[q] = direction[q] > 0.0 ? 1 : direction[q] < 0.0 ? -1 : 0;
    next[q] = leaves(q);
  }
  for (double t = image.Begin; t < image.End;)
  {
    const int q = static_cast<int>(std::min_element(next, next + 3) - next);
    const double after = std::clamp(next[q], t, image.End);
    if (after > t && this->Inside[this->VoxelAt(voxel[0], voxel[1], voxel[2])])
    {
      Append({ t, after }, intervals);
    }
    t = after;
    voxel[q] += step[q];
    if (voxel[q] < 0 || voxel[q] >= this->Dimensions[q])
    {
      return;
    }
    next[q] = leaves(q);
  }
}
}
