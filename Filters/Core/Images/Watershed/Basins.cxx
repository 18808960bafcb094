// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Watershed/Basins.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace ruc
{
namespace
{
struct Voxel
{
  int X, Y, Z;
};

// Where water ends that falls on some voxels of a rank: at a maximum, or at a voxel of another rank
struct End
{
  std::int64_t Voxel = 0; // its place in the image
  std::int32_t Height = 0;
  /** The number of an end, counted over all ranks, at which water goes on from there; its own for a
   * maximum. */
  std::int64_t Next = -1;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Voxel, self.Height, self.Next);
  }
};

// The highest pass between two basins
struct Pass
{
  std::int32_t A = 0, B = 0, Height = 0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.A, self.B, self.Height);
  }
};

// The way of the water in the planes of a rank
class Streams
{
public:
  explicit Streams(const VoxelSlab<std::int32_t>& map, int first, int last)
    : Map(map)
    , First(first)
    , Last(last)
  {
    this->Number = { map.Dimensions, first, last, {} };
    this->Number.Values.assign((last - first) * map.PlaneSize(), 0);
  }

  /** Numbers the voxels, from 1, by the end of the water that falls on them. */
  void Follow()
  {
    const std::array<int, 3>& n = this->Map.Dimensions;
    for (int z = this->First; z < this->Last; ++z)
    {
      for (int y = 0; y < n[1]; ++y)
      {
        for (int x = 0; x < n[0]; ++x)
        {
          if (this->Map.Row(y, z)[x] > 0 && this->Number.Row(y, z)[x] == 0)
          {
            this->FollowFrom({ x, y, z });
          }
        }
      }
    }
  }

  std::int64_t PlaceOf(const Voxel& at) const
  {
    const std::array<int, 3>& n = this->Map.Dimensions;
    return (static_cast<std::int64_t>(at.Z) * n[1] + at.Y) * n[0] + at.X;
  }

  VoxelSlab<std::int32_t> Number;
  std::vector<End> Ends;

private:
  void FollowFrom(Voxel at)
  {
    this->Path.clear();
    std::int32_t end = 0;
    while (end == 0)
    {
      if (at.Z < this->First || at.Z >= this->Last)
      {
        end = this->NumberBeyond(at);
        break;
      }
      std::int32_t& here = this->Number.Row(at.Y, at.Z)[at.X];
      end = here;
      if (end == 0)
      {
        this->Path.push_back(&here);
        const Voxel next = this->NextOf(at);
        end = this->PlaceOf(next) == this->PlaceOf(at) ? this->Add(at) : 0;
        at = next;
      }
    }
    for (std::int32_t* number : this->Path)
    {
      *number = end;
    }
  }

  std::int32_t Add(const Voxel& at)
  {
    this->Ends.push_back({ this->PlaceOf(at), this->Map.Row(at.Y, at.Z)[at.X], -1 });
    return static_cast<std::int32_t>(this->Ends.size());
  }

  std::int32_t NumberBeyond(const Voxel& at)
  {
    std::int32_t& number = this->Beyond[this->PlaceOf(at)];
    number = number == 0 ? this->Add(at) : number;
    return number;
  }

  // The neighbour to which the water runs, or the voxel itself where it is a maximum
  Voxel NextOf(const Voxel& at) const
  {
    const std::array<int, 3>& n = this->Map.Dimensions;
    const std::int32_t here = this->Map.Row(at.Y, at.Z)[at.X];
    std::int32_t highest[3] = { here, here, here }; // of those along one axis, two and three
    Voxel best[3] = { at, at, at };
    Voxel equal = at;
    bool before = false;
    for (int z = std::max(this->Map.First, at.Z - 1); z <= std::min(this->Map.Last - 1, at.Z + 1);
         ++z)
    {
      for (int y = std::max(0, at.Y - 1); y <= std::min(n[1] - 1, at.Y + 1); ++y)
      {
        const std::int32_t* row = this->Map.Row(y, z);
        for (int x = std::max(0, at.X - 1); x <= std::min(n[0] - 1, at.X + 1); ++x)
        {
          const int axes = (x != at.X) + (y != at.Y) + (z != at.Z);
          if (axes > 0 && row[x] > highest[axes - 1])
          {
            highest[axes - 1] = row[x];
            best[axes - 1] = { x, y, z };
          }
          else if (!before && row[x] == here)
          {
            equal = { x, y, z }; // the voxel itself, where none is before it
            before = true;
          }
        }
      }
    }
    double steepest = 0.0;
    const double height = std::sqrt(static_cast<double>(here));
    Voxel next = equal;
    for (int axes = 0; axes < 3; ++axes)
    {
      const double slope =
        (std::sqrt(static_cast<double>(highest[axes])) - height) / std::sqrt(axes + 1.0);
      if (slope > steepest)
      {
        steepest = slope;
        next = best[axes];
      }
    }
    return next;
  }

  const VoxelSlab<std::int32_t>& Map;
  int First, Last;
  std::unordered_map<std::int64_t, std::int32_t> Beyond;
  std::vector<std::int32_t*> Path;
};

// Asks the other ranks where water goes on, and returns the ends of all ranks in their order
std::vector<End> JoinEnds(
  Streams& streams, const std::array<int, 3>& dimensions, Communicator& ranks)
{
  const Slabs planes = { dimensions[2], ranks.Size() };
  const std::int64_t plane = static_cast<std::int64_t>(dimensions[0]) * dimensions[1];
  const auto rankOf = [&](std::int64_t voxel)
  {
    int rank = 0;
    while (voxel / plane >= planes.End(rank))
    {
      ++rank;
    }
    return rank;
  };
  std::int64_t offset = 0;
  const std::vector<std::int64_t> counts =
    ranks.AllGather(static_cast<std::int64_t>(streams.Ends.size()));
  for (int rank = 0; rank < ranks.Rank(); ++rank)
  {
    offset += counts[rank];
  }
  const std::size_t size = ranks.Size();
  std::vector<std::vector<std::int64_t>> asked(size), answers(size);
  std::vector<std::vector<std::size_t>> askers(size);
  for (std::size_t n = 0; n < streams.Ends.size(); ++n)
  {
    const int rank = rankOf(streams.Ends[n].Voxel);
    if (rank == ranks.Rank())
    {
      streams.Ends[n].Next = offset + static_cast<std::int64_t>(n);
      continue;
    }
    asked[rank].push_back(streams.Ends[n].Voxel);
    askers[rank].push_back(n);
  }
  const auto own = static_cast<std::int64_t>(streams.Number.First) * plane;
  std::size_t from = 0;
  for (const std::vector<std::int64_t>& voxels : ranks.AllToAll(std::move(asked)))
  {
    for (std::int64_t voxel : voxels)
    {
      answers[from].push_back(offset + streams.Number.Values[voxel - own] - 1);
    }
    ++from;
  }
  from = 0;
  for (const std::vector<std::int64_t>& of : ranks.AllToAll(std::move(answers)))
  {
    for (std::size_t n = 0; n < of.size(); ++n)
    {
      streams.Ends[askers[from][n]].Next = of[n];
    }
    ++from;
  }
  // The numbers of all ranks
  for (std::int32_t& number : streams.Number.Values)
  {
    number += number > 0 ? static_cast<std::int32_t>(offset) : 0;
  }
  return ranks.Concatenate(streams.Ends);
}

// Replaces numbers of ends by those of maxima, from 1 in the order of their voxels, and returns
// these
std::vector<End> NumberMaxima(std::vector<End> ends, VoxelSlab<std::int32_t>& number)
{
  std::vector<End> maxima;
  std::vector<std::int64_t> last(ends.size());
  for (std::size_t n = 0; n < ends.size(); ++n)
  {
    last[n] = ends[n].Next;
    while (ends[last[n]].Next != last[n])
    {
      last[n] = ends[last[n]].Next;
    }
    if (last[n] == static_cast<std::int64_t>(n))
    {
      maxima.push_back(ends[n]);
    }
  }
  std::sort(
    maxima.begin(), maxima.end(), [](const End& a, const End& b) { return a.Voxel < b.Voxel; });
  std::vector<std::int32_t> numbers(ends.size() + 1, 0);
  for (std::size_t m = 0; m < maxima.size(); ++m)
  {
    numbers[maxima[m].Next + 1] = static_cast<std::int32_t>(m) + 1;
  }
  for (std::size_t n = 0; n < ends.size(); ++n)
  {
    numbers[n + 1] = numbers[last[n] + 1];
  }
  for (std::int32_t& of : number.Values)
  {
    of = numbers[of];
  }
  return maxima;
}

// The passes between basins in the planes of a rank and the next one. Both have a halo
std::vector<Pass> FindPasses(
  const VoxelSlab<std::int32_t>& map, const VoxelSlab<std::int32_t>& number, int first, int last)
{
  constexpr int steps[13][3] = { { 1, 0, 0 }, { -1, 1, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { -1, -1, 1 },
    { 0, -1, 1 }, { 1, -1, 1 }, { -1, 0, 1 }, { 0, 0, 1 }, { 1, 0, 1 }, { -1, 1, 1 }, { 0, 1, 1 },
    { 1, 1, 1 } };
  const std::array<int, 3>& n = map.Dimensions;
  std::unordered_map<std::int64_t, std::int32_t> highest;
  const auto meet = [&](const Voxel& at, const Voxel& other)
  {
    const std::int32_t a = number.Row(at.Y, at.Z)[at.X], b = number.Row(other.Y, other.Z)[other.X];
    if (a != b && b > 0)
    {
      std::int32_t& height =
        highest[static_cast<std::int64_t>(std::min(a, b)) << 32 | std::max(a, b)];
      height =
        std::max(height, std::min(map.Row(at.Y, at.Z)[at.X], map.Row(other.Y, other.Z)[other.X]));
    }
  };
  for (int z = first; z < last; ++z)
  {
    for (int y = 0; y < n[1]; ++y)
    {
      for (int x = 0; x < n[0]; ++x)
      {
        for (const auto& step : steps)
        {
          const Voxel other = { x + step[0], y + step[1], z + step[2] };
          if (number.Row(y, z)[x] > 0 && other.X >= 0 && other.X < n[0] && other.Y >= 0 &&
            other.Y < n[1] && other.Z < n[2])
          {
            meet({ x, y, z }, other);
          }
        }
      }
    }
  }
  std::vector<Pass> passes;
  passes.reserve(highest.size());
  for (const auto& [pair, height] : highest)
  {
    passes.push_back({ static_cast<std::int32_t>(pair >> 32),
      static_cast<std::int32_t>(pair & 0xffffffff), height });
  }
  return passes;
}

// Joins basins over their passes, and returns for each of them, and 0, the number of what it
// belongs to, counted from 1 in the order of their highest voxels
std::vector<std::int32_t> Join(
  const std::vector<End>& maxima, std::vector<Pass> passes, double markerHeight)
{
  std::sort(passes.begin(), passes.end(),
    [](const Pass& a, const Pass& b)
    { return std::tie(b.Height, a.A, a.B) < std::tie(a.Height, b.A, b.B); });
  std::vector<std::int32_t> into(maxima.size() + 1);
  std::iota(into.begin(), into.end(), 0);
  const auto rootOf = [&](std::int32_t basin)
  {
    while (into[basin] != basin)
    {
      into[basin] = into[into[basin]];
      basin = into[basin];
    }
    return basin;
  };
  for (const Pass& pass : passes)
  {
    std::int32_t high = rootOf(pass.A), low = rootOf(pass.B);
    const auto height = [&](std::int32_t basin) { return maxima[basin - 1].Height; };
    if (height(high) < height(low) || (height(high) == height(low) && high > low))
    {
      std::swap(high, low);
    }
    if (high != low &&
      std::sqrt(static_cast<double>(height(low))) - std::sqrt(static_cast<double>(pass.Height)) <
        markerHeight)
    {
      into[low] = high;
    }
  }
  std::vector<std::int32_t> numbers(into.size(), 0);
  std::int32_t count = 0;
  for (std::size_t n = 1; n < into.size(); ++n)
  {
    numbers[n] = into[n] == static_cast<std::int32_t>(n) ? ++count : 0;
  }
  for (std::size_t n = 1; n < into.size(); ++n)
  {
    numbers[n] = numbers[rootOf(static_cast<std::int32_t>(n))];
  }
  return numbers;
}
}

Basins FindBasins(
  VoxelSlab<std::int32_t> squaredDistances, double markerHeight, Communicator& ranks)
{
  const int first = squaredDistances.First, last = squaredDistances.Last;
  SetHalo(squaredDistances, 1, ranks);
  Streams streams(squaredDistances, first, last);
  streams.Follow();
  std::vector<End> ends = JoinEnds(streams, squaredDistances.Dimensions, ranks);
  Basins basins = { std::move(streams.Number), 0 };
  const std::vector<End> maxima = NumberMaxima(std::move(ends), basins.Number);
  SetHalo(basins.Number, 1, ranks);
  const std::vector<std::int32_t> numbers = Join(maxima,
    ranks.Concatenate(FindPasses(squaredDistances, basins.Number, first, last)), markerHeight);
  squaredDistances = {};
  SetHalo(basins.Number, 0, ranks);
  for (std::int32_t& number : basins.Number.Values)
  {
    number = numbers[number];
  }
  basins.Count = *std::max_element(numbers.begin(), numbers.end());
  return basins;
}
}
