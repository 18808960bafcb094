// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCNeighbourStatistics.h"

#include "NeighbourTables.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkRUCNeighbourStatistics);

namespace
{
constexpr std::int64_t FewCentres = 30;
constexpr double ManyCells = 0.99; // of the centres
}

vtkRUCNeighbourStatistics::vtkRUCNeighbourStatistics()
{
  this->SetNumberOfOutputPorts(4);
}

int vtkRUCNeighbourStatistics::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool isTable = port == GAPS || port == MEANS;
  info->Set(vtkDataObject::DATA_TYPE_NAME(), isTable ? "vtkTable" : "vtkPolyData");
  return 1;
}

ruc::NeighbourSettings vtkRUCNeighbourStatistics::MakeSettings() const
{
  return { this->ContactTolerance, this->MaximumGap, this->NumberOfGaps, this->Blocks };
}

double vtkRUCNeighbourStatistics::GetAutomaticMargin(const ruc::PackTotals& pack) const
{
  return ruc::NeighbourMargin(pack.LargestRadius, this->MaximumGap);
}

void vtkRUCNeighbourStatistics::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  const ruc::NeighbourSettings settings = this->MakeSettings();
  ruc::CheckSettings(settings);
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const std::unique_ptr<ruc::SamplingRegion> region = this->MakeRegion(pack, ranks);
  const ruc::NeighbourStatistics found = ruc::MeasureNeighbours(pack.Share,
    { *region, this->GetUsedMargin(), this->HasMask() }, settings, ranks, report.ForPairs(ranks));
  const double overlap = this->CheckOverlap(pack.Share, false, ranks);
  if (ranks.Rank() == 0)
  {
    NeighbourTables::FillGaps(found, vtkTable::GetData(outputs, GAPS));
    NeighbourTables::FillMeans(found, vtkTable::GetData(outputs, MEANS));
    this->Warn(found);
  }
  vtkPolyData* spheres = vtkPolyData::GetData(outputs, PACK);
  NeighbourTables::FillPack(pack.Share.Own, found, spheres);
  NeighbourTables::FillContacts(found, vtkPolyData::GetData(outputs, CONTACTS));
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      this->AddSummary(found, data);
      this->AddMarginSummary(data, *region);
      if (data != spheres)
      {
        PackData::AddPackSummary(
          data, pack, pack.Share.NumberOfSpheres, ruc::OnePointProbability(pack.Share), overlap);
      }
    });
  // A pack for filters downstream, which take a window of its field data for one that is known
  PackData::AddField(spheres, "NumberOfSpheres",
    std::vector<long long>{ static_cast<long long>(pack.Share.NumberOfSpheres) });
  PackData::AddOrigin(spheres, pack);
  PackData::AddKnownWindow(spheres, pack);
}

void vtkRUCNeighbourStatistics::AddSummary(
  const ruc::NeighbourStatistics& found, vtkDataObject* data) const
{
  PackData::AddField(data, "ContactTolerance", std::vector<double>{ this->ContactTolerance });
  PackData::AddField(data, "MaximumGap", std::vector<double>{ this->MaximumGap });
  PackData::AddField(
    data, "NumberOfCentres", std::vector<long long>{ static_cast<long long>(found.Counted) });
  PackData::AddField(
    data, "NumberOfCells", std::vector<long long>{ static_cast<long long>(found.Cells) });
  PackData::AddField(data, "NumberOfBlocks", std::vector<long long>{ found.Blocks });
}

void vtkRUCNeighbourStatistics::Warn(const ruc::NeighbourStatistics& found)
{
  if (found.Counted < FewCentres)
  {
    vtkWarningMacro(<< "only " << found.Counted << " spheres count, which lie WindowMargin, "
                    << this->GetUsedMargin()
                    << ", from every face that is not periodic; fewer than " << FewCentres
                    << " tell little of a pack.");
  }
  if (static_cast<double>(found.Cells) < ManyCells * static_cast<double>(found.Counted))
  {
    vtkWarningMacro(<< "of the " << found.Counted << " spheres that count, "
                    << found.Counted - found.Cells
                    << " have no cell that is known, since spheres beyond the border of the window "
                       "may cut it; a larger WindowMargin leaves fewer of them.");
  }
}

std::optional<ruc::Estimate> vtkRUCNeighbourStatistics::MakeEstimate()
{
  const ruc::NeighbourSettings settings = this->MakeSettings();
  ruc::CheckSettings(settings);
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  estimate += ruc::EstimateNeighbours(*pack, settings);
  return estimate;
}

void vtkRUCNeighbourStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContactTolerance: " << this->ContactTolerance << "\n";
  os << indent << "MaximumGap: " << this->MaximumGap << "\n";
  os << indent << "NumberOfGaps: " << this->NumberOfGaps << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
}
