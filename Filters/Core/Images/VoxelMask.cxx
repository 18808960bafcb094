// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/VoxelMask.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Images/MaskErosion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ruc
{
namespace
{
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

// The bits of rows of voxels, each of which begins with a byte
std::vector<std::uint8_t> PackRows(const std::vector<std::uint8_t>& inside, std::size_t width)
{
  const std::size_t bytes = (width + 7) / 8;
  std::vector<std::uint8_t> bits(inside.size() / width * bytes, 0);
  for (std::size_t n = 0; n < inside.size(); ++n)
  {
    const std::size_t x = n % width;
    bits[n / width * bytes + x / 8] |= static_cast<std::uint8_t>((inside[n] != 0) << x % 8);
  }
  return bits;
}

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
  const Vector3& spacing, const std::vector<std::uint8_t>& inside)
  : Dimensions(dimensions)
  , Lower(lower)
  , Spacing(spacing)
{
  CheckImage(dimensions, lower, spacing, inside.size());
  this->Bits = PackRows(inside, dimensions[0]);
  this->Enclose();
}

VoxelMask VoxelMask::Gather(
  const VoxelGrid& grid, const VoxelSlab<std::uint8_t>& inside, Communicator& ranks)
{
  VoxelMask mask;
  mask.Dimensions = grid.Dimensions;
  mask.Lower = grid.Lower;
  mask.Spacing = grid.Spacing;
  std::int64_t voxels = static_cast<std::int64_t>(inside.Values.size());
  ranks.Sum(&voxels, 1);
  CheckImage(mask.Dimensions, mask.Lower, mask.Spacing, static_cast<std::size_t>(voxels));
  mask.Bits = ranks.Concatenate(PackRows(inside.Values, grid.Dimensions[0]));
  mask.Enclose();
  return mask;
}

template <class Use>
void VoxelMask::ForEachVoxel(Use&& use) const
{
  for (int z = 0; z < this->Dimensions[2]; ++z)
  {
    for (int y = 0; y < this->Dimensions[1]; ++y)
    {
      for (int x = 0; x < this->Dimensions[0]; ++x)
      {
        use(std::array<int, 3>{ x, y, z }, this->IsInside(x, y, z));
      }
    }
  }
}

void VoxelMask::Enclose()
{
  std::array<int, 3> first = this->Dimensions, last = { -1, -1, -1 };
  this->ForEachVoxel(
    [&](const std::array<int, 3>& voxel, bool isInside)
    {
      this->NumberInside += isInside ? 1 : 0;
      for (int q = 0; q < 3 && isInside; ++q)
      {
        first[q] = std::min(first[q], voxel[q]);
        last[q] = std::max(last[q], voxel[q]);
      }
    });
  if (this->NumberInside == 0)
  {
    throw std::invalid_argument("Mask requires at least one inside voxel, got none.");
  }
  Vector3 corner, size;
  for (int q = 0; q < 3; ++q)
  {
    corner[q] = this->Lower[q] + first[q] * this->Spacing[q];
    size[q] = (last[q] + 1 - first[q]) * this->Spacing[q];
  }
  this->Bounds = Window::MakeBox(corner, size, { false, false, false });
}

std::vector<std::size_t> VoxelMask::InsideVoxels() const
{
  std::vector<std::size_t> voxels;
  voxels.reserve(this->NumberInside);
  std::size_t voxel = 0;
  this->ForEachVoxel(
    [&](const std::array<int, 3>&, bool isInside)
    {
      if (isInside)
      {
        voxels.push_back(voxel);
      }
      ++voxel;
    });
  return voxels;
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
  return this->IsInside(voxel[0], voxel[1], voxel[2]);
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
  VoxelSlab<std::uint8_t> inside = { this->Dimensions, 0, this->Dimensions[2], {} };
  inside.Values.reserve(inside.PlaneSize() * this->Dimensions[2]);
  this->ForEachVoxel(
    [&](const std::array<int, 3>&, bool isInside) { inside.Values.push_back(isInside ? 1 : 0); });
  Communicator one;
  return Gather({ this->Dimensions, this->Lower, this->Spacing },
    ErodeMask(std::move(inside), this->Spacing, margin, one), one);
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
    if (after > t && this->IsInside(voxel[0], voxel[1], voxel[2]))
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
