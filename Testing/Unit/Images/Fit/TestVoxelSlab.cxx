// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/Fit/VoxelSlab.h"

#include "GreyScenes.h"

namespace
{
const std::array<int, 3> Dimensions = { 4, 5, 7 };

std::vector<float> Numbers()
{
  std::vector<float> numbers(4 * 5 * 7);
  std::iota(numbers.begin(), numbers.end(), 1.0f);
  return numbers;
}

// The block of voxels between two corners
std::vector<float> Cut(const ruc::VoxelBlock& block)
{
  const std::vector<float> all = Numbers();
  std::vector<float> values;
  for (int z = 0; z < block.Count[2]; ++z)
  {
    for (int y = 0; y < block.Count[1]; ++y)
    {
      for (int x = 0; x < block.Count[0]; ++x)
      {
        values.push_back(
          all[((z + block.First[2]) * 5 + y + block.First[1]) * 4 + x + block.First[0]]);
      }
    }
  }
  return values;
}
}

TEST(VoxelSlab, IsMadeOfBlocksThatOverlap)
{
  // Two halves along x that share a plane; ranks beyond have nothing, and there is one more than
  // planes
  for (int size : { 1, 2, 3, 8 })
  {
    const std::vector<float> all = oracle::Together<float>(size,
      [&](ruc::Communicator& ranks)
      {
        ruc::VoxelBlock block;
        if (size == 1)
        {
          block.Count = Dimensions;
        }
        else if (ranks.Rank() < 2)
        {
          block.First = { ranks.Rank() == 0 ? 0 : 2, 0, 0 };
          block.Count = { ranks.Rank() == 0 ? 3 : 2, 5, 7 };
        }
        return ruc::SpreadGrey(block, Cut(block), Dimensions, ranks).Values;
      });
    EXPECT_EQ(all, Numbers()) << size;
  }
}

TEST(VoxelSlab, RefusesBlocksWithAGap)
{
  ruc::Communicator one;
  ruc::VoxelBlock block;
  block.Count = { 3, 5, 7 };
  EXPECT_SAYS(ruc::SpreadGrey(block, Cut(block), Dimensions, one), "got none for 35.");
}

TEST(VoxelSlab, HoldsPlanesOfItsNeighbours)
{
  for (int size : { 1, 2, 3, 4, 8 })
  {
    for (int halo : { 0, 1, 3, 9 })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          ruc::VoxelSlab<float> slab = oracle::SlabOf(Numbers(), Dimensions, ranks);
          const int first = std::max(0, slab.First - halo), last = std::min(7, slab.Last + halo);
          ruc::SetHalo(slab, 2, ranks);
          ruc::SetHalo(slab, halo, ranks);
          const std::vector<float> all = Numbers();
          EXPECT_EQ(slab.First, size == 1 ? 0 : first);
          EXPECT_EQ(slab.Last, size == 1 ? 7 : last);
          EXPECT_EQ(slab.Values,
            std::vector<float>(all.begin() + slab.First * 20, all.begin() + slab.Last * 20));
        });
    }
  }
}

TEST(VoxelSlab, GivesBlocksToThoseWhoWantThem)
{
  for (int size : { 1, 2, 3, 8 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const ruc::VoxelSlab<float> slab = oracle::SlabOf(Numbers(), Dimensions, ranks);
        ruc::VoxelBlock block; // the first rank wants nothing, others parts that overlap
        if (size == 1 || ranks.Rank() > 0)
        {
          block.First = { 1, ranks.Rank() % 2, 1 };
          block.Count = { 3, 4, 5 };
        }
        EXPECT_EQ(ruc::TakeBlock(slab, block, ranks), Cut(block));
        block.First = { 0, 0, 0 };
        block.Count = Dimensions;
        EXPECT_EQ(ruc::TakeBlock(slab, block, ranks), Numbers());
      });
  }
}
