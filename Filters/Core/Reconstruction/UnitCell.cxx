// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/UnitCell.h"

#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <algorithm>

namespace ruc
{
UnitCell FinishUnitCell(SpherePack pack, const Window& box, const TwoPointProbability& target,
  std::uint32_t seed, Communicator& ranks, const std::function<bool()>& carryOn)
{
  RemoveOverlap(pack, box, seed, carryOn);
  return MeasureUnitCell(std::move(pack), box, target, ranks);
}

UnitCell MeasureUnitCell(
  SpherePack pack, const Window& box, const TwoPointProbability& target, Communicator& ranks)
{
  // All ranks hold the cell, so one of them hands it out
  const PackShare share = SharePack(ranks.Rank() == 0 ? pack : SpherePack(), box, true, ranks);
  TwoPointProbability probability = SumPairs(share, target.Lags, ranks);
  const double objective = TwoPointDifference(target, probability);
  const PackOverlap overlap = MeasureOverlap(pack, box);
  return { std::move(pack), box, objective, 0.0, overlap, overlap, 0, EndReason::None,
    std::move(probability), {} };
}

double OverlapPercentOf(const TwoPointProbability& probability)
{
  double fraction = 0.0;
  double counted = 0.0;
  for (int r = 0; r < probability.Modes; ++r)
  {
    fraction += probability.Fractions[r];
    for (int s = 0; s < probability.Modes; ++s)
    {
      counted += probability.S(r, s)[0];
    }
  }
  return std::max(0.5 * (counted - fraction) / fraction, 0.0) * 100.0;
}
}
