// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/NeighbourhoodMultipoles.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Range.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Results/Jackknife.h"
#include "ruc/Statistics/ThirdOrder/MultipoleSums.h"
#include "ruc/Statistics/ThirdOrder/ShellMultipoles.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
constexpr int MostClasses = 4;
constexpr std::size_t MostShells = 32;
constexpr double MostOverlapPercent = 0.01;
// T is a mean of products of shares of a shell times 2 l + 1, so some ten at most
constexpr double Most = 1024.0;

void CheckSettings(const NeighbourhoodSettings& settings)
{
  const std::string prefix = settings.Prefix, distances = prefix + "Distances";
  Range::From(0, HighestOfShells).Check((prefix + "Degree").c_str(), settings.Degree);
  Range::From(1, MostClasses).Check((prefix + "Classes").c_str(), settings.Classes);
  Range::From(2, 1000).Check("Blocks", settings.Blocks);
  Require(settings.Distances.size() <= MostShells, distances.c_str(),
    Text("at most ", MostShells, " distances"), settings.Distances.size());
  double last = 0.0;
  for (double distance : settings.Distances)
  {
    Require(std::isfinite(distance) && distance > last, distances.c_str(),
      "distances > 0 that ascend", Text(distance, " after ", last));
    last = distance;
  }
}

std::vector<double> DiametersOfModes(const PackShare& share)
{
  std::vector<double> diameters;
  diameters.reserve(share.NumberOfModes());
  for (int mode = 0; mode < share.NumberOfModes(); ++mode)
  {
    diameters.push_back(
      2.0 * std::cbrt(share.Volume[mode] / share.Count[mode] / SphereVolume(1.0)));
  }
  return diameters;
}

// The sums of T over the centres of a rank, for each block and class
class Sums
{
public:
  Sums(const PackShare& share, const NeighbourhoodMultipoles& result, Communicator& ranks,
    double reach, const CentreRegion& region)
    : Share(share)
    , ClassOfMode(result.ClassOfMode)
    , Shells(result.Shells)
    , Around(share, reach, ranks)
    , Region(region)
  {
    for (std::size_t i = 0; i < this->Around.Size(); ++i)
    {
      if (region.GetRegion().Contains(share.Own.Centre(this->Around.PlaceOf(i))))
      {
        this->Centres.push_back(i);
      }
    }
  }

  // In a block and class first the number of centres, then all T
  std::size_t PlaceOf(int block, int r) const
  {
    return (std::size_t(block) * this->Shells.GetSettings().Classes + r) *
      (1 + this->Shells.GetSettings().NumberOfProducts());
  }
  int NumberOfBlocks() const { return this->Region.NumberOfBlocks(); }

  std::vector<double> Sum(Communicator& ranks, const std::function<void(double)>& progress) const
  {
    std::vector<std::int64_t> total(this->PlaceOf(this->NumberOfBlocks(), 0), 0);
    const std::int64_t centres = static_cast<std::int64_t>(this->Centres.size());
    // So that sums over all centres of the pack stay below 2^62
    const double scale = std::ldexp(
      1.0, std::min(61 - std::ilogb(Most * this->Share.NumberOfSpheres), 49 - std::ilogb(Most)));
#pragma omp parallel
    {
      std::vector<std::int64_t> own(total.size(), 0);
      AlignedNumbers sums(this->Shells.Size());
      std::vector<double> products(this->Shells.GetSettings().NumberOfProducts());
      std::vector<ShellMultipoles::Neighbour> around;
#pragma omp for schedule(dynamic, 16) nowait
      for (std::int64_t n = 0; n < centres; ++n)
      {
        const std::size_t place = this->Around.PlaceOf(this->Centres[n]);
        this->Gather(this->Centres[n], around);
        this->Shells.Sum(this->Share.Own.Radius[place], around, sums.data());
        this->Shells.FindProducts(sums.data(), products.data());
        std::int64_t* const target =
          &own[this->PlaceOf(this->Region.BlockOf(this->Share.Own.Centre(place)),
            this->ClassOf(this->Share.Own, place))];
        ++target[0];
        AddFixedPoint(products.data(), products.size(), Most, scale, target + 1);
        if (progress && omp_get_thread_num() == 0)
        {
          progress(double(n) / centres);
        }
      }
#pragma omp critical
      std::transform(own.begin(), own.end(), total.begin(), total.begin(), std::plus<>());
    }
    ranks.Sum(total.data(), total.size());
    std::vector<double> values(total.begin(), total.end());
    const std::size_t stride = 1 + this->Shells.GetSettings().NumberOfProducts();
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      values[n] /= n % stride == 0 ? 1.0 : scale;
    }
    return values;
  }

private:
  int ClassOf(const SpherePack& pack, std::size_t i) const
  {
    return this->ClassOfMode.size() > 1 ? this->ClassOfMode[pack.Mode[i] - 1] : 0;
  }

  void Gather(std::size_t i, std::vector<ShellMultipoles::Neighbour>& around) const
  {
    around.clear();
    this->Around.ForEachAround(i,
      [&](const PairNeighbourhood::Part& part, std::size_t j, double dx, double dy, double dz,
        double d2)
      {
        const double d = std::sqrt(d2);
        around.push_back(
          { { dx / d, dy / d, dz / d }, d, part.Pack.Radius[j], this->ClassOf(part.Pack, j) });
      });
  }

  const PackShare& Share;
  const std::vector<int>& ClassOfMode;
  ShellMultipoles Shells;
  Surroundings Around;
  const CentreRegion& Region;
  std::vector<std::size_t> Centres; // their sorted places
};

// Means and standard errors of a class from the sums of its blocks
void SetValues(const std::vector<std::vector<double>>& blocks, NeighbourhoodMultipoles& result)
{
  std::vector<double> whole(blocks.front().size(), 0.0);
  for (const std::vector<double>& block : blocks)
  {
    std::transform(block.begin(), block.end(), whole.begin(), whole.begin(), std::plus<>());
  }
  std::vector<double> without;
  for (std::size_t k = 1; k < whole.size(); ++k)
  {
    without.clear();
    for (const std::vector<double>& block : blocks)
    {
      if (block[0] > 0.0 && block[0] < whole[0])
      {
        without.push_back((whole[k] - block[k]) / (whole[0] - block[0]));
      }
    }
    result.Value.push_back(whole[k] / whole[0]);
    result.Error.push_back(JackknifeError(without));
  }
}
}

std::vector<double> AutomaticShells(double meanDiameter)
{
  std::vector<double> distances = { 0.04, 0.08, 0.12, 0.18, 0.26, 0.36, 0.5, 0.64, 0.8, 1.0, 1.2,
    1.44 };
  for (double& distance : distances)
  {
    distance *= meanDiameter;
  }
  return distances;
}

std::vector<int> FindClasses(
  const std::vector<double>& diameters, const std::vector<double>& volumes, int classes)
{
  std::vector<std::size_t> order(diameters.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return diameters[a] < diameters[b]; });
  const double all = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  std::vector<int> found(diameters.size(), 0);
  double before = 0.0;
  int last = -1, number = -1; // of the last mode: where its middle lies, and its class
  for (std::size_t mode : order)
  {
    const int part = static_cast<int>((before + 0.5 * volumes[mode]) / all * classes);
    number += part > last;
    last = std::max(last, part);
    found[mode] = number;
    before += volumes[mode];
  }
  return found;
}

NeighbourhoodMultipoles MeasureNeighbourhoods(const PackShare& share,
  const NeighbourhoodSettings& settings, Communicator& ranks,
  const std::function<void(double)>& progress)
{
  CheckSettings(settings);
  const double overlap = MeasureOverlap(share, ranks).Percent;
  Require(overlap <= MostOverlapPercent, settings.Name,
    Text("spheres that overlap by at most ", MostOverlapPercent, " % of their volume"),
    Text(overlap, " %"));
  NeighbourhoodMultipoles result;
  result.ClassOfMode = FindClasses(DiametersOfModes(share), share.Volume, settings.Classes);
  result.Shells = {
    settings.Distances.empty() ? AutomaticShells(share.MeanDiameter()) : settings.Distances,
    settings.Degree,
    1 + *std::max_element(result.ClassOfMode.begin(), result.ClassOfMode.end()),
  };
  result.Centres.assign(result.Shells.Classes, 0);

  const double reach = result.Shells.Distances.back() + 2.0 * share.LargestRadius;
  const bool periodic = share.Observed.IsFullyPeriodic();
  const std::string inside = Text(settings.LeastCentres, " centres of every class at least ", reach,
    " from every face of the window");
  Require(
    periodic || 2.0 * reach < 0.999 * share.Observed.ShortestEdge(), settings.Name, inside, "none");
  ThirdOrderSettings blocks;
  blocks.Blocks = settings.Blocks;
  const CentreRegion region(share.Observed, periodic ? 0.0 : reach, blocks);
  const Sums sums(share, result, ranks, reach, region);
  const std::vector<double> values = sums.Sum(ranks, progress);
  for (int r = 0; r < result.Shells.Classes; ++r)
  {
    std::vector<std::vector<double>> ofBlocks;
    for (int block = 0; block < sums.NumberOfBlocks(); ++block)
    {
      const auto begin = values.begin() + sums.PlaceOf(block, r);
      ofBlocks.emplace_back(begin, begin + (sums.PlaceOf(0, 1) - sums.PlaceOf(0, 0)));
      result.Centres[r] += std::llround(ofBlocks.back()[0]);
    }
    Require(result.Centres[r] >= settings.LeastCentres, settings.Name, inside,
      Text(result.Centres[r], " of class ", r + 1));
    SetValues(ofBlocks, result);
    const auto errors = result.Error.end() - result.Shells.NumberOfProducts();
    Require(!settings.NeedsScatter ||
        std::any_of(errors, result.Error.end(), [](double error) { return error > 0.0; }),
      settings.Name, "spheres of every class in more than one part of the pack, which differ",
      Text("no scatter in class ", r + 1));
  }
  return result;
}

Estimate EstimateNeighbourhoods(const PackFigures& pack, const NeighbourhoodSettings& settings)
{
  constexpr double secondsOfPair = 6e-7, secondsOfProduct = 6e-9;
  CheckSettings(settings);
  const std::vector<double> distances =
    settings.Distances.empty() ? AutomaticShells(pack.MeanDiameter) : settings.Distances;
  const ShellSettings shells = { distances, settings.Degree, settings.Classes };
  const double reach = distances.back() + 2.0 * pack.LargestRadius;
  const double pairs = 2.0 * pack.PairsWithin(reach), products = shells.NumberOfProducts();
  Estimate estimate;
  estimate.Seconds = pairs * secondsOfPair + pack.Spheres * products * secondsOfProduct;
  // The sums of a thread and of all, and as numbers
  estimate.MegabytesOfRank =
    3.0 * 8.0 * settings.Blocks * settings.Classes * products / BytesOfMegabyte;
  return estimate;
}
}
