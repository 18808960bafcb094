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

// Where rows of voxels, one after the other, go from outside to inside and back, and how many such
// ends each row has
struct RunEnds
{
  RunEnds(const std::vector<std::uint8_t>& inside, std::size_t width)
  {
    for (std::size_t row = 0; row < inside.size(); row += width)
    {
      const std::size_t before = this->Ends.size();
      bool was = false;
      for (std::size_t x = 0; x < width; ++x)
      {
        const bool is = inside[row + x] != 0;
        if (is != was)
        {
          this->Ends.push_back(static_cast<std::int32_t>(x));
        }
        was = is;
      }
      if (was)
      {
        this->Ends.push_back(static_cast<std::int32_t>(width));
      }
      this->OfRow.push_back(static_cast<std::int32_t>(this->Ends.size() - before));
    }
  }

  std::vector<std::int32_t> Ends, OfRow;
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
  const Vector3& spacing, const std::vector<std::uint8_t>& inside)
  : Dimensions(dimensions)
  , Lower(lower)
  , Spacing(spacing)
{
  CheckImage(dimensions, lower, spacing, inside.size());
  RunEnds runs(inside, dimensions[0]);
  this->Take(std::move(runs.Ends), runs.OfRow);
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
  const RunEnds own(inside.Values, grid.Dimensions[0]);
  mask.Take(ranks.Concatenate(own.Ends), ranks.Concatenate(own.OfRow));
  return mask;
}

void VoxelMask::Take(std::vector<std::int32_t> ends, const std::vector<std::int32_t>& endsOfRow)
{
  this->Ends = std::move(ends);
  this->FirstEnd.assign(1, 0);
  for (const std::int32_t number : endsOfRow)
  {
    this->FirstEnd.push_back(this->FirstEnd.back() + number);
  }
  this->Enclose();
}

template <class Use>
void VoxelMask::ForEachRun(Use&& use) const
{
  for (std::size_t row = 0; row + 1 < this->FirstEnd.size(); ++row)
  {
    for (std::int64_t n = this->FirstEnd[row]; n < this->FirstEnd[row + 1]; n += 2)
    {
      use(row, this->Ends[n], this->Ends[n + 1]);
    }
  }
}

void VoxelMask::Enclose()
{
  std::array<int, 3> first = this->Dimensions, last = { -1, -1, -1 };
  this->ForEachRun(
    [&](std::size_t row, std::int32_t begin, std::int32_t end)
    {
      this->NumberInside += end - begin;
      const int y = static_cast<int>(row % this->Dimensions[1]);
      const int z = static_cast<int>(row / this->Dimensions[1]);
      first = { std::min(first[0], begin), std::min(first[1], y), std::min(first[2], z) };
      last = { std::max(last[0], end - 1), std::max(last[1], y), std::max(last[2], z) };
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
  this->ForEachRun(
    [&](std::size_t row, std::int32_t begin, std::int32_t end)
    {
      for (std::int32_t x = begin; x < end; ++x)
      {
        voxels.push_back(row * this->Dimensions[0] + x);
      }
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
  inside.Values.assign(inside.PlaneSize() * this->Dimensions[2], 0);
  for (const std::size_t voxel : this->InsideVoxels())
  {
    inside.Values[voxel] = 1;
  }
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
