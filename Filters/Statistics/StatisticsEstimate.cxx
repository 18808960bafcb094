// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StatisticsEstimate.h"

#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include <limits>

ruc::LagGrid StatisticsEstimate::FindLags(
  double maximum, int count, const ruc::PackFigures& pack, bool exact)
{
  const ruc::LagLimit limit = exact
    ? ruc::LagLimit::ForPairSum(pack.Observed, pack.LargestRadius)
    : ruc::LagLimit::ForSampling(pack.Observed, pack.Observed.Shrunk(pack.LargestRadius));
  return limit.MakeGrid(maximum, count);
}

ruc::Estimate StatisticsEstimate::OfPack(
  const ruc::PackFigures& pack, double maximum, const ruc::LagGrid& lags)
{
  ruc::Estimate estimate = ruc::EstimatePack(pack);
  if (maximum == 0.0)
  {
    estimate.Automatic = ruc::Text("Maximum Lag ", lags.Maximum());
  }
  return estimate;
}

ruc::Estimate StatisticsEstimate::OfTables(const ruc::PackFigures& pack, int tables)
{
  constexpr double secondsPerColumn = 6e-5; // for its range and name
  const double phases = pack.Modes + 1.0;
  return { tables * 0.5 * phases * (phases + 1.0) * secondsPerColumn, 0.0, 0.0 };
}

std::optional<double> StatisticsEstimate::NumberOfSamples(const ruc::SamplingSettings& settings)
{
  if (settings.Samples < 1)
  {
    return {};
  }
  if (settings.TargetError > 0.0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return static_cast<double>(settings.Samples);
}
