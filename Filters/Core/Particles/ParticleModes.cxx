// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/ParticleModes.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
// Diameters closer than this, relatively, are one size
constexpr double SameSize = 1e-9;

// The least and greatest diameter on all ranks
struct Extremes
{
  double Least, Greatest;
};

Extremes FindExtremes(const std::vector<double>& diameters, Communicator& ranks)
{
  double values[2] = { INFINITY, INFINITY };
  for (double d : diameters)
  {
    values[0] = std::min(values[0], d);
    values[1] = std::min(values[1], -d);
  }
  ranks.Minimum(values, 2);
  return { values[0], -values[1] };
}

// The functions below return where the modes 2, 3, … begin; `diameters` ascend.

std::vector<double> EqualWidthEdges(const Extremes& all, int modes)
{
  std::vector<double> edges;
  const double width = (all.Greatest - all.Least) / modes;
  for (int m = 1; m < modes; ++m)
  {
    edges.push_back(all.Least + m * width);
  }
  return edges;
}

std::vector<double> EqualVolumeEdges(const std::vector<double>& own, int modes, Communicator& ranks)
{
  std::vector<double> diameters = ranks.Concatenate(own);
  std::sort(diameters.begin(), diameters.end());
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

std::vector<double> GivenEdges(const Extremes& all, const std::vector<double>& edges)
{
  // Written so that an edge that is no number fails
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
  if (all.Least < edges.front() || all.Greatest > edges.back())
  {
    throw std::invalid_argument(Text("Edges requires every diameter between its first and last, ",
      edges.front(), " and ", edges.back(), ", got diameters from ", all.Least, " to ",
      all.Greatest, " (MinimumDiameter leaves small spheres out)."));
  }
  return { edges.begin() + 1, edges.end() - 1 };
}

std::vector<double> SizeEdges(
  const std::vector<double>& diameters, const Extremes& all, Communicator& ranks)
{
  std::vector<double> edges;
  for (double size = all.Least;;)
  {
    const auto next = std::upper_bound(diameters.begin(), diameters.end(), size * (1.0 + SameSize));
    size = next == diameters.end() ? INFINITY : *next;
    ranks.Minimum(&size, 1);
    if (size == INFINITY)
    {
      return edges;
    }
    edges.push_back(size);
    if (edges.size() >= static_cast<std::size_t>(MostModes))
    {
      throw std::invalid_argument(Text(
        "Method 'One Per Size' requires at most ", MostModes, " distinct diameters, got more."));
    }
  }
}

void CheckSettings(const ModeSettings& settings)
{
  Require(settings.MinimumDiameter >= 0.0 && std::isfinite(settings.MinimumDiameter),
    "MinimumDiameter", "a finite number >= 0", settings.MinimumDiameter);
  const bool counted =
    settings.Method == ModeMethod::EqualWidth || settings.Method == ModeMethod::EqualVolume;
  Require(!counted || (settings.NumberOfModes >= 1 && settings.NumberOfModes <= MostModes),
    "NumberOfModes", Text("1 <= NumberOfModes <= ", MostModes), settings.NumberOfModes);
  Require(settings.Edges.size() <= MostModes + 1u, "Edges",
    Text("at most ", MostModes + 1, " diameters"), settings.Edges.size());
}

std::vector<double> FindEdges(const std::vector<double>& diameters, const Extremes& all,
  const ModeSettings& settings, Communicator& ranks)
{
  switch (settings.Method)
  {
    case ModeMethod::EqualWidth:
      return EqualWidthEdges(all, settings.NumberOfModes);
    case ModeMethod::EqualVolume:
      return EqualVolumeEdges(diameters, settings.NumberOfModes, ranks);
    case ModeMethod::ExplicitEdges:
      return GivenEdges(all, settings.Edges);
    case ModeMethod::OnePerSize:
      break;
  }
  return SizeEdges(diameters, all, ranks);
}

// Summarises the modes between the edges, and leaves out those without spheres
std::vector<ModeSummary> Summarise(const std::vector<double>& diameters,
  const std::vector<double>& edges, double greatest, Communicator& ranks)
{
  // For every mode: where its diameters end, and the least and minus the greatest of them
  const std::size_t modes = edges.size() + 1;
  std::vector<std::vector<double>::const_iterator> ends = { diameters.begin() };
  std::vector<double> extremes(2 * modes, INFINITY);
  for (std::size_t m = 0; m < modes; ++m)
  {
    const auto begin = ends.back();
    ends.push_back(
      m < edges.size() ? std::lower_bound(begin, diameters.end(), edges[m]) : diameters.end());
    if (begin != ends.back())
    {
      extremes[2 * m] = *begin;
      extremes[2 * m + 1] = -*(ends.back() - 1);
    }
  }
  ranks.Minimum(extremes.data(), extremes.size());
  // For every mode: its count, and the sum of d^3 in fixed point. The unit is the greatest diameter
  // of all; if a whole mode is so much smaller that too few digits would be left, it is the
  // greatest of the mode
  constexpr double scale = 0x1p50, muchSmaller = 0x1p-10;
  const auto unitOf = [&](std::size_t m)
  {
    const double ofMode = -extremes[2 * m + 1];
    return ofMode < muchSmaller * greatest ? ofMode : greatest;
  };
  std::vector<std::int64_t> sums(3 * modes, 0);
  for (std::size_t m = 0; m < modes; ++m)
  {
    sums[3 * m] = ends[m + 1] - ends[m];
    for (auto d = ends[m]; d != ends[m + 1]; ++d)
    {
      const double ratio = *d / unitOf(m);
      AddWide(RoundToFixedPoint(scale * ratio * ratio * ratio), &sums[3 * m + 1]);
    }
  }
  ranks.Sum(sums.data(), sums.size());
  std::vector<ModeSummary> summaries;
  for (std::size_t m = 0; m < modes; ++m)
  {
    if (sums[3 * m] == 0)
    {
      continue;
    }
    ModeSummary summary;
    summary.Count = static_cast<std::size_t>(sums[3 * m]);
    summary.MinimumDiameter = extremes[2 * m];
    summary.MaximumDiameter = -extremes[2 * m + 1];
    summary.Volume = SphereVolume(0.5 * unitOf(m)) * (WideValue(&sums[3 * m + 1]) / scale);
    summary.VolumeMeanDiameter =
      2.0 * std::cbrt(summary.Volume / summary.Count / SphereVolume(1.0));
    summaries.push_back(summary);
  }
  return summaries;
}
}

ParticleModes::ParticleModes(std::vector<double> diameters, const ModeSettings& settings)
{
  Communicator serial;
  *this = ParticleModes(std::move(diameters), settings, serial);
}

ParticleModes::ParticleModes(
  std::vector<double> diameters, const ModeSettings& settings, Communicator& ranks)
  : MinimumDiameter(settings.MinimumDiameter)
{
  CheckSettings(settings);
  const double largest = std::max(FindExtremes(diameters, ranks).Greatest, 0.0);
  diameters.erase(std::remove_if(diameters.begin(), diameters.end(),
                    [&](double d) { return d < this->MinimumDiameter; }),
    diameters.end());
  const Extremes all = FindExtremes(diameters, ranks);
  if (!(all.Least <= all.Greatest))
  {
    throw std::invalid_argument(
      Text("MinimumDiameter requires a value that leaves at least one sphere, got ",
        settings.MinimumDiameter, " with diameters up to ", largest, "."));
  }
  std::sort(diameters.begin(), diameters.end());
  this->Summaries =
    Summarise(diameters, FindEdges(diameters, all, settings, ranks), all.Greatest, ranks);
  for (std::size_t m = 1; m < this->Summaries.size(); ++m)
  {
    this->LowerEdges.push_back(this->Summaries[m].MinimumDiameter);
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

Estimate EstimateModes(double spheres, ModeMethod method)
{
  constexpr double SecondsPerSphere = 5e-7;
  constexpr double BytesPerSphere = 200.0; // to read, sort and hand it on
  // Every rank has the diameters of all, as they come and put together
  const double gathered = method == ModeMethod::EqualVolume ? 2.0 * sizeof(double) : 0.0;
  return { spheres * SecondsPerSphere, spheres * gathered / BytesOfMegabyte,
    spheres * BytesPerSphere / BytesOfMegabyte };
}
}
