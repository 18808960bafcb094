// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellStart.h"

#include "ruc/Base/Random.h"
#include "ruc/Base/Text.h"
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/MaximumFraction.h"
#include "ruc/Packing/SphereRooms.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ruc
{
namespace
{
// Jammed spheres cannot be moved and freed again: their cell gets so much more room
constexpr double RoomOfJammed = 1.0003; // of the edge
// What is denser than random packs are on average jams also where it grows more slowly
constexpr double RateOfDensest = 0.003;

// `gaps` says what the spheres are enlarged by
bool IsDense(
  const std::vector<double>& radii, double fraction, double edge, const std::string& gaps)
{
  const double maximum = MaximumRandomFraction(radii);
  if (fraction > maximum + 0.015)
  {
    throw std::invalid_argument(Text("A cell of these spheres", gaps, " would have a fraction of ",
      fraction, ", which is more than random packs of these sizes reach (about ", maximum, ")."));
  }
  const double largest = 2.0 * *std::max_element(radii.begin(), radii.end());
  return radii.size() > 1 && fraction > DenseShare * maximum &&
    edge > SphereRooms::LeastEdgeInDiameters * largest * (1.0 + 1e-6);
}
}

std::vector<double> RandomCentres(
  const CellContents& contents, std::uint32_t seed, std::uint32_t number)
{
  std::vector<double> centres;
  for (int i = 0; i < contents.NumberOfSpheres(); ++i)
  {
    for (double u : UniformTriple(
           seed, RandomStream::CellCentres, std::uint64_t(number) << 32 | std::uint32_t(i)))
    {
      centres.push_back(contents.Edge * u);
    }
  }
  return centres;
}

bool IsDense(const std::vector<double>& radii, double fraction, double edge)
{
  return IsDense(radii, fraction, edge, {});
}

bool IsDense(const CellContents& contents)
{
  const CellContents enlarged = contents.Enlarged();
  return IsDense(enlarged.Radii(), enlarged.Fraction(), contents.Edge,
    contents.Gap.IsNone() ? "" : ", enlarged by MinimumGap and MinimumGapShare,");
}

void RequireLoose(const CellContents& contents)
{
  // Above this share of the maximum spheres that are pushed apart jam
  constexpr double most = 0.98;
  const double fraction = contents.Fraction(), maximum = MaximumRandomFraction(contents.Radii());
  if (fraction > most * maximum)
  {
    throw std::invalid_argument(Text("Method requires Gradient for a cell as dense as this one, of "
                                     "a fraction of ",
      fraction, " where random packs of these sizes reach about ", maximum,
      ": the cells of a population would keep overlap."));
  }
}

std::vector<double> DenseCentres(
  CellContents& contents, std::uint32_t seed, const std::function<bool()>& carryOn)
{
  DensePackSettings settings;
  const CellContents enlarged = contents.Enlarged();
  settings.Radii = enlarged.Radii();
  settings.Fraction = enlarged.Fraction();
  settings.Seed = seed;
  settings.Protocol = PackingProtocol::Events;
  settings.Rate = settings.Fraction > MaximumRandomFraction(settings.Radii) ? RateOfDensest : 0.0;
  const DensePack made =
    MakeDensePack(settings, [&](const GrowthStep&, double) { return carryOn(); });
  if (made.Pack.Empty())
  {
    return RandomCentres(contents, seed, 0);
  }
  if (made.Jammed)
  {
    contents.Edge = std::min(RoomOfJammed * made.Box.Size[0], LongestEdge * contents.Edge);
  }
  std::vector<double> centres = CentresOf(made.Pack);
  for (double& c : centres)
  {
    c *= contents.Edge / made.Box.Size[0];
  }
  return centres;
}

Estimate EstimateDenseStart(const CellFigures& cell)
{
  constexpr double MostInSample = 2000.0;
  DensePackSettings settings;
  settings.Protocol = PackingProtocol::Events;
  settings.Fraction = 0.0;
  for (std::size_t mode = 0; mode < cell.Share.size() && mode < cell.Radius.size(); ++mode)
  {
    const double spheres = std::min(cell.Spheres, MostInSample) * cell.Share[mode];
    settings.Radii.insert(
      settings.Radii.end(), std::max(1, static_cast<int>(spheres)), cell.Radius[mode]);
    settings.Fraction += cell.Density * cell.Share[mode] * SphereVolume(cell.Radius[mode]);
  }
  const double edge = std::cbrt(cell.Spheres / cell.Density);
  return !settings.Radii.empty() && IsDense(settings.Radii, settings.Fraction, edge)
    ? EstimateDensePack(settings, cell.Spheres)
    : Estimate();
}
}
