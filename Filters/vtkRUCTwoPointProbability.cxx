// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCTwoPointProbability.h"

#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "Reconstruction/OverlapRemoval.h"
#include "Statistics/TwoPointChecks.h"
#include "Statistics/TwoPointProbability.h"
#include "TwoPointSum.h"
#include "Text.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCTwoPointProbability);

namespace
{
void FillProbabilities(const ruc::TwoPointProbability& probability, vtkTable* table)
{
  PackData::AddLags(table, probability.Lags);
  for (int r = 0; r < probability.Phases(); ++r)
  {
    for (int s = r; s < probability.Phases(); ++s)
    {
      PackData::AddColumn(table, PackData::PairName(probability, r, s), probability.S(r, s));
    }
  }
}

void FillChecks(const ruc::TwoPointProbability& probability,
  const std::vector<ruc::TwoPointCheck>& checks, vtkTable* table)
{
  std::vector<std::string> pair;
  std::vector<double> limit, zero, infinity, asymmetry, saturation;
  for (int r = 0; r < probability.Phases(); ++r)
  {
    for (int s = r; s < probability.Phases(); ++s)
    {
      pair.push_back(PackData::PairName(probability, r, s));
    }
  }
  for (const ruc::TwoPointCheck& check : checks)
  {
    limit.push_back(check.Limit);
    zero.push_back(check.ErrorAtZero);
    infinity.push_back(check.ErrorAtInfinity);
    asymmetry.push_back(check.Asymmetry);
    saturation.push_back(check.SaturationLength);
  }
  PackData::AddColumn(table, "Pair", pair);
  PackData::AddColumn(table, "Limit", limit);
  PackData::AddColumn(table, "ErrorAtZero", zero);
  PackData::AddColumn(table, "ErrorAtInfinity", infinity);
  PackData::AddColumn(table, "Asymmetry", asymmetry);
  PackData::AddColumn(table, "SaturationLength", saturation);
}

void FillGradients(const ruc::TwoPointProbability& probability, vtkTable* table)
{
  ruc::TwoPointProbability gradients = probability;
  for (std::vector<double>& values : gradients.Values)
  {
    values = ruc::Gradient(values, probability.Lags.Spacing);
  }
  FillProbabilities(gradients, table);
}
}

vtkRUCTwoPointProbability::vtkRUCTwoPointProbability()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkRUCTwoPointProbability::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCTwoPointProbability::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  if (this->Method != EXACT_PAIR_SUM)
  {
    throw std::invalid_argument(ruc::Text("Method requires the value 0, got ", this->Method, "."));
  }
  if (!(this->SaturationTolerance > 0.0))
  {
    throw std::invalid_argument(
      ruc::Text("SaturationTolerance requires a number > 0, got ", this->SaturationTolerance, "."));
  }
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack =
    PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  const ruc::LagGrid lags = TwoPointSum::MakeLags(
    this->MaximumLag, this->NumberOfLags, TwoPointSum::AutomaticLag(pack.Share));
  const ruc::TwoPointProbability probability =
    TwoPointSum::Compute(pack.Share, lags, ranks, report);
  const double diameter = pack.Share.MeanDiameter();
  const std::vector<ruc::TwoPointCheck> checks =
    ruc::CheckTwoPointProbability(probability, this->SaturationTolerance, diameter);
  if (ranks.Rank() == 0)
  {
    FillProbabilities(probability, vtkTable::GetData(outputs, 0));
    FillChecks(probability, checks, vtkTable::GetData(outputs, 1));
    FillGradients(probability, vtkTable::GetData(outputs, 2));
  }
  const double overlap = ruc::MeasureOverlap(pack.Share, ranks).Percent;
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkTable* table = vtkTable::GetData(outputs, port);
    PackData::AddField(table, "Method", std::string("Exact Pair Sum"));
    PackData::AddField(table, "NumberOfLags", std::vector<long long>{ lags.Count });
    PackData::AddField(table, "MaximumLag", std::vector<double>{ lags.Maximum() });
    PackData::AddField(table, "SaturationLength",
      std::vector<double>{
        ruc::SaturationLength(probability, this->SaturationTolerance, diameter) });
    PackData::AddPackSummary(
      table, pack, pack.Share.NumberOfSpheres, probability.Fractions, overlap);
  }
  if (ranks.Rank() == 0 && overlap > PackData::TolerableOverlap)
  {
    vtkWarningMacro(<< this->GetLabel() << PackData::OverlapWarning(overlap));
  }
}

void vtkRUCTwoPointProbability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "SaturationTolerance: " << this->SaturationTolerance << "\n";
}
