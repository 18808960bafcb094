// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/MaskErosion.h"

#include "ruc/Base/Text.h"
#include "ruc/Window/Window.h"

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
class MaskDistances
{
public:
  MaskDistances(const std::vector<std::uint8_t>& voxels, const std::array<int, 3>& dimensions,
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

}

VoxelSlab<std::uint8_t> ErodeMask(
  VoxelSlab<std::uint8_t> inside, const Vector3& spacing, double margin, Communicator& ranks)
{
  RequireMargin(margin);
  if (margin == 0.0)
  {
    return inside;
  }
  // The planes of a rank are eroded as an image of their own. Its border makes outside what is a
  // margin or more away from the planes that count
  const double planes = std::ceil(margin / spacing[2]) + 1.0;
  SetHalo(inside, static_cast<int>(std::min<double>(planes, inside.Dimensions[2])), ranks);
  const std::array<int, 3> dimensions = { inside.Dimensions[0], inside.Dimensions[1],
    inside.Last - inside.First };
  // Voxels that touch an outside one, or the border, are at no distance from it. The distance
  // between any other voxel, as a box, and the outside is the distance between its centre and the
  // nearest centre of such a voxel, as one spacing along each axis is taken off either way.
  const std::vector<std::uint8_t> apart = WithoutRim(inside.Values, dimensions);
  MaskDistances distances(apart, dimensions, spacing);
  const double least = margin * (1.0 - 1e-9);
  const int columns = (dimensions[0] + Parts - 1) / Parts;
  for (int from = 0; from < dimensions[0]; from += columns)
  {
    const int to = std::min(from + columns, dimensions[0]);
    auto distance2 = distances.Find(from, to).begin();
    for (std::size_t row = 0; row < inside.Values.size(); row += dimensions[0])
    {
      for (std::size_t n = row + from; n < row + to; ++n, ++distance2)
      {
        inside.Values[n] = inside.Values[n] && *distance2 >= least * least;
      }
    }
  }
  SetHalo(inside, 0, ranks);
  std::int64_t kept = std::count_if(
    inside.Values.begin(), inside.Values.end(), [](std::uint8_t voxel) { return voxel != 0; });
  ranks.Sum(&kept, 1);
  if (kept == 0)
  {
    throw std::invalid_argument(Text("The mask requires inside voxels at least ", margin,
      " from every outside one and from the border of the image, got none."));
  }
  return inside;
}
}
