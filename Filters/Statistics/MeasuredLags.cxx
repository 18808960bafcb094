// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredLags.h"

#include "TwoPointSum.h"

#include <algorithm>

ruc::LagGrid MeasuredLags::Find(double maximum, int count, const ruc::PackShare& share,
  const ruc::SamplingRegion* region, bool hasMask)
{
  if (!region)
  {
    return TwoPointSum::MakeLags(maximum, count, TwoPointSum::AutomaticLag(share));
  }
  const double edge = (hasMask ? region->GetBounds() : share.Observed).ShortestEdge();
  return TwoPointSum::MakeLags(maximum, count, std::min(0.5 * edge, region->LargestLag()));
}
