// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredLags.h"

#include "ruc/Statistics/Results/LagLimit.h"

ruc::LagGrid MeasuredLags::Find(double maximum, int count, const ruc::PackShare& share,
  const ruc::SamplingRegion* region, bool hasMask)
{
  const ruc::LagLimit limit = region
    ? ruc::LagLimit::ForSampling(hasMask ? region->GetShape() : share.Observed, region->GetShape())
    : ruc::LagLimit::ForPairSum(share.Observed, share.LargestRadius);
  return limit.MakeGrid(maximum, count);
}
