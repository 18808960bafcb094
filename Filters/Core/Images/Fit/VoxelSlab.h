// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Images/Slabs.h"
#include "ruc/Images/VoxelGrid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace ruc
{
/** Planes of an image, with their values, x running fastest. */
template <class Value>
struct VoxelPlanes
{
  int First = 0;
  std::vector<Value> Values;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.First, self.Values);
  }
};

/**
 * The planes of an image, cut across z, that a rank holds: its own, and with a halo some planes of
 * its neighbours as well.
 */
template <class Value>
struct VoxelSlab
{
  std::array<int, 3> Dimensions{}; // of the whole image
  int First = 0, Last = 0;         // the planes; Last is not one of them
  std::vector<Value> Values;

  std::size_t PlaneSize() const
  {
    return static_cast<std::size_t>(this->Dimensions[0]) * this->Dimensions[1];
  }
  Value* Row(int y, int z) { return this->Values.data() + this->PlaceOf(y, z); }
  const Value* Row(int y, int z) const { return this->Values.data() + this->PlaceOf(y, z); }

private:
  std::size_t PlaceOf(int y, int z) const
  {
    return (static_cast<std::size_t>(z - this->First) * this->Dimensions[1] + y) *
      this->Dimensions[0];
  }
};

/**
 * Changes which planes the ranks hold: to their own, those of Slabs, and `halo` planes on either
 * side, as far as the image has them. Before, every rank must hold its own planes. Collective.
 */
template <class Value>
void SetHalo(VoxelSlab<Value>& slab, int halo, Communicator& ranks)
{
  const Slabs planes = { slab.Dimensions[2], ranks.Size() };
  const auto first = [&](int rank)
  { return static_cast<int>(std::max<std::int64_t>(0, planes.Begin(rank) - halo)); };
  const auto last = [&](int rank)
  { return static_cast<int>(std::min<std::int64_t>(planes.Count, planes.End(rank) + halo)); };
  if (ranks.Size() == 1)
  {
    return;
  }
  // Own planes go to whoever wants them
  const int begin = static_cast<int>(planes.Begin(ranks.Rank()));
  const int end = static_cast<int>(planes.End(ranks.Rank()));
  const auto place = [&](int plane)
  { return slab.Values.begin() + (plane - slab.First) * slab.PlaneSize(); };
  std::vector<VoxelPlanes<Value>> outgoing(ranks.Size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    const int from = std::max(begin, first(rank)), to = std::min(end, last(rank));
    if (rank != ranks.Rank() && from < to)
    {
      outgoing[rank] = { from, std::vector<Value>(place(from), place(to)) };
    }
  }
  VoxelSlab<Value> widened = { slab.Dimensions, first(ranks.Rank()), last(ranks.Rank()), {} };
  widened.Values.resize((widened.Last - widened.First) * slab.PlaneSize());
  const auto copy = [&](int plane, auto from, auto to)
  { std::copy(from, to, widened.Values.begin() + (plane - widened.First) * slab.PlaneSize()); };
  if (begin < end)
  {
    copy(begin, place(begin), place(end));
  }
  slab.Values = {};
  for (VoxelPlanes<Value>& part : ranks.AllToAll(std::move(outgoing)))
  {
    copy(part.First, part.Values.begin(), part.Values.end());
    part.Values = {};
  }
  slab = std::move(widened);
}

/**
 * Returns the values of a block of the image, which this rank wants, from the planes that are the
 * ranks' own; the slab has no halo. Collective.
 */
template <class Value>
std::vector<Value> TakeBlock(VoxelSlab<Value> slab, const VoxelBlock& wanted, Communicator& ranks)
{
  if (ranks.Size() == 1 && wanted.Count == slab.Dimensions)
  {
    return std::move(slab.Values);
  }
  std::vector<std::vector<Value>> outgoing;
  for (const VoxelBlock& block : ranks.AllGather(wanted))
  {
    std::vector<Value>& part = outgoing.emplace_back();
    for (int z = std::max(slab.First, block.First[2]);
         z < std::min(slab.Last, block.First[2] + block.Count[2]); ++z)
    {
      for (int y = block.First[1]; y < block.First[1] + block.Count[1]; ++y)
      {
        const Value* row = slab.Row(y, z) + block.First[0];
        part.insert(part.end(), row, row + block.Count[0]);
      }
    }
  }
  slab.Values = {};
  std::vector<Value> values;
  for (std::vector<Value>& part : ranks.AllToAll(std::move(outgoing)))
  {
    values.insert(values.end(), part.begin(), part.end()); // ranks have planes in their order
    part = {};
  }
  return values;
}

/** The most voxels that a rank holds of an image, with a halo. */
double MostVoxels(const std::array<int, 3>& dimensions, int halo, int ranks);

/**
 * Returns this rank's own planes of an image of which the ranks have blocks that begin at voxel
 * 0 0 0. Blocks may overlap, as those of points do; the values in the overlap are the same in both.
 * Throws std::invalid_argument, the same on every rank, where voxels are in no block. Collective.
 */
VoxelSlab<float> SpreadGrey(const VoxelBlock& block, std::vector<float> values,
  const std::array<int, 3>& dimensions, Communicator& ranks);
}
