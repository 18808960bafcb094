// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCChordLengths.h"

#include "MeasuredLags.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "StatisticsEstimate.h"
#include "TwoPointTables.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkRUCChordLengths);

int vtkRUCChordLengths::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCChordLengths::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const ruc::PackShare& share = pack.Share;
  const double overlap = this->CheckOverlap(share, false, ranks);
  const std::unique_ptr<ruc::SamplingRegion> region = this->MakeRegion(pack, ranks);
  const ruc::LagGrid lags =
    MeasuredLags::Find(this->MaximumLag, this->NumberOfLags, share, region.get(), this->HasMask());
  ruc::ChordLengths chords;
  const ruc::SampledTwoPoint sampled = ruc::SampleChords(
    share.Own, share.NumberOfModes(), *region, lags, this->GetSettings(false), ranks,
    [&](double done, const std::string& text)
    { return ranks.Rank() != 0 || report.Update(done, text); },
    &chords);

  vtkTable* table = vtkTable::GetData(outputs);
  if (ranks.Rank() == 0)
  {
    TwoPointTables::FillChordLengths(chords, table);
  }
  OutputSummary::AddLags(table, lags);
  PackData::AddPackSummary(table, pack, share.NumberOfSpheres, sampled.Mean.Fractions, overlap);
  this->AddRegionSummary(table, *region);
  OutputSummary::AddSamples(
    table, { "NumberOfLines", sampled.Samples, sampled.TotalError, sampled.Stopped });
  OutputSummary::WarnOfStop(this, sampled.Stopped, ranks);
}

std::optional<ruc::Estimate> vtkRUCChordLengths::MakeEstimate()
{
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  const std::optional<double> lines = StatisticsEstimate::NumberOfSamples(this->GetSettings(false));
  if (!pack || !lines)
  {
    return {};
  }
  const ruc::LagGrid lags =
    StatisticsEstimate::FindLags(this->MaximumLag, this->NumberOfLags, *pack, false);
  ruc::Estimate estimate = StatisticsEstimate::OfPack(*pack, this->MaximumLag, lags);
  estimate += ruc::EstimateChords(*pack, lags, *lines);
  return estimate;
}

void vtkRUCChordLengths::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
}
