// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCVoidDistances.h"

#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Statistics/Neighbours/VoidDistances.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <limits>

vtkStandardNewMacro(vtkRUCVoidDistances);

namespace
{
constexpr double ManyBeyond = 0.01;

// A column of values and one of their errors
void AddFigures(vtkTable* table, const char* name, const char* nameOfError,
  const std::vector<ruc::ValueWithError>& figures)
{
  std::vector<double> values, errors;
  for (const ruc::ValueWithError& figure : figures)
  {
    values.push_back(figure.Value);
    errors.push_back(figure.Error);
  }
  PackData::AddColumn(table, name, values);
  PackData::AddColumn(table, nameOfError, errors);
}

void FillPores(const ruc::VoidDistances& found, vtkTable* table)
{
  PackData::AddColumn(table, "Quantity",
    std::vector<std::string>{ "mean distance", "largest distance", "critical radius x",
      "critical radius y", "critical radius z" });
  AddFigures(table, "Value", "Error",
    { found.Mean, { found.Largest, std::numeric_limits<double>::quiet_NaN() },
      found.CriticalRadius[0], found.CriticalRadius[1], found.CriticalRadius[2] });
}
}

vtkRUCVoidDistances::vtkRUCVoidDistances()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkRUCVoidDistances::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

ruc::VoidSettings vtkRUCVoidDistances::MakeSettings() const
{
  return { this->Spacing, this->MaximumDistance, this->NumberOfDistances, this->Blocks };
}

double vtkRUCVoidDistances::GetAutomaticMargin(const ruc::PackTotals& pack) const
{
  return pack.LargestRadius + ruc::WithMaximumDistance(this->MakeSettings(), pack).MaximumDistance;
}

void vtkRUCVoidDistances::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  const ruc::VoidSettings settings = this->MakeSettings();
  ruc::CheckSettings(settings);
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const std::unique_ptr<ruc::SamplingRegion> region = this->MakeRegion(pack, ranks);
  const ruc::VoidDistances found =
    ruc::MeasureVoids(pack.Share, *region, settings, ranks, report.ForPairs(ranks));
  const double overlap = this->CheckOverlap(pack.Share, false, ranks);
  if (ranks.Rank() == 0)
  {
    vtkTable* table = vtkTable::GetData(outputs, DISTANCES);
    PackData::AddColumn(table, "z", found.Distance);
    AddFigures(table, "P", "P_error", found.Share);
    FillPores(found, vtkTable::GetData(outputs, PORES));
  }
  // A pack that does not fill its window is told of already
  if (ranks.Rank() == 0 && found.Beyond > ManyBeyond && pack.Warnings.empty())
  {
    vtkWarningMacro(<< 100.0 * found.Beyond << " % of the matrix is MaximumDistance, "
                    << found.MaximumDistance
                    << ", or farther from every sphere, and counts as that far.");
  }
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      this->AddSummary(found, data);
      this->AddMarginSummary(data, *region);
      PackData::AddPackSummary(
        data, pack, pack.Share.NumberOfSpheres, ruc::OnePointProbability(pack.Share), overlap);
    });
}

void vtkRUCVoidDistances::AddSummary(const ruc::VoidDistances& found, vtkDataObject* data) const
{
  PackData::AddField(data, "Spacing", std::vector<double>{ found.Spacing });
  PackData::AddField(data, "MaximumDistance", std::vector<double>{ found.MaximumDistance });
  PackData::AddField(
    data, "NumberOfPoints", std::vector<long long>{ static_cast<long long>(found.Points) });
  PackData::AddField(data, "NumberOfBlocks", std::vector<long long>{ found.Blocks });
}

std::optional<ruc::Estimate> vtkRUCVoidDistances::MakeEstimate()
{
  const ruc::VoidSettings settings = this->MakeSettings();
  ruc::CheckSettings(settings);
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::Estimate voids = ruc::EstimateVoids(*pack, settings);
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  estimate += voids;
  estimate.Automatic = voids.Automatic;
  return estimate;
}

void vtkRUCVoidDistances::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "NumberOfDistances: " << this->NumberOfDistances << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
}
