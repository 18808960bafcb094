// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include "ruc/Base/VectorClones.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"
#include "ruc/Statistics/PairSums/PairLoops.h"
#include "ruc/Statistics/PairSums/WeightedPairs.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Results/Phases.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace ruc
{
namespace
{
// With more types than this, or a histogram too large for a cache, tables for all pairs of types do
// not pay
constexpr std::size_t MostTypes = 256;
constexpr double LargestHistogram = 1 << 21;
// Where many lags lie between the centre and the surface of a sphere, tables would be larger than
// this; the few pairs that meet at such lags are then summed one by one
constexpr double LargestTables = 256e6; // bytes

// Returns every type of sphere that occurs on any rank, once and in order. Where there are more
// than MostTypes, it returns more than MostTypes, but not all of them.
std::vector<SphereType> FindTypes(const SpherePack& own, Communicator& ranks)
{
  std::set<SphereType> types;
  for (std::size_t i = 0; i < own.Size() && types.size() <= MostTypes; ++i)
  {
    types.insert({ own.Mode[i], own.Radius[i] });
  }
  for (const SphereType& type :
    ranks.Concatenate(std::vector<SphereType>(types.begin(), types.end())))
  {
    types.insert(type);
  }
  return { types.begin(), types.end() };
}

// The method for few types: a histogram of the distances for every pair of types, and behind it the
// number of spheres of every type
class TabulatedSum
{
public:
  TabulatedSum(const PackShare& share, const LagGrid& lags, const std::vector<SphereType>& types,
    const WeightedPairs& pairs)
    : Observed(share.Observed)
    , Lags(lags)
    , Types(types)
    , Histogram(types, lags)
    , Pairs(pairs)
  {
    for (const PairNeighbourhood::Part& part : pairs.Pairs.Parts)
    {
      std::vector<std::int32_t> typeOfPlace;
      for (std::uint32_t i : part.Cells.Index)
      {
        const SphereType type = { part.Pack.Mode[i], part.Pack.Radius[i] };
        typeOfPlace.push_back(static_cast<std::int32_t>(
          std::lower_bound(types.begin(), types.end(), type) - types.begin()));
      }
      this->TypeOfPlace.push_back(std::move(typeOfPlace));
    }
  }

  std::size_t Size() const { return this->Histogram.Size() + this->Types.size(); }

  void Add(std::size_t begin, std::size_t end, std::int64_t* sums) const
  {
    CountPairs(this->Histogram, this->Pairs.Pairs, this->TypeOfPlace, this->Observed,
      this->Pairs.Scale, begin, end, sums);
    for (std::size_t i = begin; i < end; ++i)
    {
      ++sums[this->Histogram.Size() + this->TypeOfPlace.front()[i]];
    }
  }

  // S_rs x V of the particles
  void AddResult(const std::vector<std::int64_t>& sums, TwoPointProbability& result) const
  {
    for (int c = 0; c < this->Histogram.NumberOfClasses(); ++c)
    {
      const PairKernel& kernel = this->Histogram.Kernel(c);
      const int r = this->Histogram.LowerType(c).Mode - 1;
      const int s = this->Histogram.HigherType(c).Mode - 1;
      // Within a mode both orders of a pair count.
      const double factor = r == s ? 2.0 : 1.0;
      std::vector<double> weights(kernel.Size());
      for (std::size_t n = 0; n < weights.size(); ++n)
      {
        const std::size_t place = this->Histogram.Begin(c) + n;
        weights[n] = factor * (WideValue(&sums[2 * place]) / this->Pairs.Scale);
      }
      kernel.AddOverlap(weights.data(), result.S(r, s).data());
    }
    // Every sphere with itself
    for (std::size_t t = 0; t < this->Types.size(); ++t)
    {
      const SphereType& type = this->Types[t];
      const double count = WideValue(&sums[2 * (this->Histogram.Size() + t)]);
      std::vector<double>& s = result.S(type.Mode - 1, type.Mode - 1);
      for (int k = 0; k <= this->Lags.Count && k * this->Lags.Spacing < 2.0 * type.Radius; ++k)
      {
        s[k] += count * LensVolume(type.Radius, type.Radius, k * this->Lags.Spacing);
      }
    }
  }

private:
  Window Observed;
  LagGrid Lags;
  std::vector<SphereType> Types;
  PairHistogram Histogram;
  const WeightedPairs& Pairs;
  std::vector<std::vector<std::int32_t>> TypeOfPlace; // for every part
};

// Adds factor x g_ab(r_k; d), k = 1…K, to integers; inverse[k] = 1 / (2 r_k)
RUC_VECTOR_CLONES
void AddOverlap(double a, double b, double d, double factor, const LagGrid& lags,
  const double* inverse, std::int64_t* sums)
{
  const MomentFormula moment(a, b);
  const double contact = a + b;
  const double scaled = factor / d * Pi / 12.0;
  // 2 d r g = h(d - r) - h(d + r), the latter only for overlapping spheres
  const int last = std::min(lags.Count, static_cast<int>((d + contact) / lags.Spacing));
  if (d < contact)
  {
    for (int k = 1; k <= last; ++k)
    {
      const double r = k * lags.Spacing;
      sums[k] += RoundToFixedPoint(scaled * inverse[k] * (moment(std::abs(d - r)) - moment(d + r)));
    }
    return;
  }
  const int first = std::max(1, static_cast<int>(std::ceil((d - contact) / lags.Spacing)));
  for (int k = first; k <= last; ++k)
  {
    sums[k] += RoundToFixedPoint(scaled * inverse[k] * moment(std::abs(d - k * lags.Spacing)));
  }
}

// The method for many types: the closed form for every pair and lag
class DirectSum
{
public:
  DirectSum(const PackShare& share, const LagGrid& lags, const WeightedPairs& pairs)
    : Lags(lags)
    , Pairs(pairs)
    , Numbering(share.NumberOfModes(), lags)
    , Unit(SphereVolume(share.LargestRadius))
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      this->Inverse.push_back(k > 0 ? 0.5 / (k * lags.Spacing) : 0.0);
    }
  }

  std::size_t Size() const { return this->Numbering.Values.size() * (this->Lags.Count + 1); }

  // An overlap is at most the largest sphere's volume, the unit of these sums.
  void Add(std::size_t begin, std::size_t end, std::int64_t* sums) const
  {
    const SpherePack& own = this->Pairs.Pairs.Parts.front().Pack;
    const double scale = this->Pairs.Scale / this->Unit;
    for (std::size_t place = begin; place < end; ++place)
    {
      const std::size_t i = this->Pairs.Pairs.Own().Index[place];
      const double radius = own.Radius[i];
      std::int64_t* self = this->SumsOf(own.Mode[i], own.Mode[i], sums);
      for (int k = 0; k <= this->Lags.Count && k * this->Lags.Spacing < 2.0 * radius; ++k)
      {
        self[k] += RoundToFixedPoint(scale * LensVolume(radius, radius, k * this->Lags.Spacing));
      }
    }
    this->Pairs.ForEach(begin, end,
      [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, const Vector3&,
        double d2, double weight)
      {
        const double d = std::sqrt(d2);
        const double a = own.Radius[i], b = part.Pack.Radius[j];
        if (d >= this->Lags.Maximum() + a + b)
        {
          return;
        }
        // Within a mode both orders of a pair count.
        const double orders = own.Mode[i] == part.Pack.Mode[j] ? 2.0 : 1.0;
        const double factor = scale * orders * weight;
        // The spheres are taken in one order, whichever rank meets them, as rounding is not
        // symmetric
        const double lesser = std::min(a, b), greater = std::max(a, b);
        std::int64_t* pair = this->SumsOf(own.Mode[i], part.Pack.Mode[j], sums);
        pair[0] += RoundToFixedPoint(factor * LensVolume(lesser, greater, d));
        AddOverlap(lesser, greater, d, factor, this->Lags, this->Inverse.data(), pair);
      });
  }

  // S_rs x V of the particles
  void AddResult(const std::vector<std::int64_t>& sums, TwoPointProbability& result) const
  {
    const std::size_t stride = this->Lags.Count + 1;
    for (std::size_t n = 0; n < this->Size(); ++n)
    {
      result.Values[n / stride][n % stride] +=
        WideValue(&sums[2 * n]) / this->Pairs.Scale * this->Unit;
    }
  }

private:
  std::int64_t* SumsOf(int modeA, int modeB, std::int64_t* sums) const
  {
    return sums + this->Numbering.PairOf(modeA - 1, modeB - 1) * (this->Lags.Count + 1);
  }

  LagGrid Lags;
  const WeightedPairs& Pairs;
  TwoPointProbability Numbering;
  double Unit;
  std::vector<double> Inverse;
};

template <class Method>
TwoPointProbability SumBy(const Method& method, const PackShare& share, const LagGrid& lags,
  const WeightedPairs& pairs, Communicator& ranks, const SumProgress& progress)
{
  const std::vector<std::int64_t> sums = pairs.Sum(method.Size(), ranks, progress,
    [&](std::size_t begin, std::size_t end, std::int64_t* own) { method.Add(begin, end, own); });
  TwoPointProbability result(share.NumberOfModes(), lags);
  result.Fractions = OnePointProbability(share);
  method.AddResult(sums, result);
  const double volume = share.Observed.Volume();
  for (std::vector<double>& s : result.Values)
  {
    for (double& value : s)
    {
      value /= volume;
    }
  }
  result.CompleteMatrix();
  return result;
}
}

TwoPointProbability SumPairs(
  const PackShare& share, const LagGrid& lags, Communicator& ranks, const SumProgress& progress)
{
  CheckNumberOfLags(share.NumberOfModes(), lags);
  LagLimit::ForPairSum(share.Observed, share.LargestRadius).Check(lags);
  const std::vector<SphereType> types = FindTypes(share.Own, ranks);
  const double cutoff = lags.Maximum() + 2.0 * share.LargestRadius;
  const Window& window = share.Observed;
  // A bound of the weights, which needs no walk over all pairs
  const double heaviest =
    window.IsFullyPeriodic() ? 1.0 : window.Volume() / window.LeastSetCovariance(cutoff);
  const SizeClasses classes(share.Own.Radius, lags.Maximum(), 1.0, ranks);
  const WeightedPairs pairs(share, classes, heaviest, ranks, "MaximumLag");
  if (types.size() <= MostTypes && PairHistogram::EstimateSize(types, lags) <= LargestHistogram &&
    PairHistogram::EstimateTables(types, lags) <= LargestTables)
  {
    return SumBy(TabulatedSum(share, lags, types, pairs), share, lags, pairs, ranks, progress);
  }
  return SumBy(DirectSum(share, lags, pairs), share, lags, pairs, ranks, progress);
}

TwoPointProbability SumPairs(const SpherePack& pack, const Window& window, const LagGrid& lags)
{
  Communicator serial;
  return SumPairs(SharePack(pack, window), lags, serial);
}

namespace
{
constexpr double SecondsPerDirectPair = 4.8e-8;
constexpr double SecondsPerDirectLag = 0.5e-9;   // for a lag of a pair
constexpr double SecondsPerClassAndLag = 1.3e-6; // from the histogram of a pair of types to S_rs
}

Estimate EstimatePairSum(const PackFigures& pack, const LagGrid& lags)
{
  const double pairs = pack.PairsWithin(lags.Maximum() + 2.0 * pack.LargestRadius);
  const double classes = 0.5 * pack.Types * (pack.Types + 1.0);
  const double tables = classes * PairKernel::TableBytes(pack.MeanRadius, pack.MeanRadius, lags);
  if (pack.Types > static_cast<int>(MostTypes) || tables > LargestTables)
  {
    return { pairs * (SecondsPerDirectPair + LagsOfPair(pack, lags) * SecondsPerDirectLag),
      16.0 * PairsOfPhases(pack.Modes) * lags.Count / BytesOfMegabyte, 0.0 };
  }
  return { pairs * SecondsPerHistogramPair + classes * lags.Count * SecondsPerClassAndLag,
    (64.0 * classes * lags.Count + tables) / BytesOfMegabyte, 0.0 };
}
}
