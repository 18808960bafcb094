// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/TwoPointTerm.h"

#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <functional>

namespace ruc
{
namespace
{
// e_rs = (S_rs - target) / || S_rs - target ||
TwoPointProbability UnitDifference(
  const TwoPointProbability& probability, const TwoPointProbability& target)
{
  TwoPointProbability unit(target.Modes, target.Lags);
  for (int p = 0; p < unit.Pairs(); ++p)
  {
    std::transform(probability.Values[p].begin(), probability.Values[p].end(),
      target.Values[p].begin(), unit.Values[p].begin(), std::minus<>());
    const double norm = DiscreteNorm(unit.Values[p]);
    for (double& value : unit.Values[p])
    {
      value = norm > 0.0 ? value / norm : 0.0;
    }
    unit.Values[p][0] = 0.0; // the norm leaves lag 0 out
  }
  return unit;
}
}

TwoPointTerm::TwoPointTerm(const CellContents& contents, const TwoPointProbability& target,
  const PairHistogram& classes, Communicator& communicator)
  : Count(contents.Count)
  , Volume(contents.MakeBox().Volume())
  , Target(target)
  , Classes(classes)
  , Ranks(communicator)
  , Probability(target.Modes, target.Lags)
{
  for (std::size_t t = 0; t < contents.Count.size(); ++t)
  {
    const double volume = contents.Count[t] * SphereVolume(contents.Radius[t]);
    this->Probability.Fractions[contents.ModeOf(static_cast<int>(t)) - 1] +=
      volume / (contents.Edge * contents.Edge * contents.Edge);
  }
}

double TwoPointTerm::Evaluate(const PairCounts& pairs)
{
  const int classes = this->Classes.NumberOfClasses();
  const std::size_t stride = this->Target.Lags.Count + 1;
  std::vector<double> probabilities(classes * stride, 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int c = this->Ranks.Rank(); c < classes; c += this->Ranks.Size())
  {
    this->FindProbability(c, pairs, &probabilities[c * stride]);
  }
  this->Ranks.AllGatherInTurn(
    probabilities.data(), classes, [&](std::size_t c) { return c * stride; });
  for (std::vector<double>& values : this->Probability.Values)
  {
    std::fill(values.begin(), values.end(), 0.0);
  }
  for (int c = 0; c < classes; ++c)
  {
    std::vector<double>& sum = this->Probability.S(
      this->Classes.LowerType(c).Mode - 1, this->Classes.HigherType(c).Mode - 1);
    std::transform(sum.begin(), sum.end(), &probabilities[c * stride], sum.begin(), std::plus<>());
  }
  this->Probability.CompleteMatrix();
  return TwoPointDifference(this->Target, this->Probability);
}

void TwoPointTerm::FindProbability(
  int pairClass, const PairCounts& pairs, double* probability) const
{
  const PairKernel& kernel = this->Classes.Kernel(pairClass);
  const SphereType& low = this->Classes.LowerType(pairClass);
  const SphereType& high = this->Classes.HigherType(pairClass);
  const double factor = (low.Mode == high.Mode ? 2.0 : 1.0) / (pairs.Scale * this->Volume);
  std::vector<double> weights(kernel.Size());
  std::transform(pairs.Sums + this->Classes.Begin(pairClass),
    pairs.Sums + this->Classes.Begin(pairClass + 1), weights.begin(),
    [&](std::int64_t sum) { return factor * sum; });
  kernel.AddOverlap(weights.data(), probability);
  const LagGrid& lags = this->Target.Lags;
  for (int k = 0; low == high && k <= lags.Count && k * lags.Spacing < 2.0 * low.Radius; ++k)
  {
    probability[k] += this->Count[this->Classes.LowerTypeIndex(pairClass)] *
      LensVolume(low.Radius, low.Radius, k * lags.Spacing) / this->Volume;
  }
}

void TwoPointTerm::AddPotential(std::vector<double>& potential) const
{
  const TwoPointProbability unit = UnitDifference(this->Probability, this->Target);
  const std::size_t lags = this->Target.Lags.Count + 1;
  const int m = this->Target.Modes;
  std::vector<double> own(potential.size(), 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int c = this->Ranks.Rank(); c < this->Classes.NumberOfClasses(); c += this->Ranks.Size())
  {
    const int r = this->Classes.LowerType(c).Mode - 1;
    const int s = this->Classes.HigherType(c).Mode - 1;
    // A pair of modes r != s appears twice in the sum over all ordered pairs, and so do its matrix
    // terms; a pair of particles of one mode counts twice in S_rr. Either way, one more pair
    // changes F2 by twice this combination.
    std::vector<double> lambda(lags);
    for (std::size_t k = 1; k < lags; ++k)
    {
      lambda[k] = 2.0 / this->Volume *
        (unit.S(r, s)[k] - unit.S(r, m)[k] - unit.S(s, m)[k] + unit.S(m, m)[k]);
    }
    this->Classes.Kernel(c).AddPotential(lambda.data(), &own[this->Classes.Begin(c)]);
  }
  this->Ranks.AllGatherInTurn(own.data(), this->Classes.NumberOfClasses(),
    [&](std::size_t c) { return this->Classes.Begin(static_cast<int>(c)); });
  std::transform(own.begin(), own.end(), potential.begin(), potential.begin(), std::plus<>());
}
}
