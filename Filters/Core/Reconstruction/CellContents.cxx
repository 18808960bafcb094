// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reconstruction/CellContents.h"

#include "Geometry/SphereOverlap.h"
#include "Text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ruc
{
namespace
{
// The nearest whole numbers to `share` of every mode's count
std::vector<int> RoundedCounts(const PackTotals& pack, double share)
{
  std::vector<int> counts;
  for (std::int64_t count : pack.Count)
  {
    counts.push_back(static_cast<int>(
      std::lround(std::min(count * share, double(std::numeric_limits<int>::max())))));
  }
  return counts;
}

CellContents MakeContents(const PackTotals& pack, double share)
{
  const double windowVolume = pack.Observed.Volume();
  CellContents contents;
  contents.Count = RoundedCounts(pack, share);
  double numerator = 0.0;
  double denominator = 0.0;
  for (std::size_t m = 0; m < pack.Count.size(); ++m)
  {
    if (contents.Count[m] < 1)
    {
      const std::int64_t rarest = *std::min_element(pack.Count.begin(), pack.Count.end());
      throw std::invalid_argument(
        Text("The cell requires at least one sphere of every mode, got none of mode ", m + 1, " (",
          pack.Count[m], " of the pack's ", pack.NumberOfSpheres, " spheres, ",
          pack.Count[m] * share, " in a cell of this size): set CellSize to ",
          1.0001 * std::cbrt(0.5 * windowVolume / rarest), " or more, or use fewer modes."));
    }
    const double cubedRadius = pack.Volume[m] / SphereVolume(1.0) / pack.Count[m];
    contents.Radius.push_back(std::cbrt(cubedRadius));
    const double fraction = pack.Volume[m] / windowVolume;
    const double volume = contents.Count[m] * cubedRadius; // n_i r_i^3
    numerator += volume * volume;
    denominator += fraction * volume;
  }
  contents.Edge = std::cbrt(SphereVolume(1.0) * numerator / denominator);
  const double diameter = 2.0 * *std::max_element(contents.Radius.begin(), contents.Radius.end());
  if (!(contents.Edge > diameter))
  {
    throw std::invalid_argument(
      Text("CellSize requires an edge longer than the largest sphere's diameter, ", diameter,
        ", got ", contents.Edge, "."));
  }
  return contents;
}
}

int CellContents::NumberOfSpheres() const
{
  return std::accumulate(this->Count.begin(), this->Count.end(), 0);
}

CellContents FindCellContents(const PackTotals& pack, double edge)
{
  return MakeContents(pack, edge * edge * edge / pack.Observed.Volume());
}

CellContents FindCellContents(const PackTotals& pack, int spheres)
{
  const auto total = [&](double share)
  {
    const std::vector<int> counts = RoundedCounts(pack, share);
    return std::accumulate(counts.begin(), counts.end(), 0.0);
  };
  // The sum of the rounded counts grows with the share: bisect for the least share that reaches it
  double low = 0.0;
  double high = 2.0 * (spheres + pack.Count.size()) / pack.NumberOfSpheres;
  for (int step = 0; step < 100; ++step)
  {
    const double middle = 0.5 * (low + high);
    (total(middle) < spheres ? low : high) = middle;
  }
  return MakeContents(pack, high);
}

double OnePointDifference(
  const CellContents& contents, const std::vector<double>& packFractions, double edge)
{
  double sum = 0.0;
  for (std::size_t m = 0; m < contents.Count.size(); ++m)
  {
    const double difference = packFractions[m] -
      contents.Count[m] * SphereVolume(contents.Radius[m]) / (edge * edge * edge);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}
}
