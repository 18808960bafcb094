// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellObjective.h"

#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/PairLoops.h"

#include <omp.h>

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// Few centres a chunk, so that ranks and threads get equal shares of a small cell
constexpr std::size_t ChunkOfCentres = 8;

std::vector<SphereType> CellTypes(const CellContents& contents)
{
  std::vector<SphereType> types;
  for (std::size_t m = 0; m < contents.Radius.size(); ++m)
  {
    types.push_back({ static_cast<int>(m) + 1, contents.Radius[m] });
  }
  return types;
}

// Runs pass(begin, end, sums) over this rank's chunks of centres on all threads, and adds `sums` up
// over threads
template <class Pass>
void OverChunks(
  const Communicator& ranks, std::size_t centres, std::vector<std::int64_t>& sums, Pass&& pass)
{
  const std::int64_t chunks =
    static_cast<std::int64_t>((centres + ChunkOfCentres - 1) / ChunkOfCentres);
#pragma omp parallel
  {
    // A thread by itself adds to the sums at once
    const bool alone = omp_get_num_threads() == 1;
    std::vector<std::int64_t> own(alone ? 0 : sums.size(), 0);
    std::int64_t* target = alone ? sums.data() : own.data();
#pragma omp for schedule(dynamic) nowait
    for (std::int64_t chunk = ranks.Rank(); chunk < chunks; chunk += ranks.Size())
    {
      pass(chunk * ChunkOfCentres, std::min((chunk + 1) * ChunkOfCentres, centres), target);
    }
#pragma omp critical
    std::transform(own.begin(), own.end(), sums.begin(), sums.begin(), std::plus<>());
  }
}
}

CellObjective::CellObjective(
  const CellContents& contents, const TwoPointProbability& target, Communicator& communicator)
  : Contents(contents)
  , Target(target)
  , Ranks(communicator)
  , Histogram(CellTypes(contents), target.Lags, SearchKnots)
  , Probability(target.Modes, target.Lags)
{
  double volume = 0.0;
  double weighted = 0.0;
  for (std::size_t m = 0; m < contents.Count.size(); ++m)
  {
    const double modeVolume = contents.Count[m] * SphereVolume(contents.Radius[m]);
    volume += modeVolume;
    weighted += modeVolume * contents.Radius[m];
    this->Probability.Fractions[m] = modeVolume / (contents.Edge * contents.Edge * contents.Edge);
  }
  this->PenaltyRadius = weighted / volume;
}

CellObjective::Terms CellObjective::Evaluate(
  const double* centres, double* gradient, std::int64_t* signal)
{
  const Window box = this->Contents.MakeBox();
  const SpherePack pack = this->Contents.MakePack(centres);
  const CellList cells(pack, box, this->Histogram.GetCutoff());
  std::vector<std::int32_t> types;
  for (std::uint32_t i : cells.Index)
  {
    types.push_back(pack.Mode[i] - 1);
  }

  const std::int64_t mostNeighbours = cells.MostNeighbours();
  const double scale = PairHistogram::FixedPointScale(pack.Size(), mostNeighbours, 1.0);
  this->Sums.assign(this->Histogram.Size() + 1, 0);
  OverChunks(this->Ranks, cells.Size(), this->Sums,
    [&](std::size_t begin, std::size_t end, std::int64_t* sums)
    { CountPairs(this->Histogram, cells, types, scale, begin, end, sums); });
  if (signal)
  {
    this->Sums.back() = *signal;
  }
  this->Ranks.Sum(this->Sums.data(), this->Sums.size());
  if (signal)
  {
    *signal = this->Sums.back();
  }

  // S_rs, the classes shared out over the ranks
  const std::size_t stride = this->Target.Lags.Count + 1;
  std::vector<double> pairs(this->Histogram.NumberOfClasses() * stride, 0.0);
  const double volume = box.Volume();
#pragma omp parallel for schedule(dynamic)
  for (int c = this->Ranks.Rank(); c < this->Histogram.NumberOfClasses(); c += this->Ranks.Size())
  {
    const PairKernel& kernel = this->Histogram.Kernel(c);
    const SphereType& low = this->Histogram.LowerType(c);
    const SphereType& high = this->Histogram.HigherType(c);
    const double factor = (low == high ? 2.0 : 1.0) / (scale * volume);
    std::vector<double> weights(kernel.Size());
    std::transform(&this->Sums[this->Histogram.Begin(c)], &this->Sums[this->Histogram.Begin(c + 1)],
      weights.begin(), [&](std::int64_t sum) { return factor * sum; });
    double* s = &pairs[c * stride];
    kernel.AddOverlap(weights.data(), s);
    for (std::size_t k = 0;
         low == high && k < stride && k * this->Target.Lags.Spacing < 2.0 * low.Radius; ++k)
    {
      s[k] += this->Contents.Count[low.Mode - 1] *
        LensVolume(low.Radius, low.Radius, k * this->Target.Lags.Spacing) / volume;
    }
  }
  this->Ranks.Share(pairs.data(), pairs.size());
  for (int c = 0; c < this->Histogram.NumberOfClasses(); ++c)
  {
    std::copy_n(&pairs[c * stride], stride,
      this->Probability
        .S(this->Histogram.LowerType(c).Mode - 1, this->Histogram.HigherType(c).Mode - 1)
        .begin());
  }
  this->Probability.CompleteMatrix();

  Terms terms;
  terms.TwoPoint = TwoPointDifference(this->Target, this->Probability);
  const double penalty = this->PenaltyWeight / (this->PenaltyRadius * this->PenaltyRadius);
  std::vector<double> penalties(this->Histogram.Size(), 0.0);
  terms.Penalty = 0.0;
  for (int c = 0; c < this->Histogram.NumberOfClasses(); ++c)
  {
    this->Histogram.Kernel(c).AddOverlapPenalty(penalty, &penalties[this->Histogram.Begin(c)]);
  }
  for (std::size_t n = 0; n < penalties.size(); ++n)
  {
    terms.Penalty += penalties[n] * (this->Sums[n] / scale);
  }
  if (!gradient)
  {
    return terms;
  }

  this->Potential = std::move(penalties);
  this->AddTwoPointPotential(volume);
  std::vector<double> slopes;
  const double steepest = FindSlopes(this->Histogram, this->Potential, slopes);
  const double forceScale =
    PairHistogram::FixedPointScale(1, mostNeighbours, std::max(steepest, 1e-30));
  std::vector<std::int64_t> forces(4 * cells.Size(), 0);
  OverChunks(this->Ranks, cells.Size(), forces,
    [&](std::size_t begin, std::size_t end, std::int64_t* sums)
    { AddPairForces(this->Histogram, cells, types, slopes, forceScale, begin, end, sums); });
  this->Ranks.Sum(forces.data(), forces.size());
  for (std::size_t j = 0; j < cells.Size(); ++j)
  {
    for (int q = 0; q < 3; ++q)
    {
      gradient[3 * cells.Index[j] + q] = forces[4 * j + q] / forceScale;
    }
  }
  return terms;
}

void CellObjective::AddTwoPointPotential(double volume)
{
  // e_rs = (S_rs - target) / || S_rs - target ||
  const std::size_t lags = this->Target.Lags.Count + 1;
  TwoPointProbability unit(this->Target.Modes, this->Target.Lags);
  for (int p = 0; p < unit.Pairs(); ++p)
  {
    std::transform(this->Probability.Values[p].begin(), this->Probability.Values[p].end(),
      this->Target.Values[p].begin(), unit.Values[p].begin(), std::minus<>());
    const double norm = DiscreteNorm(unit.Values[p]);
    for (double& value : unit.Values[p])
    {
      value = norm > 0.0 ? value / norm : 0.0;
    }
    unit.Values[p][0] = 0.0; // the norm leaves the lag 0 out
  }
  const int m = this->Target.Modes;
  std::vector<double> potential(this->Histogram.Size(), 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int c = this->Ranks.Rank(); c < this->Histogram.NumberOfClasses(); c += this->Ranks.Size())
  {
    const int r = this->Histogram.LowerType(c).Mode - 1;
    const int s = this->Histogram.HigherType(c).Mode - 1;
    // A pair of modes r != s stands twice in the sum over all ordered pairs, and so do its matrix
    // terms; a pair of particles of one mode counts twice in S_rr. Either way the derivative after
    // one more pair is twice e_rs - ….
    std::vector<double> lambda(lags);
    for (std::size_t k = 1; k < lags; ++k)
    {
      lambda[k] =
        2.0 / volume * (unit.S(r, s)[k] - unit.S(r, m)[k] - unit.S(s, m)[k] + unit.S(m, m)[k]);
    }
    this->Histogram.Kernel(c).AddPotential(lambda.data(), &potential[this->Histogram.Begin(c)]);
  }
  this->Ranks.Share(potential.data(), potential.size());
  std::transform(potential.begin(), potential.end(), this->Potential.begin(),
    this->Potential.begin(), std::plus<>());
}

double EstimateEvaluation(const CellFigures& cell, const LagGrid& lags, bool withGradient)
{
  const double pairs =
    0.5 * cell.Spheres * cell.Density * SphereVolume(lags.Maximum() + 2.0 * cell.LargestRadius);
  const double classes = 0.5 * cell.Modes * (cell.Modes + 1.0);
  // From the histogram of a pair of modes to S_rs, on fewer knots than those of an exact sum
  constexpr double SecondsPerClassAndLag = 5e-8;
  return (pairs * SecondsPerHistogramPair + classes * lags.Count * SecondsPerClassAndLag) *
    (withGradient ? 2.0 : 1.0);
}
}
