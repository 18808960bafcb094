// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TwoPointSum.h"

#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "Text.h"

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

double TwoPointSum::AutomaticLag(const PackData::ObservedPack& observed)
{
  return std::min(0.5 * observed.Observed.ShortestEdge(),
    ruc::ExactPairSum::LargestLag(observed.Pack, observed.Observed));
}

ruc::TwoPointProbability TwoPointSum::Compute(const PackData::ObservedPack& observed,
  const ruc::LagGrid& lags, RankCommunicator& ranks, ProgressReport& report)
{
  const ruc::ExactPairSum sum(observed.Pack, observed.Observed, lags);
  std::vector<std::int64_t> sums(sum.SumsSize(), 0);
  sum.AddChunks(ranks.Rank(), ranks.Size(), sums.data(),
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

double TwoPointSum::MeanDiameter(const ruc::SpherePack& pack)
{
  double cubes = 0.0;
  for (double radius : pack.Radius)
  {
    cubes += radius * radius * radius;
  }
  return 2.0 * std::cbrt(cubes / pack.Size());
}
