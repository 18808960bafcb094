// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/PackSpectrum.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <numeric>

namespace ruc
{
namespace
{
constexpr int LeastCentres = 100;

ThirdOrderSettings FindSettings(double cutOff)
{
  ThirdOrderSettings settings;
  settings.CutOff = cutOff;
  settings.MaximumDegree = HighestOfSpectrum;
  settings.WithEta = false;
  settings.Slabs = 1;
  settings.WithFarField = false;
  return settings;
}
}

double SpectrumCutOff(double meanDiameter, double largestDiameter, double fraction)
{
  return std::max(
    0.75 * AutomaticCutOff(meanDiameter, largestDiameter, fraction), 2.0 * largestDiameter);
}

PackSpectrum MeasureSpectrum(const PackShare& share, const char* name, Communicator& ranks)
{
  const double volume = std::accumulate(share.Volume.begin(), share.Volume.end(), 0.0);
  PackSpectrum spectrum;
  spectrum.CutOff = SpectrumCutOff(
    share.MeanDiameter(), 2.0 * share.LargestRadius, volume / share.Observed.Volume());
  const std::string inside =
    Text(LeastCentres, " spheres at least ", spectrum.CutOff, " from every face of the window");
  Require(share.Observed.IsFullyPeriodic() ||
      2.0 * spectrum.CutOff < 0.999 * share.Observed.ShortestEdge(),
    name, inside, "none");
  ThirdOrderSettings settings = FindSettings(spectrum.CutOff);
  settings.Name = name;
  const ThirdOrderOfSpheres found = MeasureThirdOrder(share, settings, ranks);
  Require(found.Centres >= LeastCentres, name, inside, found.Centres);
  for (int l = LowestOfSpectrum; l <= HighestOfSpectrum; ++l)
  {
    const ThirdOrderFigure& figure = found.Spectrum[l - LowestOfSpectrum];
    Require(figure.Error > 1e-9 * figure.Value, name, "a pack that differs from place to place",
      "one without scatter");
    spectrum.Value.push_back(figure.Value);
    spectrum.Error.push_back(figure.Error);
  }
  spectrum.Zeta = found.Spheres.Zeta.Value;
  spectrum.ZetaError = found.Spheres.Zeta.Error;
  return spectrum;
}

double MeasureZeta(const SpherePack& cell, const Window& box, const PackSpectrum& spectrum)
{
  Communicator alone;
  return MeasureThirdOrder(SharePack(cell, box), FindSettings(spectrum.CutOff), alone)
    .Spheres.Zeta.Value;
}

Estimate EstimateSpectrum(const PackFigures& pack)
{
  const double fraction = pack.Density() * SphereVolume(0.5 * pack.MeanDiameter);
  return EstimateThirdOrder(
    pack, FindSettings(SpectrumCutOff(pack.MeanDiameter, 2.0 * pack.LargestRadius, fraction)));
}
}
