// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/ParticleModes.h"

#include "Geometry/SphereOverlap.h"
#include "Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
// Diameters closer than this, relatively, are one size
constexpr double SameSize = 1e-9;

// The functions below return where the modes 2, 3, … begin; `diameters` ascend.

std::vector<double> EqualWidthEdges(const std::vector<double>& diameters, int modes)
{
  std::vector<double> edges;
  const double width = (diameters.back() - diameters.front()) / modes;
  for (int m = 1; m < modes; ++m)
  {
    edges.push_back(diameters.front() + m * width);
  }
  return edges;
}

std::vector<double> EqualVolumeEdges(const std::vector<double>& diameters, int modes)
{
  double total = 0.0;
  for (double d : diameters)
  {
    total += d * d * d;
  }
  std::vector<double> edges;
  double below = 0.0;
  for (std::size_t i = 0; i < diameters.size(); ++i)
  {
    // A sphere belongs to the share in which the middle of its volume lies
    const double volume = diameters[i] * diameters[i] * diameters[i];
    if (below + 0.5 * volume >= total * (edges.size() + 1) / modes &&
      static_cast<int>(edges.size()) + 1 < modes)
    {
      edges.push_back(diameters[i]);
    }
    below += volume;
  }
  return edges;
}

std::vector<double> GivenEdges(
  const std::vector<double>& diameters, const std::vector<double>& edges)
{
  // written so that an edge that is no number fails
  const bool ascending = std::adjacent_find(edges.begin(), edges.end(),
                           [](double a, double b) { return !(a < b); }) == edges.end();
  if (edges.size() < 2 || !ascending || !(edges.front() >= 0.0) || !std::isfinite(edges.back()))
  {
    std::string got;
    for (double edge : edges)
    {
      got += Text(got.empty() ? "" : " ", edge);
    }
    throw std::invalid_argument(
      Text("Edges requires two or more ascending finite diameters >= 0, got ",
        got.empty() ? "none" : got, "."));
  }
  if (diameters.front() < edges.front() || diameters.back() > edges.back())
  {
    throw std::invalid_argument(Text("Edges requires every diameter between its first and last, ",
      edges.front(), " and ", edges.back(), ", got diameters from ", diameters.front(), " to ",
      diameters.back(), " (MinimumDiameter leaves small spheres out)."));
  }
  return { edges.begin() + 1, edges.end() - 1 };
}

std::vector<double> SizeEdges(const std::vector<double>& diameters)
{
  std::vector<double> edges;
  double size = diameters.front();
  for (double d : diameters)
  {
    if (d > size * (1.0 + SameSize))
    {
      edges.push_back(d);
      size = d;
    }
    if (edges.size() >= static_cast<std::size_t>(MostModes))
    {
      throw std::invalid_argument(Text(
        "Method 'One Per Size' requires at most ", MostModes, " distinct diameters, got more."));
    }
  }
  return edges;
}
}

ParticleModes::ParticleModes(std::vector<double> diameters, const ModeSettings& settings)
  : MinimumDiameter(settings.MinimumDiameter)
{
  if (!(settings.MinimumDiameter >= 0.0 && std::isfinite(settings.MinimumDiameter)))
  {
    throw std::invalid_argument(
      Text("MinimumDiameter requires a finite number >= 0, got ", settings.MinimumDiameter, "."));
  }
  const bool counted =
    settings.Method == ModeMethod::EqualWidth || settings.Method == ModeMethod::EqualVolume;
  if (counted && (settings.NumberOfModes < 1 || settings.NumberOfModes > MostModes))
  {
    throw std::invalid_argument(Text("NumberOfModes requires 1 <= NumberOfModes <= ", MostModes,
      ", got ", settings.NumberOfModes, "."));
  }
  if (settings.Edges.size() > MostModes + 1u)
  {
    throw std::invalid_argument(Text(
      "Edges requires at most ", MostModes + 1, " diameters, got ", settings.Edges.size(), "."));
  }
  const double largest =
    diameters.empty() ? 0.0 : *std::max_element(diameters.begin(), diameters.end());
  diameters.erase(std::remove_if(diameters.begin(), diameters.end(),
                    [&](double d) { return d < this->MinimumDiameter; }),
    diameters.end());
  if (diameters.empty())
  {
    throw std::invalid_argument(
      Text("MinimumDiameter requires a value that leaves at least one sphere, got ",
        settings.MinimumDiameter, " with diameters up to ", largest, "."));
  }
  std::sort(diameters.begin(), diameters.end());
  std::vector<double> edges = settings.Method == ModeMethod::EqualWidth
    ? EqualWidthEdges(diameters, settings.NumberOfModes)
    : settings.Method == ModeMethod::EqualVolume
    ? EqualVolumeEdges(diameters, settings.NumberOfModes)
    : settings.Method == ModeMethod::ExplicitEdges ? GivenEdges(diameters, settings.Edges)
                                                   : SizeEdges(diameters);
  edges.push_back(INFINITY);
  auto begin = diameters.begin();
  for (double edge : edges)
  {
    const auto end = std::lower_bound(begin, diameters.end(), edge);
    if (begin == end)
    {
      continue; // an empty mode
    }
    if (!this->Summaries.empty())
    {
      this->LowerEdges.push_back(*begin);
    }
    ModeSummary summary;
    summary.Count = end - begin;
    summary.MinimumDiameter = *begin;
    summary.MaximumDiameter = *(end - 1);
    for (auto d = begin; d != end; ++d)
    {
      summary.Volume += SphereVolume(0.5 * *d);
    }
    summary.VolumeMeanDiameter =
      2.0 * std::cbrt(summary.Volume / summary.Count / SphereVolume(1.0));
    this->Summaries.push_back(summary);
    begin = end;
  }
}

int ParticleModes::ModeOf(double diameter) const
{
  return diameter < this->MinimumDiameter ? 0
                                          : 1 +
      static_cast<int>(
        std::upper_bound(this->LowerEdges.begin(), this->LowerEdges.end(), diameter) -
        this->LowerEdges.begin());
}
}
