// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Study/CellSizes.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace ruc
{
namespace
{
void Check(const CellSizeSettings& settings)
{
  Require(!settings.Sizes.empty(), "Sizes", "one or more numbers of spheres", "none");
  for (int size : settings.Sizes)
  {
    Range::From(1, 1000000).Check("Sizes", size);
  }
  Range::From(1, 100).Check("NumberOfCells", settings.Cells);
  Range::From(8, 1000).Check("Blocks", settings.Blocks);
  CheckRanges(settings.Search);
}

void MeasureTarget(const PackShare& share, GradientSearchSettings& search, Communicator& ranks)
{
  NeighbourTarget& of = search.Neighbours;
  if (of.ContactWeight + of.PoreWeight > 0.0)
  {
    of.Pack = MeasureNeighbourSums(share, ranks);
  }
  if (of.SpectrumWeight > 0.0)
  {
    of.Spectrum = MeasureSpectrum(share, "SpectrumWeight", ranks);
  }
  if (of.ThirdOrderWeight > 0.0)
  {
    of.ThirdOrder = MeasureNeighbourhoods(share, search.ThirdOrder, ranks);
  }
}

std::vector<bool> FindFitted(const NeighbourTarget& neighbours)
{
  std::vector<bool> fitted(CountOf(DescriptorKind{}), false);
  const auto set = [&](DescriptorKind kind, bool is) { fitted[static_cast<int>(kind)] = is; };
  set(DescriptorKind::Fraction, true);
  set(DescriptorKind::TwoPoint, true);
  set(DescriptorKind::Gaps, neighbours.HasContacts());
  set(DescriptorKind::Pores, neighbours.HasPores());
  set(DescriptorKind::ThirdOrder, neighbours.HasSpectrum() || neighbours.HasThirdOrder());
  return fitted;
}

class Study
{
public:
  Study(const PackShare& share, const CellSizeSettings& settings, Communicator& ranks,
    const std::function<bool(double, const std::string&)>& carryOn)
    : Share(share)
    , Settings(settings)
    , Ranks(ranks)
    , CarryOn(carryOn)
  {
  }

  CellSizeStudy Run()
  {
    const std::vector<CellContents> all = this->FindContents();
    this->FindLags(all.front().Edge);
    this->Descriptors = { this->Found.Lags, this->Share.MeanDiameter(), this->Settings.Blocks };
    this->Tell(0.0, "the pack");
    const PackDescriptors pack =
      MeasureDescriptors(this->Share, this->Descriptors, false, this->Ranks);
    this->Found.Floor = ObjectiveFloor(pack.Sums, *pack.Errors);
    double spheres = 0.0;
    for (const CellContents& contents : all)
    {
      spheres += contents.NumberOfSpheres();
    }
    for (const CellContents& contents : all)
    {
      const double part = contents.NumberOfSpheres() / spheres;
      if (!this->Found.Stopped)
      {
        this->StudyOne(contents, pack, part);
      }
      this->Done += part;
    }
    return std::move(this->Found);
  }

private:
  std::vector<CellContents> FindContents()
  {
    std::vector<int> sizes = this->Settings.Sizes;
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    std::vector<CellContents> all;
    const ModeAmounts amounts(this->Share);
    for (int size : sizes)
    {
      try
      {
        CellContents contents = ruc::FindCellContents(amounts, size);
        if (all.empty() || contents.NumberOfSpheres() > all.back().NumberOfSpheres())
        {
          all.push_back(std::move(contents));
        }
      }
      catch (const std::invalid_argument& refusal)
      {
        this->Found.LeftOut.push_back(Text(size, " spheres: ", refusal.what()));
      }
    }
    Require(!all.empty(), "Sizes", "a size at which every mode has a sphere",
      this->Found.LeftOut.empty() ? "none" : this->Found.LeftOut.back());
    return all;
  }

  void FindLags(double leastEdge)
  {
    const LagLimit ofPack = LagLimit::ForPairSum(this->Share.Observed, this->Share.LargestRadius);
    const double automatic = std::min(ofPack.Automatic, leastEdge);
    this->Found.Lags =
      ofPack.MakeGrid(this->Settings.MaximumLag > 0.0 ? this->Settings.MaximumLag : automatic,
        this->Settings.NumberOfLags);
    ofPack.Check(this->Found.Lags);
    LagLimit::ForCell(leastEdge).Check(this->Found.Lags);
  }

  bool Tell(double done, const std::string& what)
  {
    return !this->CarryOn || this->CarryOn(std::min(done, 1.0), what);
  }

  void StudyOne(const CellContents& contents, const PackDescriptors& pack, double part)
  {
    CellsOfSize of;
    of.Spheres = contents.NumberOfSpheres();
    of.Edge = contents.Edge;
    std::vector<PackDescriptors> cells;
    const StageLengths lengths(
      this->Settings.Search.MaximumIterations, !this->Settings.Search.Neighbours.Empty());
    for (int n = 0; n < this->Settings.Cells; ++n)
    {
      GradientSearchSettings search = this->Settings.Search;
      search.Seed += static_cast<std::uint32_t>(n);
      const std::string what =
        Text(of.Spheres, " spheres, cell ", n + 1, " of ", this->Settings.Cells);
      bool asked = true;
      const UnitCell cell = SearchByGradient(contents, pack.Sums, search, this->Ranks,
        [&](const SearchState& state)
        {
          const double ofCell = std::min(state.Iteration / (lengths.All() + 1.0), 1.0);
          asked =
            this->Tell(this->Done + part * (n + ofCell) / this->Settings.Cells, what) && asked;
          return asked;
        });
      if (!this->Ranks.All(asked))
      {
        this->Found.Stopped = true;
        return;
      }
      of.Objectives.push_back(cell.Objective);
      // Every rank has the whole cell
      const PackShare own =
        SharePack(this->Ranks.Rank() == 0 ? cell.Pack : SpherePack(), cell.Box, true, this->Ranks);
      cells.push_back(MeasureDescriptors(own, this->Descriptors, true, this->Ranks));
    }
    of.Card = MakeReportCard({ pack }, cells, FindFitted(this->Settings.Search.Neighbours));
    this->Found.Sizes.push_back(std::move(of));
  }

  const PackShare& Share;
  const CellSizeSettings& Settings;
  Communicator& Ranks;
  const std::function<bool(double, const std::string&)>& CarryOn;
  DescriptorSettings Descriptors;
  CellSizeStudy Found;
  double Done = 0.0;
};
}

double CellsOfSize::LargestZ(bool fittedAlone) const
{
  double largest = 0.0;
  for (const ReportRow& row : this->Card.Rows)
  {
    largest = !fittedAlone || row.Fitted ? std::max(largest, std::abs(row.Z)) : largest;
  }
  return largest;
}

int CellSizeStudy::LeastSize(bool fittedAlone) const
{
  int least = 0;
  for (auto size = this->Sizes.rbegin();
       size != this->Sizes.rend() && size->LargestZ(fittedAlone) <= ReportCard::MostZ; ++size)
  {
    least = size->Spheres;
  }
  return least;
}

std::string CellSizeStudy::Verdict() const
{
  if (this->Sizes.empty())
  {
    return "No size was finished.";
  }
  const auto tell = [](int least)
  { return least > 0 ? Text("from ", least, " spheres on") : std::string("at no size studied"); };
  return Text("Cells are within the pack's own error in all descriptors ",
    tell(this->LeastSize(false)), ", and in those that the search fits ",
    tell(this->LeastSize(true)), ". Of ", this->Sizes.back().Spheres,
    " spheres: ", this->Sizes.back().Card.Verdict());
}

CellSizeStudy StudyCellSizes(const PackShare& share, CellSizeSettings settings, Communicator& ranks,
  const std::function<bool(double done, const std::string& what)>& carryOn)
{
  Check(settings);
  MeasureTarget(share, settings.Search, ranks);
  return Study(share, settings, ranks, carryOn).Run();
}

Estimate EstimateCellSizes(const PackFigures& pack, const CellSizeSettings& settings)
{
  Check(settings);
  const double density = pack.Density();
  const double least = *std::min_element(settings.Sizes.begin(), settings.Sizes.end());
  const LagLimit limit = LagLimit::ForPairSum(pack.Observed, pack.LargestRadius);
  const double lag = std::min(limit.Automatic, std::cbrt(least / density));
  const LagGrid lags =
    limit.MakeGrid(settings.MaximumLag > 0.0 ? settings.MaximumLag : lag, settings.NumberOfLags);
  constexpr double secondsPerSphere = 4e-4; // of the figures of a pack or a cell
  Estimate estimate = { pack.Spheres * secondsPerSphere, 0.0, 0.0 };
  for (int size : settings.Sizes)
  {
    Estimate one = EstimateGradientSearch(
      { double(size), density, pack.LargestRadius, pack.Modes, pack.ModeRadius, pack.ModeShare },
      lags, settings.Search);
    one.Seconds = settings.Cells * (one.Seconds + size * secondsPerSphere);
    estimate.Seconds += one.Seconds;
    estimate.MegabytesOfRank = std::max(estimate.MegabytesOfRank, one.MegabytesOfRank);
    estimate.MegabytesOfAll = std::max(estimate.MegabytesOfAll, one.MegabytesOfAll);
  }
  return estimate;
}
}
