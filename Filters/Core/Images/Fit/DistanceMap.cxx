// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/DistanceMap.h"

#include "ruc/Base/VectorClones.h"

namespace ruc
{
namespace
{
constexpr int Far = 1 << 15; // more planes than an image has, with a square of NoMatrix

// Counts the planes since the last one with matrix, column by column, in one direction
RUC_VECTOR_CLONES
void CountPlanes(const std::uint8_t* particles, int count, std::int32_t* since)
{
  for (int n = 0; n < count; ++n)
  {
    since[n] = particles[n] != 0 ? (since[n] < Far ? since[n] + 1 : Far) : 0;
  }
}

RUC_VECTOR_CLONES
void TakeNearer(const std::int32_t* since, int count, std::int32_t* nearest)
{
  for (int n = 0; n < count; ++n)
  {
    const std::int32_t least = since[n] < nearest[n] ? since[n] : nearest[n];
    nearest[n] = least;
  }
}

RUC_VECTOR_CLONES
void Square(int count, std::int32_t* values)
{
  for (int n = 0; n < count; ++n)
  {
    values[n] *= values[n];
  }
}

// Lowers distances to those of other rows that lie `square` away, and returns the greatest left
RUC_VECTOR_CLONES
std::int32_t Lower(const std::int32_t* before, const std::int32_t* after, std::int32_t square,
  int count, std::int32_t* nearest)
{
  std::int32_t greatest = 0;
  for (int n = 0; n < count; ++n)
  {
    const std::int32_t other = (before[n] < after[n] ? before[n] : after[n]) + square;
    const std::int32_t least = other < nearest[n] ? other : nearest[n];
    nearest[n] = least;
    greatest = least > greatest ? least : greatest;
  }
  return greatest;
}

RUC_VECTOR_CLONES
std::int32_t Greatest(const std::int32_t* values, int count)
{
  std::int32_t greatest = 0;
  for (int n = 0; n < count; ++n)
  {
    greatest = values[n] > greatest ? values[n] : greatest;
  }
  return greatest;
}

/**
 * Finds the distances within a plane from those across planes, first along y, then along x. Parts
 * of rows are done at once, each as far as its greatest distance asks.
 */
class PlaneOfDistances
{
public:
  PlaneOfDistances(int width, int height)
    : Width(width)
    , Height(height)
    , Copy(static_cast<std::size_t>(width) * height)
    , Nothing(width, NoMatrix)
    , Padded(3 * static_cast<std::size_t>(width), NoMatrix)
  {
  }

  void Complete(std::int32_t* plane)
  {
    std::copy_n(plane, this->Copy.size(), this->Copy.begin());
    for (int y = 0; y < this->Height; ++y)
    {
      std::int32_t* row = plane + static_cast<std::size_t>(y) * this->Width;
      for (int x = 0; x < this->Width; x += Tile)
      {
        this->LowerAlongY(y, x, std::min(Tile, this->Width - x), row + x);
      }
      std::copy_n(row, this->Width, this->Padded.begin() + this->Width);
      for (int x = 0; x < this->Width; x += Tile)
      {
        this->LowerAlongX(x, std::min(Tile, this->Width - x), row + x);
      }
    }
  }

private:
  static constexpr int Tile = 64;

  void LowerAlongY(int y, int x, int count, std::int32_t* nearest) const
  {
    const auto row = [&](int other)
    {
      return other < 0 || other >= this->Height
        ? this->Nothing.data()
        : this->Copy.data() + static_cast<std::size_t>(other) * this->Width + x;
    };
    std::int32_t greatest = Greatest(nearest, count);
    for (int k = 1; k < this->Height && k * k < greatest; ++k)
    {
      greatest = Lower(row(y - k), row(y + k), k * k, count, nearest);
    }
  }

  void LowerAlongX(int x, int count, std::int32_t* nearest) const
  {
    const std::int32_t* here = this->Padded.data() + this->Width + x;
    std::int32_t greatest = Greatest(nearest, count);
    for (int k = 1; k < this->Width && k * k < greatest; ++k)
    {
      greatest = Lower(here - k, here + k, k * k, count, nearest);
    }
  }

  int Width, Height;
  std::vector<std::int32_t> Copy, Nothing, Padded;
};

// The planes since the last matrix, for each column, on the ranks before this one or after it
struct Columns
{
  std::vector<std::int32_t> FromBelow, FromAbove;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.FromBelow, self.FromAbove);
  }
};

// What this rank tells: planes from its last matrix to its upper face, and from its lower face to
// its first
Columns FindColumns(const VoxelSlab<std::uint8_t>& particles)
{
  const std::size_t size = particles.PlaneSize();
  Columns own = { std::vector<std::int32_t>(size, Far), std::vector<std::int32_t>(size, Far) };
  const int count = static_cast<int>(size);
  for (int z = particles.First; z < particles.Last; ++z)
  {
    CountPlanes(particles.Row(0, z), count, own.FromBelow.data());
    CountPlanes(
      particles.Row(0, particles.Last - 1 - (z - particles.First)), count, own.FromAbove.data());
  }
  return own;
}

Columns FindColumnsBeyond(const VoxelSlab<std::uint8_t>& particles, Communicator& ranks)
{
  const std::size_t size = particles.PlaneSize();
  Columns beyond = { std::vector<std::int32_t>(size, Far), std::vector<std::int32_t>(size, Far) };
  if (ranks.Size() == 1)
  {
    return beyond;
  }
  const Slabs slabs = { particles.Dimensions[2], ranks.Size() };
  const std::vector<Columns> all = ranks.AllGather(FindColumns(particles));
  const auto follow =
    [&](int rank, const std::vector<std::int32_t>& columns, std::vector<std::int32_t>& since)
  {
    const int thickness = static_cast<int>(slabs.Size(rank));
    for (std::size_t n = 0; n < size; ++n)
    {
      // A column without matrix on that rank has Far, however thick it is
      since[n] = columns[n] < thickness ? columns[n] : std::min(Far, since[n] + thickness);
    }
  };
  for (int rank = 0; rank < ranks.Rank(); ++rank)
  {
    follow(rank, all[rank].FromBelow, beyond.FromBelow);
  }
  for (int rank = ranks.Size() - 1; rank > ranks.Rank(); --rank)
  {
    follow(rank, all[rank].FromAbove, beyond.FromAbove);
  }
  return beyond;
}
}

VoxelSlab<std::uint8_t> FindAbove(const VoxelSlab<float>& image, float threshold)
{
  VoxelSlab<std::uint8_t> above = { image.Dimensions, image.First, image.Last, {} };
  above.Values.resize(image.Values.size());
  std::transform(image.Values.begin(), image.Values.end(), above.Values.begin(),
    [threshold](float value) { return static_cast<std::uint8_t>(value > threshold); });
  return above;
}

VoxelSlab<std::int32_t> SquaredDistances(VoxelSlab<std::uint8_t> particles, Communicator& ranks)
{
  VoxelSlab<std::int32_t> map = { particles.Dimensions, particles.First, particles.Last, {} };
  map.Values.resize(particles.Values.size());
  Columns beyond = FindColumnsBeyond(particles, ranks);
  const int width = particles.Dimensions[0], height = particles.Dimensions[1];
#pragma omp parallel for schedule(static)
  for (int y = 0; y < height; ++y)
  {
    std::int32_t* below = beyond.FromBelow.data() + static_cast<std::size_t>(y) * width;
    std::int32_t* above = beyond.FromAbove.data() + static_cast<std::size_t>(y) * width;
    for (int z = particles.First; z < particles.Last; ++z)
    {
      CountPlanes(particles.Row(y, z), width, below);
      std::copy_n(below, width, map.Row(y, z));
    }
    for (int z = particles.Last - 1; z >= particles.First; --z)
    {
      CountPlanes(particles.Row(y, z), width, above);
      TakeNearer(above, width, map.Row(y, z));
      Square(width, map.Row(y, z));
    }
  }
  particles.Values = {};
#pragma omp parallel
  {
    PlaneOfDistances plane(width, height);
#pragma omp for schedule(dynamic)
    for (int z = particles.First; z < particles.Last; ++z)
    {
      plane.Complete(map.Row(0, z));
    }
  }
  return map;
}
}
