// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/VoxelMask.h"

#include "Images/Fit/GreyScenes.h"
#include "ruc/Images/MaskErosion.h"

namespace
{
using ruc::Vector3;
using ruc::VoxelMask;

std::vector<std::uint8_t> RandomVoxels(std::size_t count, double share, std::uint64_t seed)
{
  oracle::Uniform random(seed);
  std::vector<std::uint8_t> inside(count);
  for (std::uint8_t& voxel : inside)
  {
    voxel = random() < share;
  }
  return inside;
}

std::vector<std::uint8_t> InsideOf(const VoxelMask& mask)
{
  const std::array<int, 3>& n = mask.GetDimensions();
  std::vector<std::uint8_t> inside(std::size_t(n[0]) * n[1] * n[2], 0);
  for (std::size_t voxel : mask.InsideVoxels())
  {
    inside[voxel] = 1;
  }
  return inside;
}
}

TEST(VoxelMask, RefusesBadInput)
{
  const std::vector<std::uint8_t> eight(8, 1);
  EXPECT_SAYS(VoxelMask({ 2, 0, 2 }, { 0, 0, 0 }, { 1, 1, 1 }, eight),
    "Mask requires three dimensions >= 1, got 2 0 2.");
  EXPECT_SAYS(
    VoxelMask({ 2, 2, 2 }, { 0, 0, 0 }, { 1, 0, 1 }, eight), "finite spacings > 0, got 0 0 0 and");
  EXPECT_SAYS(VoxelMask({ 2, 2, 2 }, { 0, NAN, 0 }, { 1, 1, 1 }, eight), "a finite origin");
  EXPECT_SAYS(
    VoxelMask({ 2, 2, 3 }, { 0, 0, 0 }, { 1, 1, 1 }, eight), "Mask requires 12 voxels, got 8.");
  EXPECT_SAYS(VoxelMask({ 2, 2, 2 }, { 0, 0, 0 }, { 1, 1, 1 }, std::vector<std::uint8_t>(8, 0)),
    "Mask requires at least one inside voxel, got none.");
  EXPECT_SAYS(VoxelMask({ 2, 2, 2 }, { 0, 0, 0 }, { 1, 1, 1 }, eight).Eroded(1.5),
    "at least 1.5 from every outside one");
}

TEST(VoxelMask, KnowsItsVoxels)
{
  std::vector<std::uint8_t> inside(3 * 4 * 5, 0);
  inside[1 + 3 * (2 + 4 * 3)] = 255;
  inside[2 + 3 * (2 + 4 * 1)] = 1;
  const VoxelMask mask({ 3, 4, 5 }, { -1, 0, 2 }, { 0.5, 1, 2 }, inside);
  EXPECT_DOUBLE_EQ(mask.Volume(), 2.0);
  EXPECT_EQ(mask.GetBounds().Origin, (Vector3{ -0.5, 2, 4 }));
  EXPECT_EQ(mask.GetBounds().Size, (Vector3{ 1, 1, 6 }));
  EXPECT_TRUE(mask.Contains({ -0.25, 2.5, 9.0 }));
  EXPECT_FALSE(mask.Contains({ -0.25, 2.5, 7.9 }));
  EXPECT_FALSE(mask.Contains({ -0.25, 2.5, 12.1 }));
  EXPECT_FALSE(mask.Contains({ -1e30, NAN, 0 }));
}

TEST(VoxelMask, ABoxShrinksByWholeVoxels)
{
  for (int layers : { 0, 1, 2 })
  {
    // A margin of 0.1 layers is not a multiple of 0.1 in binary, which the tolerance has to take up
    const VoxelMask eroded = VoxelMask(
      { 7, 8, 9 }, { 0, 0, 0 }, { 0.1, 0.1, 0.1 }, std::vector<std::uint8_t>(7 * 8 * 9, 1))
                               .Eroded(0.1 * layers);
    EXPECT_EQ(eroded.InsideVoxels().size(),
      std::size_t((7 - 2 * layers) * (8 - 2 * layers) * (9 - 2 * layers)));
    for (int q = 0; q < 3; ++q)
    {
      EXPECT_NEAR(eroded.GetBounds().Origin[q], 0.1 * layers, 1e-12);
    }
  }
}

TEST(VoxelMask, ErosionIsThatOfBruteForce)
{
  const std::array<int, 3> n = { 9, 7, 8 };
  const Vector3 spacing = { 1.0, 1.5, 0.7 };
  const VoxelMask mask(n, { 0, 0, 0 }, spacing, RandomVoxels(9 * 7 * 8, 0.985, 4));
  for (double margin : { 0.3, 0.7, 1.0, 1.3, 1.9 })
  {
    // All voxels of the image and of a layer around it, as boxes
    const std::vector<std::uint8_t> inside = InsideOf(mask);
    std::vector<std::uint8_t> expected = inside;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      const int at[3] = { int(i % n[0]), int(i / n[0] % n[1]), int(i / n[0] / n[1]) };
      for (int z = -1; z <= n[2]; ++z)
      {
        for (int y = -1; y <= n[1]; ++y)
        {
          for (int x = -1; x <= n[0]; ++x)
          {
            const bool image = x >= 0 && y >= 0 && z >= 0 && x < n[0] && y < n[1] && z < n[2];
            if (image && inside[x + n[0] * (y + n[1] * z)])
            {
              continue;
            }
            const int other[3] = { x, y, z };
            double distance2 = 0.0;
            for (int q = 0; q < 3; ++q)
            {
              const double gap = std::max(std::abs(at[q] - other[q]) - 1, 0) * spacing[q];
              distance2 += gap * gap;
            }
            if (std::sqrt(distance2) < margin * (1.0 - 1e-9))
            {
              expected[i] = 0;
            }
          }
        }
      }
    }
    EXPECT_EQ(InsideOf(mask.Eroded(margin)), expected) << margin;
  }
}

TEST(VoxelMask, IsTheSameFromPlanesOnAnyNumberOfRanks)
{
  // Rows that end inside, planes that end within a rank's halo, and ranks without any
  const ruc::VoxelGrid grid = { { 19, 13, 11 }, { 1, 2, 3 }, { 1.0, 1.5, 0.7 } };
  const std::vector<std::uint8_t> inside = RandomVoxels(19 * 13 * 11, 0.995, 5);
  const VoxelMask whole(grid.Dimensions, grid.Lower, grid.Spacing, inside);
  EXPECT_EQ(InsideOf(whole), inside);
  for (double margin : { 0.0, 0.7, 1.3, 2.1 })
  {
    const VoxelMask eroded = whole.Eroded(margin);
    for (int size : { 2, 3, 4, 12 })
    {
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          const auto slab = ruc::ErodeMask(
            oracle::SlabOf(inside, grid.Dimensions, ranks), grid.Spacing, margin, ranks);
          const VoxelMask together = VoxelMask::Gather(grid, slab, ranks);
          EXPECT_EQ(together.InsideVoxels(), eroded.InsideVoxels()) << margin << " " << size;
          EXPECT_EQ(together.GetBounds().Origin, eroded.GetBounds().Origin);
          EXPECT_EQ(together.GetBounds().Size, eroded.GetBounds().Size);
          EXPECT_EQ(together.Volume(), eroded.Volume());
        });
    }
  }
  oracle::ThreadRanks::Run(2,
    [&](ruc::Communicator& ranks)
    {
      EXPECT_SAYS(
        ruc::ErodeMask(oracle::SlabOf(inside, grid.Dimensions, ranks), grid.Spacing, 40.0, ranks),
        "at least 40 from every outside one");
    });
}

TEST(VoxelMask, LinesAreCutWherePointsLeaveIt)
{
  const VoxelMask mask(
    { 6, 5, 4 }, { -1, 2, 0.5 }, { 0.5, 1.0, 0.8 }, RandomVoxels(6 * 5 * 4, 0.6, 9));
  oracle::Uniform random(3);
  std::vector<ruc::LineInterval> intervals;
  for (int line = 0; line < 300; ++line)
  {
    const Vector3 start = { random(-4, 5), random(0, 9), random(-2, 6) };
    Vector3 direction = random.Direction();
    if (line % 5 == 0)
    {
      direction = { 0, 0, 0 }; // along an axis
      direction[line % 3] = line % 2 ? 1 : -1;
    }
    const double length = random(0, 12);
    mask.Intersect(start, direction, length, intervals);
    for (std::size_t n = 0; n < intervals.size(); ++n)
    {
      EXPECT_LT(intervals[n].Begin, intervals[n].End);
      EXPECT_GE(intervals[n].Begin, n == 0 ? 0.0 : std::nextafter(intervals[n - 1].End, 1e9));
      EXPECT_LE(intervals[n].End, length);
    }
    for (int k = 0; k < 400; ++k)
    {
      const double t = random(0, length);
      bool found = false, near = false;
      for (const ruc::LineInterval& interval : intervals)
      {
        found = found || (interval.Begin <= t && t <= interval.End);
        near = near || std::abs(t - interval.Begin) < 1e-9 || std::abs(t - interval.End) < 1e-9;
      }
      const Vector3 point = { start[0] + t * direction[0], start[1] + t * direction[1],
        start[2] + t * direction[2] };
      EXPECT_TRUE(near || found == mask.Contains(point)) << line << " " << t;
    }
  }
}
