// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/DirectionalProbability.h"

#include "ruc/Base/FixedPointSums.h"
#include "ruc/Base/Text.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/WeightedPairs.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Results/Phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ruc
{
namespace
{
// As many directions are taken at a time as keep the sums of a thread below this number, 24 MB
constexpr std::size_t MostSums = 1 << 20;

// Directions, with an array for each component, for vector loops
struct Components
{
  std::vector<double> X, Y, Z;
};

// Splits a displacement d into |d n| and |d x n|^2; both are the same for -d
RUC_VECTOR_CLONES
void Split(const Vector3& d, const double* nx, const double* ny, const double* nz,
  std::size_t count, double* along, double* across2)
{
  const double dx = d[0], dy = d[1], dz = d[2];
  for (std::size_t n = 0; n < count; ++n)
  {
    const double x = dy * nz[n] - dz * ny[n];
    const double y = dz * nx[n] - dx * nz[n];
    const double z = dx * ny[n] - dy * nx[n];
    along[n] = std::abs(dx * nx[n] + dy * ny[n] + dz * nz[n]);
    across2[n] = x * x + y * y + z * z;
  }
}

// Adds factor x [V(|d - r_k n|) + V(|d + r_k n|)], k = 1…K, to integers
RUC_VECTOR_CLONES
void AddLags(const LensFormula& lens, double along, double across2, double factor,
  const LagGrid& lags, std::int64_t* sums)
{
  const double half = std::sqrt(lens.Contact * lens.Contact - across2);
  const double spacing = lags.Spacing;
  const int first = static_cast<int>(
    std::min(std::max(std::ceil((along - half) / spacing), 1.0), lags.Count + 1.0));
  const int last = static_cast<int>(std::min<double>(lags.Count, (along + half) / spacing));
  const LensFormula volume = lens;
  for (int k = first; k <= last; ++k)
  {
    const double t = along - k * spacing;
    sums[k] += RoundToFixedPoint(factor * volume(std::sqrt(across2 + t * t)));
  }
  const int behind =
    static_cast<int>(std::min<double>(lags.Count, std::max(half - along, 0.0) / spacing));
  for (int k = 1; k <= behind; ++k)
  {
    const double t = along + k * spacing;
    sums[k] += RoundToFixedPoint(factor * volume(std::sqrt(across2 + t * t)));
  }
}

// Sums for a number of directions at a time. For every direction and unordered pair of modes there
// is one function of the lags; behind them is another set, of what does not depend on the
// direction.
class DirectionalSum
{
public:
  DirectionalSum(const PackShare& share, const LagGrid& lags, Communicator& ranks)
    : Share(share)
    , Lags(lags)
    , Pairs(share, SizeClasses(share.Own.Radius, lags.Maximum(), 1.0, ranks), ranks, "MaximumLag")
    , Numbering(share.NumberOfModes() - 1, { 1.0, 0 }) // as if the modes were all the phases
    , Unit(SphereVolume(share.LargestRadius))
  {
  }

  std::size_t SumsOfDirection() const
  {
    return static_cast<std::size_t>(this->Numbering.Pairs()) * (this->Lags.Count + 1);
  }

  // S_rs x V for pairs of modes, in the layout of the sums
  std::vector<double> Sum(const std::vector<Vector3>& directions, std::size_t first,
    std::size_t count, Communicator& ranks, const SumProgress& progress) const
  {
    Components n;
    for (std::size_t d = first; d < first + count; ++d)
    {
      n.X.push_back(directions[d][0]);
      n.Y.push_back(directions[d][1]);
      n.Z.push_back(directions[d][2]);
    }
    const std::size_t size = (count + 1) * this->SumsOfDirection();
    const auto part = [&](double done)
    { return !progress || progress((first + done * count) / directions.size()); };
    const std::vector<std::int64_t> sums = this->Pairs.Sum(size, ranks, part,
      [&](std::size_t begin, std::size_t end, std::int64_t* own)
      {
        std::vector<double> along(count), across2(count);
        this->Add(begin, end, n, along.data(), across2.data(), own);
      });
    std::vector<double> values(size);
    for (std::size_t v = 0; v < size; ++v)
    {
      values[v] = WideValue(&sums[2 * v]) / this->Pairs.Scale * this->Unit;
    }
    return values;
  }

  // S_rs along the d-th of the directions that were summed
  TwoPointProbability Result(const std::vector<double>& values, std::size_t d) const
  {
    const int modes = this->Share.NumberOfModes();
    TwoPointProbability result(modes, this->Lags);
    result.Fractions = OnePointProbability(this->Share);
    const double volume = this->Share.Observed.Volume();
    for (int r = 0; r < modes; ++r)
    {
      for (int s = r; s < modes; ++s)
      {
        const std::size_t begin = this->Numbering.PairOf(r, s) * (this->Lags.Count + 1ul);
        const double* directed = &values[d * this->SumsOfDirection() + begin];
        const double* undirected = &values[values.size() - this->SumsOfDirection() + begin];
        std::transform(directed, directed + this->Lags.Count + 1, undirected,
          result.S(r, s).begin(), [&](double a, double b) { return (a + b) / volume; });
      }
    }
    result.CompleteMatrix();
    return result;
  }

private:
  // A pair adds at most twice its weight to any sum, in units of the largest sphere's volume.
  void Add(std::size_t begin, std::size_t end, const Components& n, double* along, double* across2,
    std::int64_t* sums) const
  {
    const SpherePack& own = this->Pairs.Pairs.Parts.front().Pack;
    const std::size_t stride = this->SumsOfDirection();
    const std::size_t count = n.X.size();
    const double scale = this->Pairs.Scale / this->Unit;
    const auto place = [&](int modeA, int modeB)
    {
      return this->Numbering.PairOf(modeA - 1, modeB - 1) *
        (static_cast<std::size_t>(this->Lags.Count) + 1);
    };
    for (std::size_t p = begin; p < end; ++p)
    {
      const std::size_t i = this->Pairs.Pairs.Own().Index[p];
      const double radius = own.Radius[i];
      std::int64_t* self = sums + count * stride + place(own.Mode[i], own.Mode[i]);
      for (int k = 0; k <= this->Lags.Count && k * this->Lags.Spacing < 2.0 * radius; ++k)
      {
        self[k] += RoundToFixedPoint(scale * LensVolume(radius, radius, k * this->Lags.Spacing));
      }
    }
    this->Pairs.ForEach(begin, end,
      [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, const Vector3& d,
        double d2, double weight)
      {
        const LensFormula lens(own.Radius[i], part.Pack.Radius[j]);
        const double reach = this->Lags.Maximum() + lens.Contact;
        if (d2 >= reach * reach)
        {
          return;
        }
        // Within a mode both orders of a pair count. Each counts half along n and half along -n.
        const double orders = own.Mode[i] == part.Pack.Mode[j] ? 2.0 : 1.0;
        const double factor = 0.5 * orders * scale * weight * (Pi / 12.0);
        std::int64_t* pair = sums + place(own.Mode[i], part.Pack.Mode[j]);
        const double contact2 = lens.Contact * lens.Contact;
        if (d2 < contact2)
        {
          pair[count * stride] += RoundToFixedPoint(2.0 * factor * lens(std::sqrt(d2))); // lag 0
        }
        Split(d, n.X.data(), n.Y.data(), n.Z.data(), count, along, across2);
        for (std::size_t m = 0; m < count; ++m)
        {
          if (across2[m] < contact2)
          {
            AddLags(lens, along[m], across2[m], factor, this->Lags, pair + m * stride);
          }
        }
      });
  }

  const PackShare& Share;
  LagGrid Lags;
  WeightedPairs Pairs;
  TwoPointProbability Numbering;
  double Unit;
};

void CheckDirections(const std::vector<Vector3>& directions, int modes, const LagGrid& lags)
{
  constexpr double mostNumbers = 5e7; // 400 MB
  const double numbers = 0.5 * (modes + 1.0) * (modes + 2.0) * (lags.Count + 1.0);
  if (directions.empty() || directions.size() * numbers > mostNumbers)
  {
    throw std::invalid_argument(Text("NumberOfDirections requires 1 <= NumberOfDirections <= ",
      static_cast<int>(mostNumbers / numbers), " for ", modes, " modes and ", lags.Count,
      " lags, got ", directions.size(), "."));
  }
  for (const Vector3& n : directions)
  {
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(std::abs(length - 1.0) <= 1e-9))
    {
      throw std::invalid_argument(Text("Directions requires vectors of length 1, got ", n[0], " ",
        n[1], " ", n[2], " of length ", length, "."));
    }
  }
}
}

DirectionalProbability SumPairsAlong(const PackShare& share, const std::vector<Vector3>& directions,
  const LagGrid& lags, Communicator& ranks, const SumProgress& progress)
{
  CheckNumberOfLags(share.NumberOfModes(), lags);
  LagLimit::ForPairSum(share.Observed, share.LargestRadius).Check(lags);
  CheckDirections(directions, share.NumberOfModes(), lags);
  const DirectionalSum sum(share, lags, ranks);
  DirectionalProbability result;
  result.Directions = directions;
  const std::size_t atOnce = std::max<std::size_t>(MostSums / sum.SumsOfDirection(), 1);
  for (std::size_t first = 0; first < directions.size(); first += atOnce)
  {
    const std::size_t count = std::min(atOnce, directions.size() - first);
    const std::vector<double> values = sum.Sum(directions, first, count, ranks, progress);
    for (std::size_t d = 0; d < count; ++d)
    {
      result.Values.push_back(sum.Result(values, d));
    }
  }
  return result;
}

TwoPointProbability MeanOverDirections(const DirectionalProbability& probability)
{
  TwoPointProbability mean(probability.Values.front().Modes, probability.Values.front().Lags);
  const auto add = [&](const std::vector<double>& values, std::vector<double>& sum)
  {
    std::transform(values.begin(), values.end(), sum.begin(), sum.begin(),
      [&](double value, double s) { return s + value / probability.Values.size(); });
  };
  for (const TwoPointProbability& one : probability.Values)
  {
    add(one.Fractions, mean.Fractions);
    for (int pair = 0; pair < mean.Pairs(); ++pair)
    {
      add(one.Values[pair], mean.Values[pair]);
    }
  }
  return mean;
}

std::vector<std::vector<double>> IsotropyDeviation(const DirectionalProbability& probability)
{
  const TwoPointProbability mean = MeanOverDirections(probability);
  const double freedom = probability.Values.size() - 1.0;
  std::vector<std::vector<double>> deviation = mean.Values;
  for (int pair = 0; pair < mean.Pairs(); ++pair)
  {
    for (int k = 0; k <= mean.Lags.Count; ++k)
    {
      double sum = 0.0;
      for (const TwoPointProbability& one : probability.Values)
      {
        const double difference = one.Values[pair][k] - mean.Values[pair][k];
        sum += difference * difference;
      }
      deviation[pair][k] =
        freedom > 0.0 ? std::sqrt(sum / freedom) : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return deviation;
}

std::vector<std::vector<double>> IsotropyNoise(const DirectionalProbability& probability)
{
  const TwoPointProbability& first = probability.Values.front();
  std::vector<std::vector<double>> noise(
    first.Pairs(), std::vector<double>(first.Lags.Count + 1, 0.0));
  for (const std::vector<std::vector<double>>& errors : probability.Errors)
  {
    for (int pair = 0; pair < first.Pairs(); ++pair)
    {
      for (int k = 0; k <= first.Lags.Count; ++k)
      {
        noise[pair][k] += errors[pair][k] * errors[pair][k] / probability.Errors.size();
      }
    }
  }
  for (std::vector<double>& values : noise)
  {
    std::transform(
      values.begin(), values.end(), values.begin(), [](double sum) { return std::sqrt(sum); });
  }
  return noise;
}

namespace
{
constexpr double SecondsPerPairAndDirection = 1.5e-9;
constexpr double SecondsPerPairDirectionAndLag = 3e-11;
}

Estimate EstimatePairSumAlong(const PackFigures& pack, const LagGrid& lags, int directions)
{
  const double pairs = pack.PairsWithin(lags.Maximum() + 2.0 * pack.LargestRadius);
  return { pairs *
      (SecondsPerWeightedPair +
        directions *
          (SecondsPerPairAndDirection + LagsOfPair(pack, lags) * SecondsPerPairDirectionAndLag)),
    (24.0 * PairsOfPhases(pack.Modes) * lags.Count + 100.0) * directions / BytesOfMegabyte, 0.0 };
}
}
