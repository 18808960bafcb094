// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCTwoPointProbability.h"

#include "MeasuredLags.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "StatisticsEstimate.h"
#include "TwoPointTables.h"
#include "ruc/Base/Require.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/PairSums/PairSumErrors.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/Sampling/TemplateSampling.h"

#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <numeric>

vtkStandardNewMacro(vtkRUCTwoPointProbability);

namespace
{
const char* const MethodNames[] = { "Exact Pair Sum", "Chord Sampling", "Template Sampling" };
}

vtkRUCTwoPointProbability::vtkRUCTwoPointProbability()
{
  this->SetNumberOfOutputPorts(4);
}

int vtkRUCTwoPointProbability::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCTwoPointProbability::ValidateProperties()
{
  ruc::Require(this->Method >= EXACT_PAIR_SUM && this->Method <= TEMPLATE_SAMPLING, "Method",
    "a value from 0 to 2", this->Method);
  ruc::Require(this->SaturationTolerance > 0.0, "SaturationTolerance", "a number > 0",
    this->SaturationTolerance);
  ruc::Require(!this->HasMask() || this->Method != EXACT_PAIR_SUM, "Mask",
    "Method Chord Sampling or Template Sampling", "Exact Pair Sum");
  ruc::Require(this->Blocks == 0 || (this->Blocks >= 8 && this->Blocks <= 1000), "Blocks",
    "0 or a number from 8 to 1000", this->Blocks);
}

void vtkRUCTwoPointProbability::Execute(
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
  ruc::SampledTwoPoint measured = this->Measure(share, region.get(), lags, ranks, report);
  if (exact && this->Blocks > 0)
  {
    report.Tell(0.99, "errors by blocks of the pack");
    const ruc::TwoPointErrors errors =
      ruc::FindPairSumErrors(share, measured.Mean, this->Blocks, ranks);
    this->AddErrors(measured.Mean, errors, outputs, ranks);
    measured.Errors = errors.Values;
  }
  if (ranks.Rank() == 0)
  {
    this->FillTables(measured, share, outputs);
  }

  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      this->AddSummary(measured.Mean, share, data);
      PackData::AddPackSummary(data, pack, share.NumberOfSpheres, measured.Mean.Fractions, overlap);
      if (region)
      {
        this->AddRegionSummary(data, *region);
        OutputSummary::AddSamples(data,
          { this->Method == TEMPLATE_SAMPLING ? "NumberOfThrows" : "NumberOfLines",
            measured.Samples, measured.TotalError, measured.Stopped });
      }
    });
  this->AddConsistency(measured.Mean, share, vtkTable::GetData(outputs, CHECKS));
  OutputSummary::WarnOfStop(this, measured.Stopped, ranks);
}

ruc::SampledTwoPoint vtkRUCTwoPointProbability::Measure(const ruc::PackShare& share,
  const ruc::SamplingRegion* region, const ruc::LagGrid& lags, RankCommunicator& ranks,
  ProgressReport& report) const
{
  const auto progress = [&](double done, const std::string& text)
  { return ranks.Rank() != 0 || report.Update(done, text); };
  const int modes = share.NumberOfModes();
  switch (this->Method)
  {
    case CHORD_SAMPLING:
      return ruc::SampleChords(
        share.Own, modes, *region, lags, this->GetSettings(false), ranks, progress);
    case TEMPLATE_SAMPLING:
      return ruc::SampleTemplate(
        share.Own, modes, *region, lags, this->GetSettings(true), ranks, progress);
    default: // the exact method, which has no errors
      return { ruc::SumPairs(share, lags, ranks, report.ForSums(ranks)), {}, {}, {}, 0, 0.0,
        false };
  }
}

void vtkRUCTwoPointProbability::AddErrors(const ruc::TwoPointProbability& probability,
  const ruc::TwoPointErrors& errors, vtkInformationVector* outputs, const RankCommunicator& ranks)
{
  const std::string walls = ruc::DescribeWalls(probability, errors);
  const std::string failures = ruc::DescribeFailures(errors.Layers);
  const std::string medium =
    failures.empty() ? "The pack is one medium within its scatter." : failures;
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      PackData::AddField(data, "NumberOfBlocks", std::vector<long long>{ errors.Blocks });
      PackData::AddField(
        data, "ObjectiveFloor", std::vector<double>{ ruc::ObjectiveFloor(probability, errors) });
      PackData::AddField(data, "c_error", errors.Fractions);
      PackData::AddField(data, "OneMedium", medium);
    });
  PackData::AddField(vtkTable::GetData(outputs, CHECKS), "SpecificSurface_error",
    std::vector<double>{ errors.Surface });
  for (const std::string& text : { failures, walls })
  {
    if (ranks.Rank() == 0 && !text.empty())
    {
      vtkWarningMacro(<< text);
    }
  }
}

void vtkRUCTwoPointProbability::FillTables(const ruc::SampledTwoPoint& measured,
  const ruc::PackShare& share, vtkInformationVector* outputs) const
{
  const ruc::TwoPointProbability& probability = measured.Mean;
  const std::vector<ruc::TwoPointCheck> checks =
    ruc::CheckTwoPointProbability(probability, this->SaturationTolerance, share.MeanDiameter());
  TwoPointTables::FillProbabilities(measured, vtkTable::GetData(outputs, PROBABILITIES));
  TwoPointTables::FillChecks(
    probability, checks, measured.Asymmetry, vtkTable::GetData(outputs, CHECKS));
  TwoPointTables::FillGradients(probability, vtkTable::GetData(outputs, GRADIENTS));
  TwoPointTables::FillAutocovariance(probability, vtkTable::GetData(outputs, AUTOCOVARIANCES));
}

void vtkRUCTwoPointProbability::AddSummary(const ruc::TwoPointProbability& probability,
  const ruc::PackShare& share, vtkDataObject* data) const
{
  const double saturation =
    ruc::SaturationLength(probability, this->SaturationTolerance, share.MeanDiameter());
  PackData::AddField(data, "Method", std::string(MethodNames[this->Method]));
  OutputSummary::AddLags(data, probability.Lags);
  PackData::AddField(data, "SaturationLength", std::vector<double>{ saturation });
}

void vtkRUCTwoPointProbability::AddConsistency(
  const ruc::TwoPointProbability& probability, const ruc::PackShare& share, vtkTable* table) const
{
  const double sum =
    std::accumulate(probability.Fractions.begin(), probability.Fractions.end(), 0.0);
  const double surface = std::accumulate(share.Surface.begin(), share.Surface.end(), 0.0);
  const int m = probability.Modes;
  const double slope = ruc::Gradient(probability.S(m, m), probability.Lags.Spacing).front();
  PackData::AddField(table, "VolumeCheck", std::vector<double>{ 1.0 - sum });
  PackData::AddField(table, "SphereVolumeFractions", ruc::OnePointProbability(share));
  PackData::AddField(
    table, "SpecificSurface", std::vector<double>{ surface / share.Observed.Volume() });
  PackData::AddField(table, "SpecificSurfaceFromSlope", std::vector<double>{ -4.0 * slope });
}

std::optional<ruc::Estimate> vtkRUCTwoPointProbability::MakeEstimate()
{
  this->ValidateProperties();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::LagGrid lags = StatisticsEstimate::FindLags(
    this->MaximumLag, this->NumberOfLags, *pack, this->Method == EXACT_PAIR_SUM);
  ruc::Estimate estimate = StatisticsEstimate::OfPack(*pack, this->MaximumLag, lags);
  estimate += StatisticsEstimate::OfTables(*pack, 3);
  if (this->Method == EXACT_PAIR_SUM)
  {
    estimate += ruc::EstimatePairSum(*pack, lags);
    if (this->Blocks > 0)
    {
      estimate += ruc::EstimatePairSumErrors(*pack, lags, this->Blocks);
    }
    return estimate;
  }
  const bool throws = this->Method == TEMPLATE_SAMPLING;
  const std::optional<double> samples =
    StatisticsEstimate::NumberOfSamples(this->GetSettings(throws));
  if (!samples)
  {
    return {};
  }
  estimate += throws ? ruc::EstimateTemplate(*pack, lags, *samples)
                     : ruc::EstimateChords(*pack, lags, *samples);
  return estimate;
}

void vtkRUCTwoPointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "SaturationTolerance: " << this->SaturationTolerance << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
}
