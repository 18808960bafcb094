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
struct ModeTotals
{
  std::vector<std::size_t> Count;
  std::vector<double> CubedRadius; // mean of r^3
};

ModeTotals TotalModes(const SpherePack& pack)
{
  ModeTotals totals;
  totals.Count.resize(pack.NumberOfModes(), 0);
  totals.CubedRadius.resize(pack.NumberOfModes(), 0.0);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    ++totals.Count[pack.Mode[i] - 1];
    totals.CubedRadius[pack.Mode[i] - 1] += pack.Radius[i] * pack.Radius[i] * pack.Radius[i];
  }
  for (std::size_t m = 0; m < totals.Count.size(); ++m)
  {
    totals.CubedRadius[m] /= totals.Count[m];
  }
  return totals;
}

// The nearest whole numbers to `share` of every mode's count
std::vector<int> RoundedCounts(const ModeTotals& totals, double share)
{
  std::vector<int> counts;
  for (std::size_t count : totals.Count)
  {
    counts.push_back(static_cast<int>(
      std::lround(std::min(count * share, double(std::numeric_limits<int>::max())))));
  }
  return counts;
}

CellContents MakeContents(
  const SpherePack& pack, const Window& window, const ModeTotals& totals, double share)
{
  CellContents contents;
  contents.Count = RoundedCounts(totals, share);
  double numerator = 0.0;
  double denominator = 0.0;
  for (std::size_t m = 0; m < totals.Count.size(); ++m)
  {
    if (contents.Count[m] < 1)
    {
      const std::size_t rarest = *std::min_element(totals.Count.begin(), totals.Count.end());
      throw std::invalid_argument(
        Text("The cell requires at least one sphere of every mode, got none of mode ", m + 1, " (",
          totals.Count[m], " of the pack's ", pack.Size(), " spheres, ", totals.Count[m] * share,
          " in a cell of this size): set CellSize to ",
          1.0001 * std::cbrt(0.5 * window.Volume() / rarest), " or more, or use fewer modes."));
    }
    contents.Radius.push_back(std::cbrt(totals.CubedRadius[m]));
    const double fraction = totals.Count[m] * SphereVolume(contents.Radius[m]) / window.Volume();
    const double volume = contents.Count[m] * totals.CubedRadius[m]; // n_i r_i^3
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

CellContents FindCellContents(const SpherePack& pack, const Window& window, double edge)
{
  return MakeContents(pack, window, TotalModes(pack), edge * edge * edge / window.Volume());
}

CellContents FindCellContents(const SpherePack& pack, const Window& window, int spheres)
{
  const ModeTotals totals = TotalModes(pack);
  const auto total = [&](double share)
  {
    const std::vector<int> counts = RoundedCounts(totals, share);
    return std::accumulate(counts.begin(), counts.end(), 0.0);
  };
  // The sum of the rounded counts grows with the share: bisect for the least share that reaches it
  double low = 0.0;
  double high = 2.0 * (spheres + totals.Count.size()) / pack.Size();
  for (int step = 0; step < 100; ++step)
  {
    const double middle = 0.5 * (low + high);
    (total(middle) < spheres ? low : high) = middle;
  }
  return MakeContents(pack, window, totals, high);
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
