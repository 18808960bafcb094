// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellContents.h"

#include "ruc/Base/Text.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ruc
{
namespace
{
// The nearest whole numbers of spheres in a volume
std::vector<int> RoundedCounts(const ModeAmounts& amounts, double volume)
{
  std::vector<int> counts;
  for (double number : amounts.Number)
  {
    counts.push_back(static_cast<int>(
      std::lround(std::min(number * volume, double(std::numeric_limits<int>::max())))));
  }
  return counts;
}

CellContents ContentsOfVolume(const ModeAmounts& amounts, double volume)
{
  const std::vector<int> counts = RoundedCounts(amounts, volume);
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    if (counts[m] < 1)
    {
      const double rarest = *std::min_element(amounts.Number.begin(), amounts.Number.end());
      throw std::invalid_argument(
        Text("The cell requires at least one sphere of every mode, got none of mode ", m + 1, " (",
          amounts.Number[m] * volume, " in a cell of this size): set CellSize to ",
          1.0001 * std::cbrt(0.5 / rarest), " or more, or use fewer modes."));
    }
  }
  return FindCellContents(amounts, counts);
}

// The radii of a mode's spheres on all ranks, in their order
std::vector<double> RadiiOfMode(const PackShare& pack, int mode, Communicator& ranks)
{
  std::vector<double> radii;
  for (std::size_t i = 0; i < pack.Own.Size(); ++i)
  {
    if (pack.Own.Mode.empty() || pack.Own.Mode[i] == mode)
    {
      radii.push_back(pack.Own.Radius[i]);
    }
  }
  radii = ranks.Concatenate(radii);
  std::sort(radii.begin(), radii.end());
  return radii;
}

// The k-th of the places that cut `all` into equal parts
int CutAt(int all, int k, int parts)
{
  return static_cast<int>(std::int64_t(all) * k / parts);
}

// The volume mean of the radii, which are in their order, from one share of their number to another
double VolumeMean(const std::vector<double>& radii, double from, double to)
{
  const double all = static_cast<double>(radii.size());
  const auto first = static_cast<std::size_t>(std::max(std::floor(from * all) - 1.0, 0.0));
  const auto last = static_cast<std::size_t>(std::min(std::ceil(to * all) + 1.0, all));
  double cubes = 0.0;
  for (std::size_t i = first; i < last; ++i)
  {
    const double begin = std::max(i / all, from);
    const double end = std::min((i + 1) / all, to);
    cubes += std::max(end - begin, 0.0) * std::pow(radii[i], 3);
  }
  return std::cbrt(cubes / (to - from));
}
}

ModeAmounts::ModeAmounts(const PackTotals& pack)
{
  for (std::size_t m = 0; m < pack.Count.size(); ++m)
  {
    this->Number.push_back(pack.Count[m] / pack.Observed.Volume());
    this->Radius.push_back(std::cbrt(pack.Volume[m] / SphereVolume(1.0) / pack.Count[m]));
  }
}

ModeAmounts::ModeAmounts(const std::vector<double>& fractions, const std::vector<double>& diameters)
{
  if (diameters.empty() || diameters.size() != fractions.size())
  {
    throw std::invalid_argument(Text("ModeDiameters requires a diameter for each of the ",
      fractions.size(), " modes, got ", diameters.size(), "."));
  }
  double sum = 0.0;
  for (std::size_t m = 0; m < fractions.size(); ++m)
  {
    if (!(diameters[m] > 0.0 && std::isfinite(diameters[m])))
    {
      throw std::invalid_argument(Text(
        "ModeDiameters requires finite numbers > 0, got ", diameters[m], " for mode ", m + 1, "."));
    }
    sum += fractions[m];
    if (!(fractions[m] > 0.0 && sum < 1.0))
    {
      throw std::invalid_argument(Text("Volume fractions require numbers > 0 with a sum < 1, got ",
        fractions[m], " of mode ", m + 1, " and a sum of ", sum, "."));
    }
    this->Radius.push_back(0.5 * diameters[m]);
    this->Number.push_back(fractions[m] / SphereVolume(this->Radius.back()));
  }
}

double ModeAmounts::Fraction(int mode) const
{
  return this->Number[mode] * SphereVolume(this->Radius[mode]);
}

double ModeAmounts::MeanDiameter() const
{
  double cubes = 0.0, number = 0.0;
  for (int m = 0; m < this->NumberOfModes(); ++m)
  {
    cubes += this->Number[m] * std::pow(2.0 * this->Radius[m], 3);
    number += this->Number[m];
  }
  return std::cbrt(cubes / number);
}

int CellContents::NumberOfSpheres() const
{
  return std::accumulate(this->Count.begin(), this->Count.end(), 0);
}

int CellContents::NumberOfModes() const
{
  return this->ModeOf(static_cast<int>(this->Count.size()) - 1);
}

CellContents CellContents::Enlarged() const
{
  CellContents enlarged = *this;
  for (double& radius : enlarged.Radius)
  {
    radius = this->Gap.Enlarged(radius);
  }
  enlarged.Gap = {};
  return enlarged;
}

double CellContents::Fraction() const
{
  double volume = 0.0;
  for (double r : this->Radii())
  {
    volume += SphereVolume(r);
  }
  return volume / (this->Edge * this->Edge * this->Edge);
}

std::vector<double> CellContents::Radii() const
{
  std::vector<double> radii;
  for (std::size_t m = 0; m < this->Count.size(); ++m)
  {
    radii.insert(radii.end(), this->Count[m], this->Radius[m]);
  }
  return radii;
}

Window CellContents::MakeBox() const
{
  return Window::MakeBox(
    { 0.0, 0.0, 0.0 }, { this->Edge, this->Edge, this->Edge }, { true, true, true });
}

SpherePack CellContents::MakePack(const double* centres) const
{
  SpherePack pack;
  for (std::size_t m = 0; m < this->Count.size(); ++m)
  {
    pack.Mode.insert(pack.Mode.end(), this->Count[m], this->ModeOf(static_cast<int>(m)));
    pack.Radius.insert(pack.Radius.end(), this->Count[m], this->Radius[m]);
  }
  pack.X.resize(pack.Mode.size());
  pack.Y.resize(pack.Mode.size());
  pack.Z.resize(pack.Mode.size());
  SetCentres(pack, this->MakeBox(), centres);
  return pack;
}

CellContents FindCellContents(const ModeAmounts& amounts, double edge)
{
  return ContentsOfVolume(amounts, edge * edge * edge);
}

CellContents FindCellContents(const ModeAmounts& amounts, int spheres)
{
  const auto total = [&](double volume)
  {
    const std::vector<int> counts = RoundedCounts(amounts, volume);
    return std::accumulate(counts.begin(), counts.end(), 0.0);
  };
  // The sum of the rounded counts grows with the volume: bisect for the least that reaches it
  double low = 0.0;
  double high = 2.0 * (spheres + amounts.NumberOfModes()) /
    std::accumulate(amounts.Number.begin(), amounts.Number.end(), 0.0);
  for (int step = 0; step < 100; ++step)
  {
    const double middle = 0.5 * (low + high);
    (total(middle) < spheres ? low : high) = middle;
  }
  return ContentsOfVolume(amounts, high);
}

CellContents FindCellContents(const ModeAmounts& amounts, const std::vector<int>& counts)
{
  if (counts.size() != amounts.Number.size())
  {
    throw std::invalid_argument(Text("ModeCounts requires a number for each of the ",
      amounts.Number.size(), " modes, got ", counts.size(), "."));
  }
  CellContents contents;
  contents.Count = counts;
  contents.Radius = amounts.Radius;
  double numerator = 0.0, denominator = 0.0;
  for (std::size_t m = 0; m < counts.size(); ++m)
  {
    if (counts[m] < 1)
    {
      throw std::invalid_argument(
        Text("ModeCounts requires numbers >= 1, got ", counts[m], " for mode ", m + 1, "."));
    }
    const double volume = counts[m] * std::pow(amounts.Radius[m], 3); // n_i r_i^3
    numerator += volume * volume;
    denominator += amounts.Fraction(static_cast<int>(m)) * volume;
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

CellContents DivideModes(
  const CellContents& contents, int diameters, const PackShare& pack, Communicator& ranks)
{
  CellContents divided = contents;
  divided.Count.clear();
  divided.Radius.clear();
  divided.Mode.clear();
  for (int m = 0; m < contents.NumberOfModes(); ++m)
  {
    const int spheres = contents.Count[m];
    const std::vector<double> sizes = RadiiOfMode(pack, m + 1, ranks);
    const int types = static_cast<int>(
      std::min<std::size_t>(diameters == 0 ? spheres : std::min(diameters, spheres), sizes.size()));
    double volume = 0.0; // of the spheres, in cubes of radii
    for (int t = 0; t < types; ++t)
    {
      const int first = CutAt(spheres, t, types), last = CutAt(spheres, t + 1, types);
      divided.Count.push_back(last - first);
      divided.Radius.push_back(VolumeMean(sizes, first / double(spheres), last / double(spheres)));
      divided.Mode.push_back(m + 1);
      volume += (last - first) * std::pow(divided.Radius.back(), 3);
    }
    const double scale = contents.Radius[m] * std::cbrt(spheres / volume);
    std::for_each(
      divided.Radius.end() - types, divided.Radius.end(), [&](double& radius) { radius *= scale; });
  }
  return divided;
}

double OnePointDifference(
  const CellContents& contents, const std::vector<double>& packFractions, double edge)
{
  std::vector<double> differences = packFractions;
  for (std::size_t t = 0; t < contents.Count.size(); ++t)
  {
    differences[contents.ModeOf(static_cast<int>(t)) - 1] -=
      contents.Count[t] * SphereVolume(contents.Radius[t]) / (edge * edge * edge);
  }
  double sum = 0.0;
  for (int m = 0; m < contents.NumberOfModes(); ++m)
  {
    sum += differences[m] * differences[m];
  }
  return std::sqrt(sum);
}
}
