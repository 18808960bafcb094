// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include "ruc/Base/Range.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Results/Jackknife.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/ThirdOrder/MultipoleSums.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderParameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int MostSources = 32;
constexpr double MostOverlapPercent = 0.01;
constexpr double DeepestOverlap = 0.1;
// With alpha CutOff = 3.2 both parts of Ewald's sum end at some 10^-4 of the field. A longer
// cut-off keeps alpha, so that the accuracy grows with it.
constexpr double EwaldSharpness = 3.2;
constexpr double MostEwaldTerms = 4e9; // spheres times wave vectors
constexpr double MostWaves = 5e5;
constexpr double MostNeighbours = 1e5;

double SphereFraction(const PackShare& share)
{
  return std::accumulate(share.Volume.begin(), share.Volume.end(), 0.0) / share.Observed.Volume();
}

void CheckSettings(const ThirdOrderSettings& settings)
{
  Range::AtLeast(0.0).Check("CutOff", settings.CutOff);
  Range::From(4, GreatestDegree).Check("MaximumDegree", settings.MaximumDegree);
  Range::From(2, 1000).Check("Blocks", settings.Blocks);
  Range::From(1, 100).Check("Slabs", settings.Slabs);
}

// Values from sums over centres, and their errors by leaving out one block at a time
using Values = std::vector<double>;

template <class Evaluate>
std::vector<ThirdOrderFigure> Jackknife(const std::vector<Values>& blocks, Evaluate&& evaluate)
{
  Values whole(blocks.front().size(), 0.0);
  for (const Values& block : blocks)
  {
    std::transform(block.begin(), block.end(), whole.begin(), whole.begin(), std::plus<>());
  }
  std::vector<Values> without;
  for (const Values& block : blocks)
  {
    Values rest(whole.size());
    std::transform(whole.begin(), whole.end(), block.begin(), rest.begin(), std::minus<>());
    without.push_back(evaluate(rest));
  }
  std::vector<ThirdOrderFigure> figures;
  for (const double value : evaluate(whole))
  {
    Values ofFigure;
    for (const Values& values : without)
    {
      ofFigure.push_back(values[figures.size()]);
    }
    figures.push_back({ value, JackknifeError(ofFigure) });
  }
  return figures;
}

// I or J of all triples of phases, the matrix included, from those of the sources. `all` is the
// value of sum over q of I_qrr / (c_r (1 - c_r)).
Values WithMatrix(int sources, const double* values, const std::vector<double>& c, double all)
{
  const int m = sources, phases = sources + 1;
  Values triples(NumberOfTriples(phases), 0.0);
  const auto at = [&](int q, int r, int s) -> double&
  { return triples[PlaceOfTriple(phases, q, r, s)]; };
  for (int r = 0; r < sources; ++r)
  {
    for (int s = r; s < sources; ++s)
    {
      double sum = 0.0;
      for (int q = 0; q < sources; ++q)
      {
        at(q, r, s) = values[PlaceOfTriple(sources, q, r, s)];
        sum += at(q, r, s);
      }
      at(m, r, s) = all * ((r == s ? c[r] : 0.0) - c[r] * c[s]) - sum;
    }
  }
  // The fields of all phases add up to 0
  for (int q = 0; q < phases; ++q)
  {
    for (int r = 0; r < sources; ++r)
    {
      for (int s = 0; s < sources; ++s)
      {
        at(q, r, m) -= at(q, r, s);
      }
      at(q, m, m) -= at(q, r, m);
    }
  }
  return triples;
}
}

double AutomaticCutOff(double meanDiameter, double largestDiameter, double fraction)
{
  // Sparse spheres have their neighbours farther away
  const double sparse = std::max(1.0, std::cbrt(0.3 / fraction));
  return std::max(4.0 * meanDiameter * sparse, 2.5 * largestDiameter);
}

std::size_t ThirdOrderOfSpheres::PlaceOf(int q, int r, int s) const
{
  return PlaceOfTriple(this->Sources + 1, q, r, s);
}

namespace
{
// What the settings come to for a pack
MultipoleSettings FindSettings(const ThirdOrderSettings& settings, const Window& observed,
  double meanDiameter, double largestRadius, double fraction, double spheres, int sources)
{
  MultipoleSettings found;
  found.CutOff = settings.CutOff > 0.0
    ? settings.CutOff
    : AutomaticCutOff(meanDiameter, 2.0 * largestRadius, fraction);
  found.Degree = settings.MaximumDegree;
  found.Sources = sources;
  found.WithFourth = settings.WithEta;
  if (settings.WithFarField && observed.IsFullyPeriodic())
  {
    const double usual = AutomaticCutOff(meanDiameter, 2.0 * largestRadius, fraction);
    found.Alpha = EwaldSharpness / std::min(found.CutOff, usual);
    const double waves = ThirdOrderEwald::NumberOfWaves(observed, found);
    if (waves > MostWaves || waves * spheres > MostEwaldTerms)
    {
      found.Alpha = 0.0;
    }
  }
  return found;
}

void CheckPack(const PackShare& share, const ThirdOrderSettings& settings, Communicator& ranks)
{
  Require(!settings.ByMode || share.NumberOfModes() <= MostSources, "Phases",
    Text("at most ", MostSources, " modes as phases"), share.NumberOfModes());
  Require(settings.CutOff == 0.0 || settings.CutOff >= 4.0 * share.LargestRadius, "CutOff",
    Text("at least two diameters of the largest sphere, ", 4.0 * share.LargestRadius),
    settings.CutOff);
  const double density = static_cast<double>(share.NumberOfSpheres) / share.Observed.Volume();
  const double longest = std::cbrt(MostNeighbours / (SphereVolume(1.0) * density));
  Require(settings.CutOff <= longest, "CutOff",
    Text("at most ", longest, ", where a centre has some ", MostNeighbours, " neighbours"),
    settings.CutOff);
  const double fraction = SphereFraction(share);
  Require(fraction < 1.0, settings.Name, "spheres that fill less than the window",
    Text(100.0 * fraction, " %"));
  const PackOverlap overlap = MeasureOverlap(share, ranks);
  Require(overlap.Percent <= MostOverlapPercent, settings.Name,
    Text("spheres that overlap by at most ", MostOverlapPercent, " % of their volume"),
    Text(overlap.Percent, " %"));
  Require(overlap.Deepest <= DeepestOverlap, settings.Name,
    "pairs of spheres that overlap by at most a tenth of the sum of their radii", overlap.Deepest);
}

CentreRegion FindRegion(
  const PackShare& share, const ThirdOrderSettings& settings, const MultipoleSettings& found)
{
  const bool bounded = !share.Observed.IsFullyPeriodic();
  return CentreRegion(share.Observed, bounded ? found.CutOff : 0.0, settings);
}
}

namespace
{
// What follows from sums over centres (the sums of a block of SumLayout)
class Evaluation
{
public:
  Evaluation(const SumLayout& layout, const std::vector<double>& fractions)
    : Layout(layout)
    , Fractions(fractions)
    , Sources(static_cast<int>(fractions.size()) - 1)
    , OfSpheres(1.0 - fractions.back())
  {
  }

  // The spectrum, I and J of all triples, then zeta and eta of all spheres and of every phase
  Values operator()(const Values& sums) const
  {
    const double weight = sums[SumLayout::Weight()];
    Values values(sums.begin() + SumLayout::Spectrum(), sums.begin() + this->Layout.Second());
    for (double& value : values)
    {
      value /= weight * 2.0 * this->Fractions.back();
    }
    const Values second = this->Triples(sums, this->Layout.Second(), 1.0 / 9.0 / weight, 2.0 / 9.0);
    const Values fourth =
      this->Triples(sums, this->Layout.Fourth(), 7.0 / 1620.0 / weight, 8.0 / 225.0);
    values.insert(values.end(), second.begin(), second.end());
    values.insert(values.end(), fourth.begin(), fourth.end());
    // All spheres are what is not the matrix, and its field the opposite of that of the matrix
    const int m = this->Sources;
    double sum[2] = { 0.0, 0.0 };
    for (int q = 0; q < m; ++q)
    {
      sum[0] += second[PlaceOfTriple(m + 1, q, m, m)];
      sum[1] += fourth[PlaceOfTriple(m + 1, q, m, m)];
    }
    this->AddParameters({ this->OfSpheres, sum[0], sum[1] }, values);
    for (int r = 0; r <= m; ++r)
    {
      const std::size_t place = PlaceOfTriple(m + 1, r, r, r);
      this->AddParameters({ this->Fractions[r], second[place], fourth[place] }, values);
    }
    return values;
  }

private:
  Values Triples(const Values& sums, std::size_t begin, double factor, double all) const
  {
    Values own(sums.begin() + begin, sums.begin() + begin + this->Layout.Triples);
    for (double& value : own)
    {
      value *= this->OfSpheres * factor;
    }
    return WithMatrix(this->Sources, own.data(), this->Fractions, all);
  }
  static void AddParameters(const ThirdOrderIntegrals& integrals, Values& values)
  {
    const ThirdOrderParameters parameters = ThirdOrderRule::Parameters(integrals);
    values.push_back(parameters.Zeta);
    values.push_back(parameters.Eta);
  }

  const SumLayout& Layout;
  const std::vector<double>& Fractions;
  int Sources;
  double OfSpheres;
};

// Fills in what Evaluation returns, with errors
void SetFigures(const SumLayout& layout, const std::vector<double>& sums, bool withEta,
  ThirdOrderOfSpheres& result)
{
  std::vector<Values> blocks;
  for (std::size_t b = 0; b < layout.Blocks; ++b)
  {
    const auto begin = sums.begin() + b * layout.BlockSize;
    if (begin[SumLayout::Weight()] > 0.0)
    {
      blocks.emplace_back(begin, begin + layout.BlockSize);
    }
  }
  result.Blocks = static_cast<int>(blocks.size());
  const std::vector<ThirdOrderFigure> figures =
    Jackknife(blocks, Evaluation(layout, result.Fractions));
  auto next = figures.begin();
  const auto take = [&](std::size_t count)
  {
    const auto first = next;
    next += count;
    return std::vector<ThirdOrderFigure>(first, next);
  };
  result.Spectrum = take(layout.Degrees);
  result.Second = take(NumberOfTriples(result.Sources + 1));
  result.Fourth = take(NumberOfTriples(result.Sources + 1));
  const ThirdOrderFigure unknown = { NotANumber, NotANumber };
  const auto takeParameters = [&]
  {
    const std::vector<ThirdOrderFigure> both = take(2);
    return ThirdOrderOfSpheres::Parameters{ both[0], withEta ? both[1] : unknown };
  };
  result.Spheres = takeParameters();
  for (int r = 0; r <= result.Sources; ++r)
  {
    result.OfPhases.push_back(takeParameters());
  }
  if (!withEta)
  {
    std::fill(result.Fourth.begin(), result.Fourth.end(), unknown);
  }
}

void SetSpectra(
  const SumLayout& layout, const std::vector<double>& sums, ThirdOrderOfSpheres& result)
{
  double weight = 0.0;
  for (std::size_t b = 0; b < layout.Blocks; ++b)
  {
    weight += sums[b * layout.BlockSize + SumLayout::Weight()];
  }
  for (std::size_t triple = 0; triple < layout.Triples; ++triple)
  {
    const auto begin = sums.begin() + layout.TripleSpectrum(triple);
    Values spectrum(begin, begin + layout.Degrees);
    for (double& value : spectrum)
    {
      value /= weight * 2.0 * result.Fractions.back();
    }
    result.SpectrumOf.push_back(std::move(spectrum));
  }
}

void SetSlabs(const PackShare& share, const CentreRegion& region, const SumLayout& layout,
  const std::vector<double>& sums, ThirdOrderOfSpheres& result)
{
  const double cube = std::pow(share.LargestRadius, 3);
  const double volume = region.GetRegion().Volume() / region.GetSlabs();
  for (std::size_t n = 0; n < layout.Slabs; ++n)
  {
    ThirdOrderOfSpheres::Slab slab = region.MakeSlab(
      static_cast<int>(n) / region.GetSlabs(), static_cast<int>(n) % region.GetSlabs());
    std::vector<Values> blocks;
    double weight = 0.0;
    for (std::size_t b = 0; b < layout.Blocks; ++b)
    {
      const double* own = &sums[layout.Slab(n, b)];
      slab.Centres += std::llround(own[2]);
      if (own[0] > 0.0)
      {
        weight += own[0];
        blocks.push_back({ own[0], own[1] });
      }
    }
    slab.Fraction = weight * cube * SphereVolume(1.0) / volume;
    if (!blocks.empty())
    {
      const double matrix = 1.0 - slab.Fraction;
      slab.Zeta = Jackknife(
        blocks, [&](const Values& own) { return Values{ own[1] / own[0] / (2.0 * matrix) }; })[0];
    }
    result.Slabs.push_back(slab);
  }
}
}

ThirdOrderOfSpheres MeasureThirdOrder(const PackShare& share, const ThirdOrderSettings& settings,
  Communicator& ranks, const std::function<void(double)>& progress)
{
  CheckSettings(settings);
  CheckPack(share, settings, ranks);
  ThirdOrderOfSpheres result;
  result.Sources = settings.ByMode ? share.NumberOfModes() : 1;
  const double fraction = SphereFraction(share);
  const MultipoleSettings found = FindSettings(settings, share.Observed, share.MeanDiameter(),
    share.LargestRadius, fraction, static_cast<double>(share.NumberOfSpheres), result.Sources);
  result.CutOff = found.CutOff;
  result.MaximumDegree = found.Degree;
  result.Ewald = found.Alpha > 0.0;
  result.Fractions =
    settings.ByMode ? OnePointProbability(share) : std::vector<double>{ fraction, 1.0 - fraction };

  std::vector<int> source(share.Own.Size(), 0);
  if (settings.ByMode)
  {
    std::transform(share.Own.Mode.begin(), share.Own.Mode.end(), source.begin(),
      [](int mode) { return mode - 1; });
  }
  const CentreRegion region = FindRegion(share, settings, found);
  const SumLayout layout(result.Sources, found.Degree, region);
  MultipoleSums centres(share, source, found, region, layout, ranks);
  result.Centres = static_cast<std::int64_t>(centres.NumberOfCentres());
  ranks.Sum(&result.Centres, 1);
  Require(result.Centres > 0, settings.Name,
    Text("a sphere at least CutOff, ", found.CutOff, ", from every face of the window"), "none");
  const std::vector<double> sums = centres.Sum(ranks, progress);

  SetFigures(layout, sums, settings.WithEta, result);
  SetSpectra(layout, sums, result);
  SetSlabs(share, region, layout, sums, result);
  result.FieldEnergy = std::move(centres.Field);
  for (double& energy : result.FieldEnergy)
  {
    energy /= 2.0 * (1.0 - fraction);
  }
  return result;
}

Estimate EstimateThirdOrder(const PackFigures& pack, const ThirdOrderSettings& settings)
{
  constexpr double secondsPerPair = 80e-9, secondsPerWave = 1.5e-9;
  CheckSettings(settings);
  const double fraction = pack.Density() * SphereVolume(0.5 * pack.MeanDiameter);
  const int sources = settings.ByMode ? pack.Modes : 1;
  const MultipoleSettings found = FindSettings(settings, pack.Observed, pack.MeanDiameter,
    pack.LargestRadius, fraction, pack.Spheres, sources);
  // The spheres around every centre
  const bool periodic = pack.Observed.IsFullyPeriodic();
  const bool hasRoom = periodic || 2.0 * found.CutOff < pack.Observed.ShortestEdge();
  const double centres = hasRoom
    ? pack.Observed.Shrunk(periodic ? 0.0 : found.CutOff).Volume() / pack.Observed.Volume()
    : 0.0;
  const double pairs = 2.0 * pack.PairsWithin(found.CutOff) * centres;
  Estimate estimate{ pairs * secondsPerPair * (settings.WithEta ? 1.3 : 1.0), 0.0, 0.0 };
  if (found.Alpha > 0.0)
  {
    const double waves = ThirdOrderEwald::NumberOfWaves(pack.Observed, found);
    estimate.Seconds += 2.0 * pack.Spheres * waves * sources * secondsPerWave;
    estimate.MegabytesOfRank = waves * (300.0 + 32.0 * sources) / BytesOfMegabyte;
  }
  // The sums over centres, of which every thread has its own
  const double sums = settings.Blocks * (2.0 * NumberOfTriples(sources) + 9.0 * settings.Slabs);
  estimate.MegabytesOfRank += 64.0 * sums / BytesOfMegabyte;
  estimate.MegabytesOfAll = pack.Spheres * 200.0 / BytesOfMegabyte;
  if (settings.CutOff == 0.0)
  {
    estimate.Automatic = Text("Cut Off ", found.CutOff);
  }
  return estimate;
}
}
