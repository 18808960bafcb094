// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TwoPointSum.h"

#include "ProgressReport.h"
#include "RankCommunicator.h"

ruc::TwoPointProbability TwoPointSum::Compute(const ruc::PackShare& pack, const ruc::LagGrid& lags,
  RankCommunicator& ranks, ProgressReport& report)
{
  const ruc::ExactPairSum sum(pack, lags, ranks);
  std::vector<std::int64_t> sums(sum.SumsSize(), 0);
  sum.AddChunks(0, 1, sums.data(),
    [&](double done)
    {
      if (ranks.Rank() == 0)
      {
        report.Tell(done, "summing pairs");
      }
    });
  ranks.Sum(sums.data(), sums.size());
  return sum.Result(sums);
}
