// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCThreePointProbability.h"

#include "ImageSlab.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "PackEstimate.h"
#include "PackInput.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ThreePointTables.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/Sampling/FanSampling.h"
#include "ruc/Statistics/ThirdOrder/NeighbourhoodMultipoles.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCThreePointProbability);

namespace
{
constexpr double Megabyte = 1e6;
constexpr int LinesForLimits = 20000;
}

vtkRUCThreePointProbability::vtkRUCThreePointProbability()
{
  this->SetNumberOfOutputPorts(5);
}

int vtkRUCThreePointProbability::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == PROBABILITIES ? "vtkImageData" : "vtkTable");
  return 1;
}

void vtkRUCThreePointProbability::ClearMultipoleDistances()
{
  this->MultipoleDistances.clear();
  this->Modified();
}

void vtkRUCThreePointProbability::SetMultipoleDistance(int i, double distance)
{
  constexpr int most = 1000; // the core refuses fewer
  if (i < 0 || i >= most)
  {
    vtkErrorMacro(<< "MultipoleDistances has places 0 to " << most - 1 << ", got " << i);
    return;
  }
  this->MultipoleDistances.resize(
    std::max(this->MultipoleDistances.size(), static_cast<std::size_t>(i) + 1));
  this->MultipoleDistances[i] = distance;
  this->Modified();
}

int vtkRUCThreePointProbability::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* image = outputs->GetInformationObject(PROBABILITIES);
  const int lags = std::max(this->NumberOfLags, 0);
  const int directions = std::max(this->NumberOfDirections, 1);
  const int extent[6] = { 0, lags, 0, lags, 0, directions / 2 };
  image->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  image->Set(vtkDataObject::ORIGIN(), 0.0, 0.0, 0.0);
  // Before the pack is known, only what was set is known; the data say it in any case
  const double spacing = this->MaximumLag > 0.0 && lags > 0 ? this->MaximumLag / lags : 1.0;
  image->Set(vtkDataObject::SPACING(), spacing, spacing, 360.0 / directions);
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

double vtkRUCThreePointProbability::EstimateMemory(
  std::size_t triples, bool bounded, int ranks) const
{
  const ruc::ThreePointGrid grid = { { 1.0, this->NumberOfLags }, this->NumberOfDirections };
  const double image = 8.0 * static_cast<double>(grid.Size()) * triples / ranks;
  return (ruc::EstimateFanMemory(grid, triples, this->StandardErrors, bounded) +
           image * (this->StandardErrors ? 2 : 1)) /
    Megabyte;
}

double vtkRUCThreePointProbability::GetEstimatedMemory()
{
  const RankCommunicator ranks(this->GetController());
  try
  {
    const vtkSmartPointer<vtkPointSet> input = PackInput::FindHere(this->GetInputDataObject(0, 0));
    vtkDataArray* modes = input
      ? PackData::FindArray(input->GetPointData(), "Mode", input->GetNumberOfPoints())
      : nullptr;
    // Without data any mode may exist, so that triples are counted as they stand, but "all" is not
    // known
    const bool known = modes && modes->GetNumberOfTuples() > 0;
    const int number = known ? static_cast<int>(modes->GetRange(0)[1]) : 999999;
    if (!known && this->Phases.find("all") != std::string::npos)
    {
      return 0.0;
    }
    const std::optional<ruc::PackFigures> pack = this->FindFigures();
    return this->EstimateMemory(
             ruc::ParseTriples(this->Phases, number).size(), true, ranks.Size()) +
      this->EstimateRegion().MegabytesOfRank +
      (pack ? ruc::EstimatePairSum(*pack, this->MakeLags(*pack)).MegabytesOfRank : 0.0);
  }
  catch (const std::exception&)
  {
    return 0.0;
  }
}

double vtkRUCThreePointProbability::GetMemoryToCheck()
{
  return this->EstimateRegion().MegabytesOfRank;
}

double vtkRUCThreePointProbability::EstimateLimits(const ruc::LagGrid& lags)
{
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  return pack ? ruc::EstimatePairSum(*pack, lags).MegabytesOfRank : 0.0;
}

ruc::LagGrid vtkRUCThreePointProbability::MakeLags(const ruc::PackFigures& pack) const
{
  const ruc::LagLimit limit =
    ruc::LagLimit::ForFans(pack.Observed, pack.Observed.Shrunk(pack.LargestRadius));
  return limit.MakeGrid(this->MaximumLag, this->NumberOfLags);
}

std::optional<ruc::Estimate> vtkRUCThreePointProbability::MakeEstimate()
{
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack || this->NumberOfThrows < 1 || this->NumberOfDirections < 2 ||
    this->NumberOfDirections > ruc::MostFanDirections)
  {
    return {};
  }
  const ruc::ThreePointGrid grid = { this->MakeLags(*pack), this->NumberOfDirections };
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  if (this->MaximumLag == 0.0)
  {
    estimate.Automatic = ruc::Text("Maximum Lag ", grid.Lags.Maximum());
  }
  estimate += ruc::EstimatePairSum(*pack, grid.Lags);
  estimate += ruc::EstimateFans(*pack, grid, ruc::ParseTriples(this->Phases, pack->Modes).size(),
    this->StandardErrors, this->NumberOfThrows);
  if (this->Multipoles)
  {
    estimate += ruc::EstimateNeighbourhoods(*pack, this->FindMultipoleSettings());
  }
  return estimate;
}

void vtkRUCThreePointProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const ruc::PackShare& share = pack.Share;
  const double overlap = this->CheckOverlap(share, false, ranks);
  const std::vector<ruc::PhaseTriple> triples =
    ruc::ParseTriples(this->Phases, share.NumberOfModes());
  const std::unique_ptr<ruc::SamplingRegion> region = this->MakeRegion(pack, ranks);
  const ruc::ThreePointGrid grid = this->FindGrid(share, *region);
  double memory = this->CheckWork(*region, grid, triples.size(), ranks);
  this->FillMultipoles(share, outputs, ranks);
  const ruc::ThreePointProbability probability =
    this->Sample(share, *region, grid, triples, memory, ranks, report);

  const bool exact = !this->HasMask() && overlap <= PackData::TolerableOverlap;
  const ruc::TwoPointProbability twoPoint =
    this->MeasureTwoPoint(pack, exact, *region, grid.Lags, ranks, report);
  memory += exact ? this->EstimateLimits(grid.Lags) : 0.0;
  this->FillImage(probability, outputs, ranks);
  if (ranks.Rank() == 0)
  {
    ThreePointTables::FillLimits(probability, twoPoint, vtkTable::GetData(outputs, LIMITS),
      vtkTable::GetData(outputs, CHECKS));
    const std::string unknown =
      ThreePointTables::FillThirdOrder(probability, vtkTable::GetData(outputs, THIRD_ORDER));
    if (!unknown.empty())
    {
      vtkWarningMacro(<< "zeta and eta are not known for: " << unknown
                      << ". They require an even NumberOfDirections >= 8, a NumberOfLags >= 2, and "
                         "throws of which some are in the phase and some are not.");
    }
  }
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      this->AddSummary(probability, exact, memory, data);
      PackData::AddPackSummary(data, pack, share.NumberOfSpheres, twoPoint.Fractions, overlap);
      this->AddRegionSummary(data, *region);
    });
  OutputSummary::WarnOfStop(this, this->WasStopped(probability), ranks);
}

ruc::ThreePointGrid vtkRUCThreePointProbability::FindGrid(
  const ruc::PackShare& share, const ruc::SamplingRegion& region)
{
  const ruc::LagLimit limit =
    ruc::LagLimit::ForFans(this->HasMask() ? region.GetShape() : share.Observed, region.GetShape());
  return { limit.MakeGrid(this->MaximumLag, this->NumberOfLags), this->NumberOfDirections };
}

ruc::FanSettings vtkRUCThreePointProbability::MakeSettings() const
{
  ruc::FanSettings settings;
  settings.Seed = this->GetCheckedSeed();
  settings.Throws = this->NumberOfThrows;
  settings.WithErrors = this->StandardErrors;
  return settings;
}

double vtkRUCThreePointProbability::CheckWork(const ruc::SamplingRegion& region,
  const ruc::ThreePointGrid& grid, std::size_t triples, const RankCommunicator& ranks)
{
  ruc::CheckFans(region, grid, this->MakeSettings());
  const double memory = this->EstimateMemory(triples, !region.IsFullyPeriodic(), ranks.Size());
  if (!(memory <= this->GetMemoryLimit()))
  {
    throw std::invalid_argument(ruc::Text("MemoryLimit requires at least ", std::ceil(memory),
      " MB on every rank for ", triples, triples == 1 ? " triple" : " triples", " of phases, ",
      grid.Lags.Count, " lags and ", grid.Angles(), " angles",
      this->StandardErrors ? " with standard errors" : "", ", got ", this->GetMemoryLimit(), "."));
  }
  return memory;
}

ruc::ThreePointProbability vtkRUCThreePointProbability::Sample(const ruc::PackShare& share,
  const ruc::SamplingRegion& region, const ruc::ThreePointGrid& grid,
  const std::vector<ruc::PhaseTriple>& triples, double memory, RankCommunicator& ranks,
  ProgressReport& report) const
{
  const auto progress = [&](double done, const std::string& text)
  {
    return ranks.Rank() != 0 ||
      report.Update(done, ruc::Text(text, ", ", std::ceil(memory), " MB on every rank"));
  };
  progress(0.0, "tracing");
  return ruc::SampleFans(
    share.Own, share.NumberOfModes(), region, grid, triples, this->MakeSettings(), ranks, progress);
}

bool vtkRUCThreePointProbability::WasStopped(const ruc::ThreePointProbability& probability) const
{
  return probability.GetThrows() < this->NumberOfThrows;
}

void vtkRUCThreePointProbability::AddSummary(const ruc::ThreePointProbability& probability,
  bool exact, double memory, vtkDataObject* data) const
{
  const ruc::ThreePointGrid& grid = probability.GetGrid();
  PackData::AddField(data, "Method", std::string("Fan Sampling"));
  PackData::AddField(data, "LimitMethod", std::string(exact ? "Exact Pair Sum" : "Chord Sampling"));
  PackData::AddField(data, "Phases", this->Phases);
  OutputSummary::AddLags(data, grid.Lags);
  PackData::AddField(data, "NumberOfDirections", std::vector<long long>{ grid.Directions });
  PackData::AddField(data, "NumberOfThrows",
    std::vector<long long>{ static_cast<long long>(probability.GetThrows()) });
  PackData::AddField(data, "Stopped", std::vector<long long>{ this->WasStopped(probability) });
  PackData::AddField(data, "EstimatedMemory", std::vector<double>{ memory });
}

ruc::TwoPointProbability vtkRUCThreePointProbability::MeasureTwoPoint(
  const PackData::SharedPack& pack, bool exact, const ruc::SamplingRegion& region,
  const ruc::LagGrid& lags, RankCommunicator& ranks, ProgressReport& report) const
{
  if (exact)
  {
    // A stop is one of the throws, and keeps what these have told
    const std::function<void(double)> tell = report.ForPairs(ranks);
    return ruc::SumPairs(pack.Share, lags, ranks,
      [&](double done)
      {
        tell(done);
        return true;
      });
  }
  ruc::SamplingSettings settings;
  settings.Seed = this->GetCheckedSeed();
  settings.Samples = LinesForLimits;
  return ruc::SampleChords(
    pack.Share.Own, pack.Share.NumberOfModes(), region, lags, settings, ranks)
    .Mean;
}

void vtkRUCThreePointProbability::FillImage(const ruc::ThreePointProbability& probability,
  vtkInformationVector* outputs, const RankCommunicator& ranks) const
{
  const ruc::ThreePointGrid& grid = probability.GetGrid();
  const double spacing = grid.Lags.Spacing, step = grid.Angle(1);
  vtkImageData* image = vtkImageData::GetData(outputs, PROBABILITIES);
  ImageSlab::SetExtent(image, { 0, grid.Lags.Count, 0, grid.Lags.Count, 0, grid.Angles() - 1 },
    { spacing, spacing, step }, ranks);
  for (std::size_t n = 0; n < probability.GetTriples().size(); ++n)
  {
    const std::string name = ruc::TripleName(probability.GetTriples()[n], probability.GetModes());
    ImageSlab::AddArray(
      image, name, [&](int i, int j, int t) { return probability.Value(n, i, j, t); });
    if (probability.HasErrors())
    {
      ImageSlab::AddArray(
        image, name + "_error", [&](int i, int j, int t) { return probability.Error(n, i, j, t); });
    }
  }
  outputs->GetInformationObject(PROBABILITIES)
    ->Set(vtkDataObject::SPACING(), spacing, spacing, step);
}

ruc::NeighbourhoodSettings vtkRUCThreePointProbability::FindMultipoleSettings() const
{
  ruc::NeighbourhoodSettings settings;
  settings.Distances = this->MultipoleDistances;
  settings.Degree = this->MultipoleDegree;
  settings.Classes = this->MultipoleClasses;
  return settings;
}

void vtkRUCThreePointProbability::FillMultipoles(
  const ruc::PackShare& share, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  if (!this->Multipoles)
  {
    // A table without columns would make some of ParaView's views wait for the server for ever
    if (ranks.Rank() == 0)
    {
      PackData::AddColumn(vtkTable::GetData(outputs, MULTIPOLES), "Note",
        std::vector<std::string>{ "Multipoles is off" });
    }
    return;
  }
  ruc::Require(!this->HasMask(), "Multipoles", "a pack without a mask", "one");
  const ruc::NeighbourhoodMultipoles found =
    ruc::MeasureNeighbourhoods(share, this->FindMultipoleSettings(), ranks);
  ThreePointTables::FillMultipoles(
    found, ranks.Rank() == 0, vtkTable::GetData(outputs, MULTIPOLES));
}

void vtkRUCThreePointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Phases: " << this->Phases << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "NumberOfThrows: " << this->NumberOfThrows << "\n";
  os << indent << "StandardErrors: " << this->StandardErrors << "\n";
  os << indent << "Multipoles: " << this->Multipoles << "\n";
  os << indent << "MultipoleClasses: " << this->MultipoleClasses << "\n";
  os << indent << "MultipoleDegree: " << this->MultipoleDegree << "\n";
  os << indent << "MultipoleDistances:";
  for (double distance : this->MultipoleDistances)
  {
    os << " " << distance;
  }
  os << "\n";
}
