// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCCellSizeStudy.h"

#include "OutputSummary.h"
#include "PackData.h"
#include "PackEstimate.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Base/Range.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/OnePointProbability.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

vtkStandardNewMacro(vtkRUCCellSizeStudy);

namespace
{
constexpr int MostSizes = 100;

enum Ports
{
  SIZES = 0,
  DESCRIPTORS = 1
};

// The mean of F2 over the cells of a size, and its standard deviation
std::pair<double, double> MeanOf(const std::vector<double>& values)
{
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return { mean,
    count > 1.0 ? std::sqrt(squares / (count - 1.0)) : std::numeric_limits<double>::quiet_NaN() };
}

void FillSizes(const ruc::CellSizeStudy& study, vtkTable* table)
{
  std::vector<long long> spheres, within, all;
  std::vector<double> edge, mean, deviation, floor, largest, fitted, bound;
  for (const ruc::CellsOfSize& of : study.Sizes)
  {
    spheres.push_back(of.Spheres);
    edge.push_back(of.Edge);
    mean.push_back(MeanOf(of.Objectives).first);
    deviation.push_back(MeanOf(of.Objectives).second);
    floor.push_back(study.Floor);
    largest.push_back(of.LargestZ(false));
    fitted.push_back(of.LargestZ(true));
    within.push_back(of.Card.Within());
    all.push_back(static_cast<long long>(of.Card.Rows.size()));
    bound.push_back(ruc::ReportCard::MostZ);
  }
  PackData::AddColumn(table, "Spheres", spheres);
  PackData::AddColumn(table, "Edge", edge);
  PackData::AddColumn(table, "F2", mean);
  PackData::AddColumn(table, "F2_deviation", deviation);
  PackData::AddColumn(table, "ObjectiveFloor", floor);
  PackData::AddColumn(table, "LargestZ", largest);
  PackData::AddColumn(table, "LargestFittedZ", fitted);
  PackData::AddColumn(table, "NumberWithin", within);
  PackData::AddColumn(table, "NumberOfDescriptors", all);
  PackData::AddColumn(table, "Bound", bound);
}

const ruc::ReportRow* FindRow(const ruc::ReportCard& card, const std::string& name)
{
  const auto row = std::find_if(
    card.Rows.begin(), card.Rows.end(), [&](const auto& of) { return of.Name == name; });
  return row == card.Rows.end() ? nullptr : &*row;
}

void FillDescriptors(const ruc::CellSizeStudy& study, vtkTable* table)
{
  if (study.Sizes.empty())
  {
    return;
  }
  std::vector<std::string> names;
  std::vector<double> pack, error;
  std::vector<long long> fitted;
  std::vector<std::vector<double>> z(study.Sizes.size());
  for (const ruc::ReportRow& row : study.Sizes.front().Card.Rows)
  {
    const auto has = [&](const ruc::CellsOfSize& of) { return FindRow(of.Card, row.Name); };
    if (std::all_of(study.Sizes.begin(), study.Sizes.end(), has))
    {
      names.push_back(row.Name);
      pack.push_back(row.Pack);
      error.push_back(row.PackError);
      fitted.push_back(row.Fitted);
      for (std::size_t n = 0; n < z.size(); ++n)
      {
        z[n].push_back(FindRow(study.Sizes[n].Card, row.Name)->Z);
      }
    }
  }
  PackData::AddColumn(table, "Descriptor", names);
  PackData::AddColumn(table, "Pack", pack);
  PackData::AddColumn(table, "Pack_error", error);
  PackData::AddColumn(table, "Fitted", fitted);
  for (std::size_t n = 0; n < z.size(); ++n)
  {
    PackData::AddColumn(table, ruc::Text("Z_", study.Sizes[n].Spheres), z[n]);
  }
}

void AddSummary(const ruc::CellSizeStudy& study, int cells, vtkDataObject* data)
{
  const auto whole = [&](const char* name, long long number)
  { PackData::AddField(data, name, std::vector<long long>{ number }); };
  PackData::AddField(data, "Verdict", study.Verdict());
  whole("LeastSize", study.LeastSize(false));
  whole("LeastFittedSize", study.LeastSize(true));
  PackData::AddField(data, "ObjectiveFloor", std::vector<double>{ study.Floor });
  whole("NumberOfCells", cells);
  OutputSummary::AddLags(data, study.Lags);
  std::string leftOut;
  for (const std::string& reason : study.LeftOut)
  {
    leftOut += (leftOut.empty() ? "" : " ") + reason;
  }
  if (!leftOut.empty())
  {
    PackData::AddField(data, "LeftOut", leftOut);
  }
  whole("Stopped", study.Stopped);
}
}

vtkRUCCellSizeStudy::vtkRUCCellSizeStudy()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkRUCCellSizeStudy::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCCellSizeStudy::ClearSizes()
{
  this->Sizes.clear();
  this->Modified();
}

void vtkRUCCellSizeStudy::SetSize(int i, int spheres)
{
  if (i < 0 || i >= MostSizes)
  {
    vtkErrorMacro(<< "Sizes has places 0 to " << MostSizes - 1 << ", got " << i);
    return;
  }
  this->Sizes.resize(std::max(this->Sizes.size(), std::size_t(i) + 1));
  this->Sizes[i] = spheres;
  this->Modified();
}

ruc::CellSizeSettings vtkRUCCellSizeStudy::MakeSettings() const
{
  ruc::Range::AtLeast(0).Check("Seed", this->Seed);
  ruc::CellSizeSettings settings;
  settings.Sizes = this->Sizes;
  settings.Cells = this->NumberOfCells;
  settings.MaximumLag = this->MaximumLag;
  settings.NumberOfLags = this->NumberOfLags;
  settings.Blocks = this->Blocks;
  settings.Search.Seed = static_cast<std::uint32_t>(this->Seed);
  settings.Search.MaximumIterations = this->MaximumIterations;
  settings.Search.Neighbours.ContactWeight = this->ContactWeight;
  settings.Search.Neighbours.PoreWeight = this->PoreWeight;
  settings.Search.Neighbours.SpectrumWeight = this->SpectrumWeight;
  return settings;
}

void vtkRUCCellSizeStudy::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  const ruc::CellSizeSettings settings = this->MakeSettings();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  const double overlap = this->CheckOverlap(pack.Share, true, ranks);
  const ruc::CellSizeStudy study = ruc::StudyCellSizes(pack.Share, settings, ranks,
    [&](double done, const std::string& what)
    { return ranks.Rank() != 0 || report.Update(done, what); });
  if (ranks.Rank() == 0)
  {
    FillSizes(study, vtkTable::GetData(outputs, SIZES));
    FillDescriptors(study, vtkTable::GetData(outputs, DESCRIPTORS));
  }
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      AddSummary(study, this->NumberOfCells, data);
      PackData::AddPackSummary(
        data, pack, pack.Share.NumberOfSpheres, ruc::OnePointProbability(pack.Share), overlap);
    });
  OutputSummary::WarnOfStop(this, study.Stopped, ranks);
}

std::optional<ruc::Estimate> vtkRUCCellSizeStudy::MakeEstimate()
{
  const ruc::CellSizeSettings settings = this->MakeSettings();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  estimate += ruc::EstimateCellSizes(*pack, settings);
  return estimate;
}

void vtkRUCCellSizeStudy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sizes:";
  for (int size : this->Sizes)
  {
    os << " " << size;
  }
  os << "\n";
  os << indent << "NumberOfCells: " << this->NumberOfCells << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "ContactWeight: " << this->ContactWeight << "\n";
  os << indent << "PoreWeight: " << this->PoreWeight << "\n";
  os << indent << "SpectrumWeight: " << this->SpectrumWeight << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
