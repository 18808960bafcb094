// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/VoxelSlab.h"

#include "ruc/Base/Text.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ruc
{
namespace
{
struct GreyBlock
{
  VoxelBlock Block;
  std::vector<float> Values;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Block, self.Values);
  }
};

// The part of a block in the planes of a rank; planes of a block lie one after the other
GreyBlock PartOf(const VoxelBlock& block, const std::vector<float>& values, int begin, int end)
{
  const int first = std::max(block.First[2], begin);
  const int last = std::min(block.First[2] + block.Count[2], end);
  GreyBlock part = { block, {} };
  part.Block.First[2] = first;
  part.Block.Count[2] = std::max(0, last - first);
  if (part.Block.Voxels() == 0)
  {
    return {};
  }
  const auto from = values.begin() +
    static_cast<std::ptrdiff_t>(first - block.First[2]) * block.Count[0] * block.Count[1];
  part.Values.assign(from, from + static_cast<std::ptrdiff_t>(part.Block.Voxels()));
  return part;
}

void CopyInto(const GreyBlock& from, VoxelSlab<float>& slab)
{
  const float* row = from.Values.data();
  for (int z = 0; z < from.Block.Count[2]; ++z)
  {
    for (int y = 0; y < from.Block.Count[1]; ++y, row += from.Block.Count[0])
    {
      std::copy_n(row, from.Block.Count[0],
        slab.Row(from.Block.First[1] + y, from.Block.First[2] + z) + from.Block.First[0]);
    }
  }
}
}

double MostVoxels(const std::array<int, 3>& dimensions, int halo, int ranks)
{
  const Slabs planes = { dimensions[2], ranks };
  const std::int64_t held = planes.Largest() + (ranks > 1 ? 2 * halo : 0);
  return 1.0 * dimensions[0] * dimensions[1] *
    static_cast<double>(std::min<std::int64_t>(dimensions[2], held));
}

VoxelSlab<float> SpreadGrey(const VoxelBlock& block, std::vector<float> values,
  const std::array<int, 3>& dimensions, Communicator& ranks)
{
  const Slabs planes = { dimensions[2], ranks.Size() };
  VoxelSlab<float> slab = { dimensions, static_cast<int>(planes.Begin(ranks.Rank())),
    static_cast<int>(planes.End(ranks.Rank())), {} };
  if (ranks.Size() == 1 && block.Count == dimensions)
  {
    slab.Values = std::move(values);
    return slab;
  }
  std::vector<GreyBlock> outgoing;
  outgoing.reserve(ranks.Size());
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    outgoing.push_back(PartOf(
      block, values, static_cast<int>(planes.Begin(rank)), static_cast<int>(planes.End(rank))));
  }
  values = {};
  std::vector<GreyBlock> incoming = ranks.AllToAll(std::move(outgoing));
  slab.Values.assign(
    (slab.Last - slab.First) * slab.PlaneSize(), std::numeric_limits<float>::quiet_NaN());
  for (GreyBlock& part : incoming)
  {
    CopyInto(std::exchange(part, {}), slab);
  }
  std::int64_t missing = std::count_if(
    slab.Values.begin(), slab.Values.end(), [](float value) { return std::isnan(value); });
  ranks.Sum(&missing, 1);
  if (missing > 0)
  {
    throw std::invalid_argument(
      Text("The image requires a value for each of its voxels, got none for ", missing, "."));
  }
  return slab;
}
}
