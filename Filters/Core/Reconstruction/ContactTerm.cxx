// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/ContactTerm.h"

#include <algorithm>
#include <limits>

namespace ruc
{
namespace
{
// The sums over values u of (Z - u)+ at all thresholds Z, times `factor`
class HingesBelow
{
public:
  explicit HingesBelow(const HingeSums& pack)
    : Pack(pack)
    , Count(pack.Size() + 1, 0.0)
    , Sum(pack.Size() + 1, 0.0)
  {
  }

  void Add(double u)
  {
    const std::size_t n = this->PlaceOf(u);
    this->Count[n] += 1.0;
    this->Sum[n] += u;
  }

  std::vector<double> Values(double factor) const
  {
    std::vector<double> values;
    double count = 0.0, sum = 0.0;
    for (std::size_t j = 0; j < this->Pack.Size(); ++j)
    {
      count += this->Count[j];
      sum += this->Sum[j];
      values.push_back(factor * (count * this->Pack.Threshold[j] - sum));
    }
    return values;
  }

  // The first threshold above u
  std::size_t PlaceOf(double u) const
  {
    return std::upper_bound(this->Pack.Threshold.begin(), this->Pack.Threshold.end(), u) -
      this->Pack.Threshold.begin();
  }

private:
  const HingeSums& Pack;
  std::vector<double> Count, Sum; // of the values between two thresholds
};

// For each threshold the sum of the slopes from it on: minus what a value just below it gains by
// growing
std::vector<double> SumsFrom(const std::vector<double>& slopes)
{
  std::vector<double> sums(slopes.size() + 1, 0.0);
  for (std::size_t j = slopes.size(); j-- > 0;)
  {
    sums[j] = sums[j + 1] + slopes[j];
  }
  return sums;
}

// Adds the gradient of `slope` times the distance of a pair
void AddAlong(const NearPairs::Pair& pair, double slope, double* gradient)
{
  const double scale = slope / std::max(pair.Distance, std::numeric_limits<double>::min());
  for (int q = 0; q < 3; ++q)
  {
    gradient[3 * pair.First + q] -= scale * pair.Along[q];
    gradient[3 * pair.Second + q] += scale * pair.Along[q];
  }
}
}

ContactTerm::ContactTerm(const SpherePack& spheres, const Window& box, const NeighbourSums& sums)
  : Sums(sums)
  , Spheres(spheres.Size())
  , Pairs(spheres, box, 1.0 + LargestNeighbourGap)
{
}

ContactTerm::Misfits ContactTerm::Evaluate(const double* centres, double factor, double* gradient)
{
  const std::vector<NearPairs::Pair>& pairs = this->Pairs.Find(centres);
  return { this->EvaluateGaps(pairs, factor, gradient),
    this->EvaluateNearest(pairs, factor, gradient) };
}

double ContactTerm::EvaluateGaps(
  const std::vector<NearPairs::Pair>& pairs, double factor, double* gradient)
{
  HingesBelow hinges(this->Sums.Gaps);
  for (const NearPairs::Pair& pair : pairs)
  {
    hinges.Add(pair.Gap());
  }
  const double share = 2.0 / this->Spheres; // a pair is a neighbour of both
  std::vector<double> slopes;
  const double misfit = FindMisfit(this->Sums.Gaps, hinges.Values(share), slopes);
  if (gradient)
  {
    const std::vector<double> sums = SumsFrom(slopes);
    for (const NearPairs::Pair& pair : pairs)
    {
      AddAlong(pair, -factor * share * sums[hinges.PlaceOf(pair.Gap())] / pair.Contact, gradient);
    }
  }
  return misfit;
}

double ContactTerm::EvaluateNearest(
  const std::vector<NearPairs::Pair>& pairs, double factor, double* gradient)
{
  const auto width = [](const NearPairs::Pair& pair) { return pair.Distance - pair.Contact; };
  std::vector<const NearPairs::Pair*> nearest(this->Spheres, nullptr);
  for (const NearPairs::Pair& pair : pairs)
  {
    for (std::size_t i : { pair.First, pair.Second })
    {
      if (!nearest[i] || width(pair) < width(*nearest[i]))
      {
        nearest[i] = &pair;
      }
    }
  }
  HingesBelow hinges(this->Sums.Nearest);
  for (const NearPairs::Pair* pair : nearest)
  {
    if (pair)
    {
      hinges.Add(width(*pair));
    }
  }
  const double share = 1.0 / this->Spheres;
  std::vector<double> slopes;
  const double misfit = FindMisfit(this->Sums.Nearest, hinges.Values(share), slopes);
  if (gradient)
  {
    const std::vector<double> sums = SumsFrom(slopes);
    for (const NearPairs::Pair* pair : nearest)
    {
      if (pair)
      {
        AddAlong(*pair, -factor * share * sums[hinges.PlaceOf(width(*pair))], gradient);
      }
    }
  }
  return misfit;
}
}
