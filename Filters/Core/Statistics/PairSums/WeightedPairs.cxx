// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/WeightedPairs.h"

#include "ruc/Base/FixedPointSums.h"
#include "ruc/Base/Text.h"

namespace ruc
{
WeightedPairs::WeightedPairs(const PackShare& share, const SizeClasses& classes,
  Communicator& ranks, const char* property, double cube, double rim)
  : Pairs(share, classes, ranks)
  , Observed(share.Observed)
  , Cube(cube)
  , Rim(rim)
  , Volume(share.Observed.Volume())
  , Periodic(share.Observed.IsFullyPeriodic())
  , Spheres(share.NumberOfSpheres)
{
  double heaviest = 1.0;
  if (!this->Periodic)
  {
    const std::int64_t centres = static_cast<std::int64_t>(this->Pairs.Size());
#pragma omp parallel for schedule(dynamic, 64) reduction(max : heaviest)
    for (std::int64_t i = 0; i < centres; ++i)
    {
      this->ForEach(i, i + 1,
        [&](std::size_t, const PairNeighbourhood::Part&, std::size_t, const Vector3&, double,
          double weight) { heaviest = std::max(heaviest, weight); });
    }
    heaviest = -heaviest;
    ranks.Minimum(&heaviest, 1);
    heaviest = -heaviest;
  }
  this->FindScale(heaviest, ranks, property);
}

WeightedPairs::WeightedPairs(const PackShare& share, const SizeClasses& classes, double heaviest,
  Communicator& ranks, const char* property)
  : Pairs(share, classes, ranks)
  , Observed(share.Observed)
  , Cube(std::numeric_limits<double>::infinity())
  , Rim(1.0)
  , Volume(share.Observed.Volume())
  , Periodic(share.Observed.IsFullyPeriodic())
  , Spheres(share.NumberOfSpheres)
{
  this->FindScale(heaviest, ranks, property);
}

void WeightedPairs::FindScale(double heaviest, Communicator& ranks, const char* property)
{
  this->Scale = std::ldexp(1.0, FixedPointSums::TermBits - 2 - std::ilogb(heaviest));

  constexpr std::int64_t mostCentres = 64;
  const std::int64_t terms = this->Pairs.MostNeighbours() + 1;
  ranks.ThrowIfAny(terms <= FixedPointSums::MostTerms
      ? ""
      : Text(property, " requires fewer than ", FixedPointSums::MostTerms,
          " spheres around one within a distance of ", this->Pairs.LargestReach(), "."));
  this->Step = static_cast<std::size_t>(
    std::clamp<std::int64_t>(FixedPointSums::MostTerms / terms, 1, mostCentres));
  this->Terms = terms * static_cast<std::int64_t>(this->Step);
}

double LagsOfPair(const PackFigures& pack, const LagGrid& lags)
{
  return std::min(4.0 * pack.MeanRadius / lags.Spacing, static_cast<double>(lags.Count));
}
}
