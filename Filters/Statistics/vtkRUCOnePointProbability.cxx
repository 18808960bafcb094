// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCOnePointProbability.h"

#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "StatisticsEstimate.h"
#include "ruc/Base/Require.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/Sampling/TemplateSampling.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkRUCOnePointProbability);

namespace
{
const char* const MethodNames[] = { "Sphere Volumes", "Chord Sampling", "Template Sampling" };

// `errors` is empty where none are known
void FillTable(
  const std::vector<double>& fractions, const std::vector<double>& errors, vtkTable* table)
{
  std::vector<std::string> phases;
  for (std::size_t r = 1; r < fractions.size(); ++r)
  {
    phases.push_back(std::to_string(r));
  }
  phases.push_back("m");
  PackData::AddColumn(table, "Phase", phases);
  PackData::AddColumn(table, "VolumeFraction", fractions);
  if (!errors.empty())
  {
    PackData::AddColumn(table, "VolumeFraction_error", errors);
  }
}
}

int vtkRUCOnePointProbability::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCOnePointProbability::ValidateProperties()
{
  ruc::Require(this->Method >= SPHERE_VOLUMES && this->Method <= TEMPLATE_SAMPLING, "Method",
    "a value from 0 to 2", this->Method);
  ruc::Require(!this->HasMask() || this->Method != SPHERE_VOLUMES, "Mask",
    "Method Chord Sampling or Template Sampling", "Sphere Volumes");
}

void vtkRUCOnePointProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const bool exact = this->Method == SPHERE_VOLUMES;
  const double overlap = this->CheckOverlap(pack.Share, exact, ranks);
  vtkTable* table = vtkTable::GetData(outputs);
  std::vector<double> fractions, errors;
  if (exact)
  {
    fractions = ruc::OnePointProbability(pack.Share);
  }
  else
  {
    const ruc::SampledTwoPoint sampled = this->Sample(pack, table, ranks, report);
    fractions = sampled.Mean.Fractions;
    errors = sampled.FractionErrors;
  }
  if (ranks.Rank() == 0)
  {
    FillTable(fractions, errors, table);
  }
  PackData::AddField(table, "Method", std::string(MethodNames[this->Method]));
  PackData::AddPackSummary(table, pack, pack.Share.NumberOfSpheres, fractions, overlap);
}

ruc::SampledTwoPoint vtkRUCOnePointProbability::Sample(const PackData::SharedPack& pack,
  vtkTable* table, RankCommunicator& ranks, ProgressReport& report)
{
  const std::unique_ptr<ruc::SamplingRegion> region = this->MakeRegion(pack, ranks);
  const bool throws = this->Method == TEMPLATE_SAMPLING;
  const auto progress = [&](double done, const std::string& text)
  { return ranks.Rank() != 0 || report.Update(done, text); };
  const ruc::LagGrid noLags = { 1.0, 0 };
  const ruc::SamplingSettings settings = this->GetSettings(throws);
  const int modes = pack.Share.NumberOfModes();
  ruc::SampledTwoPoint sampled = throws
    ? ruc::SampleTemplate(pack.Share.Own, modes, *region, noLags, settings, ranks, progress)
    : ruc::SampleChords(pack.Share.Own, modes, *region, noLags, settings, ranks, progress);
  this->AddRegionSummary(table, *region);
  OutputSummary::AddSamples(table,
    { throws ? "NumberOfThrows" : "NumberOfLines", sampled.Samples, sampled.TotalError,
      sampled.Stopped });
  OutputSummary::WarnOfStop(this, sampled.Stopped, ranks);
  return sampled;
}

std::optional<ruc::Estimate> vtkRUCOnePointProbability::MakeEstimate()
{
  this->ValidateProperties();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::LagGrid noLags = { 1.0, 0 };
  const bool throws = this->Method == TEMPLATE_SAMPLING;
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  if (this->Method != SPHERE_VOLUMES)
  {
    const std::optional<double> samples =
      StatisticsEstimate::NumberOfSamples(this->GetSettings(throws));
    if (!samples)
    {
      return {};
    }
    estimate += throws ? ruc::EstimateTemplate(*pack, noLags, *samples)
                       : ruc::EstimateChords(*pack, noLags, *samples);
  }
  return estimate;
}

void vtkRUCOnePointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
}
