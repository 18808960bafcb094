// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCRadialDistribution.h"

#include "MeasuredLags.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "StatisticsEstimate.h"
#include "TwoPointTables.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/PairSums/RadialDistribution.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkRUCRadialDistribution);

int vtkRUCRadialDistribution::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCRadialDistribution::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  // Overlaps do not count twice here, as only centres count
  const double overlap = this->CheckOverlap(pack.Share, false, ranks);
  const ruc::LagGrid lags = MeasuredLags::Find(this->MaximumLag, this->NumberOfLags, pack.Share);
  const ruc::RadialDistribution distribution =
    ruc::MeasureRadialDistribution(pack.Share, lags, ranks, report.ForSums(ranks));

  vtkTable* table = vtkTable::GetData(outputs);
  if (ranks.Rank() == 0)
  {
    TwoPointTables::FillRadialDistribution(distribution, table);
    std::string unknown;
    for (int r = 0; r < distribution.Modes; ++r)
    {
      // With itself only: a mode has at least one centre
      if (std::isnan(distribution.Values[distribution.PairOf(r, r)].back()))
      {
        unknown += ruc::Text(unknown.empty() ? "" : ", ", "g_", r + 1, "_", r + 1);
      }
    }
    if (!unknown.empty())
    {
      vtkWarningMacro(<< unknown << " require two or more centres of the mode and are not known.");
    }
  }
  OutputSummary::AddLags(table, lags);
  PackData::AddPackSummary(
    table, pack, pack.Share.NumberOfSpheres, ruc::OnePointProbability(pack.Share), overlap);
}

std::optional<ruc::Estimate> vtkRUCRadialDistribution::MakeEstimate()
{
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::LagGrid lags =
    StatisticsEstimate::FindLags(this->MaximumLag, this->NumberOfLags, *pack, true);
  ruc::Estimate estimate = StatisticsEstimate::OfPack(*pack, this->MaximumLag, lags);
  estimate += StatisticsEstimate::OfTables(*pack, 1);
  estimate += ruc::EstimateRadialDistribution(*pack, lags);
  return estimate;
}

void vtkRUCRadialDistribution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
}
