// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCOnePointProbability.h"

#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"
#include "ruc/Statistics/Sampling/TemplateSampling.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <stdexcept>

vtkStandardNewMacro(vtkRUCOnePointProbability);

namespace
{
const char* const MethodNames[] = { "Sphere Volumes", "Chord Sampling", "Template Sampling" };
}

int vtkRUCOnePointProbability::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCOnePointProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  if (this->Method < SPHERE_VOLUMES || this->Method > TEMPLATE_SAMPLING)
  {
    throw std::invalid_argument(
      ruc::Text("Method requires a value from 0 to 2, got ", this->Method, "."));
  }
  if (this->Method == SPHERE_VOLUMES && this->HasMask())
  {
    throw std::invalid_argument(
      "Mask requires Method Chord Sampling or Template Sampling, got Sphere Volumes.");
  }
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack =
    PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  vtkTable* table = vtkTable::GetData(outputs, 0);
  std::vector<double> fractions, errors;
  if (this->Method == SPHERE_VOLUMES)
  {
    fractions = ruc::OnePointProbability(pack.Share);
    errors.assign(fractions.size(), 0.0);
  }
  else
  {
    const std::unique_ptr<ruc::SamplingRegion> region = this->MakeRegion(pack, ranks);
    const bool throws = this->Method == TEMPLATE_SAMPLING;
    const auto progress = [&](double done, const std::string& text)
    { return ranks.Rank() != 0 || report.Update(done, text); };
    const ruc::LagGrid noLags = { 1.0, 0 };
    const ruc::SamplingSettings settings = this->GetSettings(throws);
    const int modes = pack.Share.NumberOfModes();
    const ruc::SampledTwoPoint sampled = throws
      ? ruc::SampleTemplate(pack.Share.Own, modes, *region, noLags, settings, ranks, progress)
      : ruc::SampleChords(pack.Share.Own, modes, *region, noLags, settings, ranks, progress);
    fractions = sampled.Mean.Fractions;
    errors = sampled.FractionErrors;
    this->AddRegionSummary(table, *region);
    PackData::AddField(table, throws ? "NumberOfThrows" : "NumberOfLines",
      std::vector<long long>{ static_cast<long long>(sampled.Samples) });
    PackData::AddField(table, "TotalError", std::vector<double>{ sampled.TotalError });
    PackData::AddField(table, "Stopped", std::vector<long long>{ sampled.Stopped });
    if (sampled.Stopped && ranks.Rank() == 0)
    {
      vtkWarningMacro(<< this->GetLabel() << ": stopped after " << sampled.Samples
                      << (throws ? " throws." : " lines."));
    }
  }
  if (ranks.Rank() == 0)
  {
    std::vector<std::string> phases;
    for (std::size_t r = 1; r < fractions.size(); ++r)
    {
      phases.push_back(std::to_string(r));
    }
    phases.push_back("m");
    PackData::AddColumn(table, "Phase", phases);
    PackData::AddColumn(table, "VolumeFraction", fractions);
    PackData::AddColumn(table, "VolumeFraction_error", errors);
  }
  PackData::AddField(table, "Method", std::string(MethodNames[this->Method]));
  const double overlap = ruc::MeasureOverlap(pack.Share, ranks).Percent;
  PackData::AddPackSummary(table, pack, pack.Share.NumberOfSpheres, fractions, overlap);
  if (this->Method == SPHERE_VOLUMES && ranks.Rank() == 0 && overlap > PackData::TolerableOverlap)
  {
    vtkWarningMacro(<< this->GetLabel() << PackData::OverlapWarning(overlap));
  }
}

void vtkRUCOnePointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
}
