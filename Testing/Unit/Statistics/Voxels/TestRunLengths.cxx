// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Voxels/RunLengths.h"

#include "TestImages.h"
#include "ThreadRanks.h"

#include <numeric>

namespace
{
using oracle::PhaseImage;
using oracle::Triple;
using ruc::RunCounts;

bool Same(const RunCounts& a, const RunCounts& b)
{
  return a.Runs == b.Runs && a.Chords == b.Chords && a.Inside == b.Inside &&
    a.Endless == b.Endless && a.EndlessInside == b.EndlessInside && a.Starts == b.Starts;
}

// Whether the j + 1 voxels from a place on, along an axis, all meet a condition
template <class Condition>
bool AllAlong(
  const PhaseImage& image, Triple place, int axis, int j, bool periodic, Condition&& condition)
{
  for (int n = 0; n <= j; ++n, ++place[axis])
  {
    if (place[axis] >= image.Dimensions[axis])
    {
      if (!periodic)
      {
        return false;
      }
      place[axis] -= image.Dimensions[axis];
    }
    if (!condition(image.At(place[0], place[1], place[2])))
    {
      return false;
    }
  }
  return true;
}

template <class Visit>
void ForVoxels(const PhaseImage& image, Visit&& visit)
{
  for (int z = 0; z < image.Dimensions[2]; ++z)
  {
    for (int y = 0; y < image.Dimensions[1]; ++y)
    {
      for (int x = 0; x < image.Dimensions[0]; ++x)
      {
        visit(Triple{ x, y, z });
      }
    }
  }
}
}

TEST(RunLengths, TheLinealPathIsThatOfItsDefinition)
{
  for (bool periodic : { false, true })
  {
    for (bool masked : { false, true })
    {
      const PhaseImage image = oracle::RandomImage({ 9, 7, 8 }, 2, masked, 3);
      ruc::Communicator ranks;
      const auto runs =
        ruc::CountRuns(image.Spread(ranks), 2, { periodic, periodic, periodic }, ranks);
      const ruc::ChordLengths chords =
        ruc::ChordsOfRuns(runs, { 1, 1, 1 }, 1.0, 5, { 0.5, 0.5 }, { 1.0, 1.0 });
      for (int r = 0; r < 2; ++r)
      {
        for (int j = 0; j <= 5; ++j)
        {
          long in = 0, all = 0;
          ForVoxels(image,
            [&](const Triple& place)
            {
              for (int axis = 0; axis < 3; ++axis)
              {
                in +=
                  AllAlong(image, place, axis, j, periodic, [&](int phase) { return phase == r; });
                all += AllAlong(image, place, axis, j, periodic,
                  [&](int phase) { return phase != ruc::OutsideMask; });
              }
            });
          EXPECT_DOUBLE_EQ(chords.LinealPath[r][j], double(in) / all)
            << periodic << masked << r << j;
        }
      }
      EXPECT_EQ(chords.MeanChord[0], 2.0);
    }
  }
}

TEST(RunLengths, CutRunsAreNoChords)
{
  // Two lines: 0 0 1 1 1 0 | 1 0 0 1 0 0
  const PhaseImage image = { { 6, 2, 1 }, { 0, 0, 1, 1, 1, 0, 1, 0, 0, 1, 0, 0 } };
  ruc::Communicator ranks;
  const RunCounts window =
    ruc::CountRuns(image.Spread(ranks), 2, { false, false, false }, ranks)[0];
  EXPECT_EQ(window.Chords[0], (std::vector<std::int64_t>{ 0, 0, 1, 0, 0, 0, 0 }));
  EXPECT_EQ(window.Chords[1], (std::vector<std::int64_t>{ 0, 1, 0, 1, 0, 0, 0 }));
  EXPECT_EQ(window.Runs[0], (std::vector<std::int64_t>{ 0, 1, 3, 0, 0, 0, 0 }));
  EXPECT_EQ(window.Inside[6], 2);
  const RunCounts periodic = ruc::CountRuns(image.Spread(ranks), 2, { true, true, true }, ranks)[0];
  EXPECT_EQ(periodic.Chords[0], (std::vector<std::int64_t>{ 0, 0, 2, 1, 0, 0, 0 }));
  EXPECT_EQ(periodic.Chords[1], (std::vector<std::int64_t>{ 0, 2, 0, 1, 0, 0, 0 }));
  EXPECT_EQ(periodic.EndlessInside, 12);
}

TEST(RunLengths, DensityOfALayeredImageIsOne)
{
  // Layers of 2 and 3 voxels across x: along x every chord has 2 or 3 voxels, elsewhere there is
  // none
  PhaseImage image = { { 50, 6, 6 }, {} };
  for (int n = 0; n < 50 * 36; ++n)
  {
    image.Phases.push_back(n % 50 % 5 < 2 ? 0 : 1);
  }
  ruc::Communicator ranks;
  const auto runs = ruc::CountRuns(image.Spread(ranks), 2, { true, true, true }, ranks);
  const ruc::ChordLengths chords =
    ruc::ChordsOfRuns(runs, { 0.5, 0.5, 0.5 }, 0.5, 4, { 0.4, 0.6 }, { 1.0, 1.0 });
  for (int r = 0; r < 2; ++r)
  {
    for (int k = 0; k <= 4; ++k)
    {
      EXPECT_NEAR(chords.Density[r][k], k == 2 + r ? 1.0 / 0.5 : 0.0, 1e-14) << r << k;
    }
  }
}

TEST(RunLengths, AreEqualForAnyNumberOfRanks)
{
  const PhaseImage image = oracle::RandomImage({ 7, 11, 5 }, 4, true, 9);
  ruc::Communicator serial;
  const auto expected = ruc::CountRuns(image.Spread(serial), 4, { true, false, true }, serial);
  for (int size : { 2, 3, 4, 7 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const auto found = ruc::CountRuns(image.Spread(ranks), 4, { true, false, true }, ranks);
        for (int q = 0; q < 3; ++q)
        {
          EXPECT_TRUE(Same(found[q], expected[q])) << size << ' ' << q;
        }
      });
  }
}

TEST(PhaseSlab, HasTheVoxelsOfTheImage)
{
  const PhaseImage image = oracle::RandomImage({ 5, 6, 7 }, 4, true, 4);
  for (int size : { 1, 2, 4 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        for (int axis : { 1, 2 })
        {
          const ruc::PhaseSlab slab = image.Spread(ranks, axis);
          for (int plane = slab.Begin(); plane < slab.End(); ++plane)
          {
            for (int row = 0; row < slab.Rows(); ++row)
            {
              for (int x = 0; x < 5; ++x)
              {
                EXPECT_EQ(slab.Row(plane, row)[x],
                  axis == 2 ? image.At(x, row, plane) : image.At(x, plane, row));
              }
            }
          }
          EXPECT_EQ(
            ruc::CutAcross(slab, 3 - axis, ranks).Phases, image.Spread(ranks, 3 - axis).Phases);
        }
      });
  }
}

TEST(PhaseSlab, RefusesGaps)
{
  ruc::Communicator ranks;
  ruc::PhaseBlock block;
  block.Block = { { 0, 0, 0 }, { 2, 2, 1 } };
  block.Phases.assign(4, 0);
  EXPECT_SAYS(ruc::SpreadPhases(block, { 2, 2, 2 }, 2, ranks),
    "a value for each of its voxels, got none for 4");
}
