// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/UnitCell.h"

#include "ruc/Packing/OverlapRemoval.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

namespace ruc
{
UnitCell FinishUnitCell(SpherePack pack, const Window& box, const TwoPointProbability& target,
  std::uint32_t seed, Communicator& ranks, const std::function<bool()>& carryOn)
{
  RemoveOverlap(pack, box, seed, carryOn);
  SpherePack sorted = pack;
  SortCanonically(sorted);
  const ExactPairSum sum(sorted, box, target.Lags);
  std::vector<std::int64_t> sums(sum.SumsSize(), 0);
  sum.AddChunks(ranks.Rank(), ranks.Size(), sums.data());
  ranks.Sum(sums.data(), sums.size());
  TwoPointProbability probability = sum.Result(sums);
  const double objective = TwoPointDifference(target, probability);
  const PackOverlap overlap = MeasureOverlap(pack, box);
  return { std::move(pack), box, objective, 0.0, overlap, 0, EndReason::None,
    std::move(probability), {} };
}
}
