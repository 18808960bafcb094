// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/FanSampling.h"

#include "Oracles.h"
#include "SampledComparison.h"
#include "Statistics/Sampling/FanMedia.h"

// mallinfo2 counts nothing that a sanitizer hands out, and Clang does not say that one is at work
#if defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define COUNTS_MEMORY
#include <malloc.h>
#endif

namespace
{
using namespace fans;
}

TEST(FanSampling, RanksAndThreadsGiveEqualResults)
{
  const ThreePointGrid grid = { { 0.4, 4 }, 8 };
  const std::vector<PhaseTriple> triples = { { 0, 0, 0 }, { 1, 2, 0 }, { 2, 2, 2 } };
  const std::vector<Medium> media = Media();
  for (const Medium& medium : { media[0], media[1], media[4] })
  {
    // 200 throws are 50 batches, which 3 ranks cannot share evenly
    ExpectEqualForRanksAndThreads(medium.Pack,
      [&](const SpherePack& own, ruc::Communicator& ranks)
      {
        const ThreePointProbability sampled =
          ruc::SampleFans(own, 2, medium.Region, grid, triples, { 5, 200, true }, ranks);
        // As numbers to compare; of those that are none only that
        std::vector<double> numbers;
        const auto add = [&](double number)
        { numbers.push_back(std::isnan(number) ? -99.0 : number); };
        for (std::size_t n = 0; n < triples.size(); ++n)
        {
          ForEachPlace(grid,
            [&](int k1, int k2, int t)
            {
              add(sampled.Value(n, k1, k2, t));
              add(sampled.Error(n, k1, k2, t));
            });
          if (n != 1)
          {
            add(sampled.ThirdOrder(n).Zeta);
            add(sampled.ThirdOrder(n).Eta);
            add(sampled.ThirdOrderError(n).Zeta);
            add(sampled.ThirdOrderError(n).Eta);
          }
        }
        EXPECT_GT(*std::max_element(numbers.begin(), numbers.end()), 0.3);
        ruc::SampledTwoPoint result = { { 1, { 1.0, 1 } }, {}, {}, {}, sampled.GetThrows(), 0.0 };
        result.Mean.Values = { numbers };
        return result;
      });
  }
}

TEST(FanSampling, FewerBatchesThanRanks)
{
  const Medium medium = Media()[0];
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  const FanSettings settings = { 5, 2, true };
  const ThreePointProbability expected =
    Fans(medium.Pack, 2, medium.Region, grid, Triples, settings);
  oracle::ThreadRanks::Run(5,
    [&](ruc::Communicator& ranks)
    {
      const ThreePointProbability sampled =
        ruc::SampleFans(oracle::PieceOf(medium.Pack, ranks.Rank(), 5, false), 2, medium.Region,
          grid, Triples, settings, ranks);
      for (std::size_t n = 0; n < Triples.size(); ++n)
      {
        ForEachPlace(grid,
          [&](int k1, int k2, int t)
          {
            const std::size_t place = grid.PlaceOf(k1, k2, t);
            ExpectSame(
              sampled.Value(n, k1, k2, t), expected.Value(n, k1, k2, t), "value", n, place);
            ExpectSame(
              sampled.Error(n, k1, k2, t), expected.Error(n, k1, k2, t), "error", n, place);
          });
      }
    });
}

TEST(FanSampling, ReportsItsProgress)
{
  const Medium medium = Media()[0];
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  ruc::Communicator serial;
  std::vector<double> done;
  std::string last;
  ruc::SampleFans(medium.Pack, 2, medium.Region, grid, { { 0, 0, 0 } }, { 1, 500, false }, serial,
    [&](double share, const std::string& text)
    {
      done.push_back(share);
      last = text;
      return true;
    });
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  ASSERT_GT(done.size(), 10u);
  EXPECT_GT(done.front(), 0.0);
  EXPECT_EQ(done.back(), 1.0);
  EXPECT_EQ(last, "500 throws");
}

TEST(FanSampling, StopsWithTheThrowsTakenSoFar)
{
  // 16 throws are 16 batches of one, and so are 6.
  const Medium medium = Media()[0];
  const ThreePointGrid grid = { { 0.4, 3 }, 8 };
  for (int size : { 1, 2 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        const SpherePack own = oracle::PieceOf(medium.Pack, ranks.Rank(), ranks.Size(), false);
        const ThreePointProbability stopped = ruc::SampleFans(own, 2, medium.Region, grid,
          { { 0, 0, 0 } }, { 1, 16, false }, ranks,
          [&](double share, const std::string&) { return ranks.Rank() > 0 || share < 6.0 / 16.0; });
        const ThreePointProbability expected =
          ruc::SampleFans(own, 2, medium.Region, grid, { { 0, 0, 0 } }, { 1, 6, false }, ranks);
        EXPECT_EQ(stopped.GetThrows(), 6);
        for (int k = 0; k <= grid.Lags.Count; ++k)
        {
          EXPECT_EQ(stopped.Value(0, k, 1, 2), expected.Value(0, k, 1, 2));
        }
        EXPECT_EQ(stopped.ThirdOrder(0).Zeta, expected.ThirdOrder(0).Zeta);
      });
  }
}

#ifdef COUNTS_MEMORY
TEST(FanSampling, TakesTheMemoryItSays)
{
  const OneThread alone; // whose blocks alone are counted
  const auto taken = []()
  {
    const struct mallinfo2 info = ::mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
  };
  const std::vector<Medium> media = Media();
  const ThreePointGrid grid = { { 0.02, 70 }, 12 };
  for (const Medium& medium : { media[0], media[2] })
  {
    const bool bounded = !medium.Region.IsFullyPeriodic();
    for (const bool withErrors : { false, true })
    {
      std::vector<double> most;
      for (const std::int64_t throws : { 1000, 2000 })
      {
        ruc::Communicator serial;
        const double before = taken();
        most.push_back(0.0);
        const ThreePointProbability sampled = ruc::SampleFans(medium.Pack, 2, medium.Region, grid,
          Triples, { 1, throws, withErrors }, serial,
          [&](double, const std::string&)
          {
            most.back() = std::max(most.back(), taken() - before);
            return true;
          });
        // Two of the seven triples are another one with s and q swapped, and not counted again. The
        // rest is for the cells of the pack and up to 125 throws of 12 rays in hand, 3 kB each.
        const double estimate = ruc::EstimateFanMemory(grid, 5, withErrors, bounded);
        EXPECT_LE(most.back(), estimate + 125 * 3e3) << medium.Name << withErrors;
        EXPECT_GE(most.back(), estimate) << medium.Name << withErrors;
        // The result keeps the sums, without the batches
        EXPECT_LE(taken() - before, most.back());
        EXPECT_GE(taken() - before, 0.6 * estimate);
      }
      EXPECT_NEAR(most[0], most[1], 2e5);
    }
  }
}
#endif

TEST(FanSampling, MemoryEstimate)
{
  // 32 bits a place and triple for a batch, 64 for each sum: of N, and with errors of N^2 and N D;
  // in a region with a border of D, and with errors of D^2
  const ThreePointGrid grid = { { 0.1, 9 }, 20 };
  const double places = 10.0 * 10.0 * 11.0;
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 1, false, false), 12.0 * places);
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 5, true, false), 5.0 * 28.0 * places);
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 5, false, true), (5.0 * 12.0 + 12.0) * places);
  EXPECT_DOUBLE_EQ(ruc::EstimateFanMemory(grid, 5, true, true), (5.0 * 28.0 + 20.0) * places);
}
