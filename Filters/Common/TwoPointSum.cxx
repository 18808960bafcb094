// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TwoPointSum.h"

#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

ruc::LagGrid TwoPointSum::MakeLags(double maximum, int count, double automatic)
{
  if (!(std::isfinite(maximum) && maximum >= 0.0))
  {
    throw std::invalid_argument(
      ruc::Text("MaximumLag requires a finite number >= 0 (0: automatic), got ", maximum, "."));
  }
  // ruc::ExactPairSum asks the same, but only after the division
  if (count < 1 || count > ruc::MostLags)
  {
    throw std::invalid_argument(ruc::Text(
      "NumberOfLags requires 1 <= NumberOfLags <= ", ruc::MostLags, ", got ", count, "."));
  }
  return { (maximum > 0.0 ? maximum : automatic) / count, count };
}

double TwoPointSum::AutomaticLag(const ruc::PackShare& pack)
{
  return std::min(0.5 * pack.Observed.ShortestEdge(),
    ruc::ExactPairSum::LargestLag(pack.LargestRadius, pack.Observed));
}

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
        report.Update(done, "summing pairs");
      }
    });
  ranks.Sum(sums.data(), sums.size());
  return sum.Result(sums);
}
