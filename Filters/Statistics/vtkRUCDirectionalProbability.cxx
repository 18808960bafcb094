// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCDirectionalProbability.h"

#include "MeasuredLags.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "StatisticsEstimate.h"
#include "TwoPointTables.h"
#include "ruc/Base/Require.h"
#include "ruc/Statistics/PairSums/DirectionalProbability.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Window/Directions.h"

#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkRUCDirectionalProbability);

namespace
{
const char* const MethodNames[] = { "Exact Pair Sum", "Chord Sampling" };
// For half of the ordered pairs of phases a value and its error, in the result and in the table
constexpr double BytesPerValue = 16.0;
constexpr double BytesPerVector = 100.0;
}

vtkRUCDirectionalProbability::vtkRUCDirectionalProbability()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkRUCDirectionalProbability::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCDirectionalProbability::ValidateProperties()
{
  ruc::Require(this->Method == EXACT_PAIR_SUM || this->Method == CHORD_SAMPLING, "Method",
    "a value from 0 to 1", this->Method);
  ruc::Require(!this->HasMask() || this->Method != EXACT_PAIR_SUM, "Mask", "Method Chord Sampling",
    "Exact Pair Sum");
}

void vtkRUCDirectionalProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const ruc::PackShare& share = pack.Share;
  const bool exact = this->Method == EXACT_PAIR_SUM;
  const double overlap = this->CheckOverlap(share, exact, ranks);
  const std::unique_ptr<ruc::SamplingRegion> region =
    exact ? nullptr : this->MakeRegion(pack, ranks);
  const ruc::LagGrid lags =
    MeasuredLags::Find(this->MaximumLag, this->NumberOfLags, share, region.get(), this->HasMask());
  OutputSummary::Samples samples = { "NumberOfLines", 0, 0.0, false };
  const ruc::DirectionalProbability directional =
    this->Measure(share, region.get(), lags, ranks, report, samples);
  if (ranks.Rank() == 0)
  {
    TwoPointTables::FillIsotropy(directional, vtkTable::GetData(outputs, ISOTROPY));
    TwoPointTables::FillDirections(directional, vtkTable::GetData(outputs, DIRECTIONS));
  }

  const std::vector<double> fractions =
    exact ? ruc::OnePointProbability(share) : ruc::MeanOverDirections(directional).Fractions;
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      PackData::AddField(data, "Method", std::string(MethodNames[this->Method]));
      OutputSummary::AddLags(data, lags);
      PackData::AddPackSummary(data, pack, share.NumberOfSpheres, fractions, overlap);
      if (region)
      {
        this->AddRegionSummary(data, *region);
        OutputSummary::AddSamples(data, samples);
      }
    });
  OutputSummary::WarnOfStop(this, samples.Stopped, ranks);
}

ruc::DirectionalProbability vtkRUCDirectionalProbability::Measure(const ruc::PackShare& share,
  const ruc::SamplingRegion* region, const ruc::LagGrid& lags, RankCommunicator& ranks,
  ProgressReport& report, OutputSummary::Samples& samples) const
{
  const std::vector<ruc::Vector3> directions = ruc::EvenDirections(this->NumberOfDirections);
  if (!region)
  {
    return ruc::SumPairsAlong(share, directions, lags, ranks, report.ForSums(ranks));
  }
  const auto progress = [&](double done, const std::string& text)
  { return ranks.Rank() != 0 || report.Update(done, text); };
  ruc::DirectionalProbability directional;
  directional.Directions = directions;
  for (ruc::SampledTwoPoint& along : ruc::SampleChordsAlong(directions, share.Own,
         share.NumberOfModes(), *region, lags, this->GetSettings(false), ranks, progress))
  {
    samples.Number += along.Samples;
    samples.TotalError = std::max(samples.TotalError, along.TotalError);
    samples.Stopped = samples.Stopped || along.Stopped;
    directional.Values.push_back(std::move(along.Mean));
    directional.Errors.push_back(std::move(along.Errors));
  }
  return directional;
}

std::optional<ruc::Estimate> vtkRUCDirectionalProbability::MakeEstimate()
{
  this->ValidateProperties();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const bool exact = this->Method == EXACT_PAIR_SUM;
  const ruc::LagGrid lags =
    StatisticsEstimate::FindLags(this->MaximumLag, this->NumberOfLags, *pack, exact);
  const int directions = this->NumberOfDirections;
  ruc::Require(directions >= 2, "NumberOfDirections", "a number >= 2", directions);
  ruc::Estimate estimate = StatisticsEstimate::OfPack(*pack, this->MaximumLag, lags);
  if (exact)
  {
    estimate += ruc::EstimatePairSumAlong(*pack, lags, directions);
    return estimate;
  }
  const std::optional<double> lines = StatisticsEstimate::NumberOfSamples(this->GetSettings(false));
  if (!lines)
  {
    return {};
  }
  ruc::Estimate chords = ruc::EstimateChords(*pack, lags, *lines);
  chords.Seconds *= directions;
  estimate += chords;
  estimate.MegabytesOfRank += directions *
    ((pack->Modes + 1.0) * (pack->Modes + 2.0) * (lags.Count + 1.0) * BytesPerValue +
      BytesPerVector) /
    ruc::BytesOfMegabyte;
  return estimate;
}

void vtkRUCDirectionalProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
}
