// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/SumRounds.h"

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/PairSums/DirectionalProbability.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/PairSums/ProbabilityMap.h"

// Where any rank says so, all of them end without a result
TEST(SumRounds, StopOnAllRanks)
{
  const ruc::Window box = oracle::PeriodicCube(12.0);
  const ruc::SpherePack pack = oracle::RelaxedPack({ 90, 250 }, { 0.9, 0.6 }, box, 8);
  for (const int size : { 1, 3 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        int asked = 0;
        const auto stopAtThird = [&](double)
        { return ++asked < 3 || ranks.Rank() != ranks.Size() - 1; };
        const ruc::PackShare share =
          ruc::SharePack(ranks.Rank() == 0 ? pack : ruc::SpherePack(), box, true, ranks);
        EXPECT_SAYS(
          ruc::SumPairs(share, { 0.2, 20 }, ranks, stopAtThird), "stopped before its end");
        EXPECT_EQ(asked, 3);
        EXPECT_SAYS(
          ruc::MapPairs(share, { { 0, 0 } }, 0.5, 2.0, ranks, [](double) { return false; }),
          "stopped before its end");
        EXPECT_SAYS(ruc::SumPairsAlong(
                      share, { { 0, 0, 1 } }, { 0.2, 20 }, ranks, [](double) { return false; }),
          "stopped before its end");
      });
  }
}
