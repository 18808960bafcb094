// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/PhaseSlab.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace ruc
{
namespace
{
// No phase and not outside: a voxel that has not come yet
constexpr std::uint8_t Missing = 254;

// The part of a block between two planes across an axis
PhaseBlock PartOf(const PhaseBlock& own, int axis, int begin, int end)
{
  PhaseBlock part;
  part.Block = own.Block;
  const int first = std::max(own.Block.First[axis], begin);
  const int last = std::min(own.Block.First[axis] + own.Block.Count[axis], end);
  part.Block.First[axis] = first;
  part.Block.Count[axis] = std::max(0, last - first);
  if (part.Block.Voxels() == 0)
  {
    return {};
  }
  part.Phases.reserve(part.Block.Voxels());
  const std::size_t row = own.Block.Count[0];
  for (int z = 0; z < part.Block.Count[2]; ++z)
  {
    for (int y = 0; y < part.Block.Count[1]; ++y)
    {
      const int fromY = y + part.Block.First[1] - own.Block.First[1];
      const int fromZ = z + part.Block.First[2] - own.Block.First[2];
      const std::uint8_t* from =
        own.Phases.data() + (static_cast<std::size_t>(fromZ) * own.Block.Count[1] + fromY) * row;
      part.Phases.insert(part.Phases.end(), from, from + row);
    }
  }
  return part;
}

void CopyInto(const PhaseBlock& block, PhaseSlab& slab)
{
  const std::uint8_t* from = block.Phases.data();
  for (int z = 0; z < block.Block.Count[2]; ++z)
  {
    for (int y = 0; y < block.Block.Count[1]; ++y, from += block.Block.Count[0])
    {
      const int place[2] = { block.Block.First[1] + y, block.Block.First[2] + z };
      std::copy_n(from, block.Block.Count[0],
        slab.Row(place[slab.Axis - 1], place[2 - slab.Axis]) + block.Block.First[0]);
    }
  }
}
}

PhaseSlab SpreadPhases(
  const PhaseBlock& own, const std::array<int, 3>& dimensions, int axis, Communicator& ranks)
{
  PhaseSlab slab = { axis, dimensions, { dimensions[axis], ranks.Size() }, ranks.Rank(), {} };
  std::vector<PhaseBlock> outgoing;
  for (int rank = 0; rank < ranks.Size(); ++rank)
  {
    outgoing.push_back(PartOf(own, axis, static_cast<int>(slab.Planes.Begin(rank)),
      static_cast<int>(slab.Planes.End(rank))));
  }
  std::vector<PhaseBlock> incoming = ranks.AllToAll(std::move(outgoing));
  slab.Phases.assign(static_cast<std::size_t>(slab.End() - slab.Begin()) * slab.Rows() *
      static_cast<std::size_t>(dimensions[0]),
    Missing);
  for (PhaseBlock& block : incoming)
  {
    CopyInto(std::exchange(block, {}), slab);
  }
  std::int64_t missing = std::count(slab.Phases.begin(), slab.Phases.end(), Missing);
  ranks.Sum(&missing, 1);
  if (missing > 0)
  {
    throw std::invalid_argument(
      Text("The image requires a value for each of its voxels, got none for ", missing, "."));
  }
  return slab;
}

PhaseSlab CutAcross(const PhaseSlab& image, int axis, Communicator& ranks)
{
  PhaseBlock own;
  own.Block.Count = image.Dimensions;
  own.Block.First[image.Axis] = image.Begin();
  own.Block.Count[image.Axis] = image.End() - image.Begin();
  own.Phases.reserve(image.Phases.size());
  for (int z = 0; z < own.Block.Count[2]; ++z)
  {
    for (int y = 0; y < own.Block.Count[1]; ++y)
    {
      const int place[2] = { own.Block.First[1] + y, own.Block.First[2] + z };
      const std::uint8_t* row = image.Row(place[image.Axis - 1], place[2 - image.Axis]);
      own.Phases.insert(own.Phases.end(), row, row + image.Dimensions[0]);
    }
  }
  return SpreadPhases(own, image.Dimensions, axis, ranks);
}
}
