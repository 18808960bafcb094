// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCCompareWithPack.h"

#include "OutputSummary.h"
#include "PackData.h"
#include "PackInput.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Statistics/Comparison/ReportCard.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRUCCompareWithPack);

namespace
{
// The packs of a port. With `byBlock` each block of a multiblock data set is one
std::vector<vtkDataObject*> FindObjects(vtkInformationVector* port, bool byBlock)
{
  std::vector<vtkDataObject*> objects;
  for (int n = 0; n < port->GetNumberOfInformationObjects(); ++n)
  {
    vtkDataObject* data = vtkDataObject::GetData(port, n);
    auto* blocks = byBlock ? vtkMultiBlockDataSet::SafeDownCast(data) : nullptr;
    for (unsigned int b = 0; blocks && b < blocks->GetNumberOfBlocks(); ++b)
    {
      objects.push_back(blocks->GetBlock(b));
    }
    if (!blocks)
    {
      objects.push_back(data);
    }
  }
  return objects;
}

std::vector<PackData::SharedPack> FindPacks(
  const std::vector<vtkDataObject*>& objects, RankCommunicator& ranks)
{
  std::vector<PackData::SharedPack> packs;
  for (vtkDataObject* object : objects)
  {
    const vtkSmartPointer<vtkPointSet> points = PackInput::Find(object, ranks);
    packs.push_back(PackData::FindShare(points.Get(), {}, true, ranks));
    const double percent = ruc::MeasureOverlap(packs.back().Share, ranks).Percent;
    ruc::Require(percent <= PackData::MostOverlap, "The overlap of the spheres",
      ruc::Text("at most ", PackData::MostOverlap, " % of their volume, as for exact sums"),
      percent);
  }
  return packs;
}

// Whether the search that made all cells fits what a kind of descriptors tells of, by the field
// data that it leaves
std::vector<bool> FindFitted(const std::vector<vtkDataObject*>& cells, RankCommunicator& ranks)
{
  const auto all = [&](const std::string& field)
  {
    bool have = true;
    for (vtkDataObject* cell : cells)
    {
      std::int64_t holders =
        cell && cell->GetFieldData() && cell->GetFieldData()->GetAbstractArray(field.c_str());
      ranks.Sum(&holders, 1);
      have = have && holders > 0;
    }
    return have;
  };
  std::vector<bool> fitted(ruc::CountOf(ruc::DescriptorKind{}), false);
  const auto set = [&](ruc::DescriptorKind kind, bool is) { fitted[static_cast<int>(kind)] = is; };
  set(ruc::DescriptorKind::Fraction, all("Objective"));
  set(ruc::DescriptorKind::TwoPoint, all("Objective"));
  set(ruc::DescriptorKind::Gaps, all("GapMisfit"));
  set(ruc::DescriptorKind::Pores, all("PoreMisfit"));
  const bool spectrum = all("SpectrumMisfit"), thirdOrder = all("ThirdOrderMisfit");
  set(ruc::DescriptorKind::ThirdOrder, spectrum || thirdOrder);
  return fitted;
}

ruc::LagGrid FindLags(double maximum, int number, const std::vector<PackData::SharedPack>& packs,
  const std::vector<PackData::SharedPack>& cells)
{
  double last = maximum > 0.0 ? maximum : std::numeric_limits<double>::infinity();
  for (const auto* list : { &packs, &cells })
  {
    for (const PackData::SharedPack& pack : *list)
    {
      const ruc::LagLimit limit =
        ruc::LagLimit::ForPairSum(pack.Share.Observed, pack.Share.LargestRadius);
      last = maximum > 0.0 ? last : std::min(last, limit.Automatic);
    }
  }
  const ruc::PackShare& first = packs.front().Share;
  const ruc::LagLimit limit = ruc::LagLimit::ForPairSum(first.Observed, first.LargestRadius);
  return limit.MakeGrid(std::isfinite(last) ? last : maximum, number);
}

void FillReport(const ruc::ReportCard& card, vtkTable* table)
{
  std::vector<std::string> names;
  std::vector<double> pack, error, cell, deviation, z;
  std::vector<long long> fitted, row;
  for (const ruc::ReportRow& of : card.Rows)
  {
    names.push_back(of.Name);
    pack.push_back(of.Pack);
    error.push_back(of.PackError);
    cell.push_back(of.Cell);
    deviation.push_back(of.CellDeviation);
    z.push_back(of.Z);
    fitted.push_back(of.Fitted);
    row.push_back(static_cast<long long>(row.size()) + 1);
  }
  const std::vector<double> most(row.size(), ruc::ReportCard::MostZ);
  const std::vector<double> least(row.size(), -ruc::ReportCard::MostZ);
  PackData::AddColumn(table, "Descriptor", names);
  PackData::AddColumn(table, "Pack", pack);
  PackData::AddColumn(table, "Pack_error", error);
  PackData::AddColumn(table, "Cell", cell);
  PackData::AddColumn(table, "Cell_deviation", deviation);
  PackData::AddColumn(table, "Z", z);
  PackData::AddColumn(table, "Fitted", fitted);
  PackData::AddColumn(table, "Row", row);
  PackData::AddColumn(table, "Upper", most);
  PackData::AddColumn(table, "Lower", least);
}

void AddSummary(const ruc::ReportCard& card, const ruc::LagGrid& lags, vtkTable* table)
{
  const auto whole = [&](const char* name, long long number)
  { PackData::AddField(table, name, std::vector<long long>{ number }); };
  PackData::AddField(table, "Verdict", card.Verdict());
  whole("NumberOfDescriptors", static_cast<long long>(card.Rows.size()));
  whole("NumberWithin", card.Within());
  PackData::AddField(table, "LargestZ", std::vector<double>{ card.LargestZ() });
  PackData::AddField(table, "ObjectiveFloor", std::vector<double>{ card.Floor });
  whole("NumberOfPacks", card.Packs);
  whole("NumberOfCells", card.Cells);
  OutputSummary::AddLags(table, lags);
}

std::string TextOf(const std::vector<ruc::PackDescriptors>& packs)
{
  std::string text;
  for (const ruc::PackDescriptors& pack : packs)
  {
    for (const std::string& reason : pack.LeftOut)
    {
      text += text.find(reason) == std::string::npos ? (text.empty() ? "" : " ") + reason : "";
    }
  }
  return text;
}
}

vtkRUCCompareWithPack::vtkRUCCompareWithPack()
{
  this->SetNumberOfInputPorts(2);
}

int vtkRUCCompareWithPack::FillInputPortInformation(int port, vtkInformation* info)
{
  PackInput::Accept(info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1); // Execute says that it is required
  return 1;
}

int vtkRUCCompareWithPack::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

void vtkRUCCompareWithPack::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  ruc::Require(
    this->Blocks >= 8 && this->Blocks <= 1000, "Blocks", "a number from 8 to 1000", this->Blocks);
  const std::vector<vtkDataObject*> cellObjects = FindObjects(inputs[1], true);
  ruc::Require(!cellObjects.empty(), "Cell", "one or more cells to compare the pack with", "none");
  ProgressReport report(this, this->GetLabel());
  const std::vector<PackData::SharedPack> packs = FindPacks(FindObjects(inputs[0], false), ranks);
  const std::vector<PackData::SharedPack> cells = FindPacks(cellObjects, ranks);
  const int modes = packs.front().Share.NumberOfModes();
  double diameter = 0.0;
  for (const PackData::SharedPack& pack : packs)
  {
    ruc::Require(pack.Share.NumberOfModes() == modes, "Input",
      ruc::Text("packs with the same modes, ", modes), pack.Share.NumberOfModes());
    diameter += pack.Share.MeanDiameter() / static_cast<double>(packs.size());
  }
  for (const PackData::SharedPack& cell : cells)
  {
    ruc::Require(cell.Share.NumberOfModes() == modes, "Cell",
      ruc::Text("the modes of the input, ", modes), cell.Share.NumberOfModes());
  }
  const ruc::LagGrid lags = FindLags(this->MaximumLag, this->NumberOfLags, packs, cells);
  const ruc::DescriptorSettings settings = { lags, diameter, this->Blocks };
  const double steps = static_cast<double>(packs.size() + cells.size());
  std::vector<ruc::PackDescriptors> ofPacks, ofCells;
  const auto measure = [&](const std::vector<PackData::SharedPack>& list, bool areCells,
                         std::vector<ruc::PackDescriptors>& found)
  {
    for (const PackData::SharedPack& pack : list)
    {
      const double before = static_cast<double>(ofPacks.size() + ofCells.size());
      found.push_back(ruc::MeasureDescriptors(pack.Share, settings, areCells, ranks,
        [&](double done, const std::string& what)
        {
          if (ranks.Rank() == 0)
          {
            report.Tell(std::min((before + done) / steps, 1.0), what);
          }
        }));
    }
  };
  measure(packs, false, ofPacks);
  measure(cells, true, ofCells);
  const ruc::ReportCard card =
    ruc::MakeReportCard(ofPacks, ofCells, FindFitted(cellObjects, ranks));
  vtkTable* table = vtkTable::GetData(outputs);
  if (ranks.Rank() == 0)
  {
    FillReport(card, table);
  }
  AddSummary(card, lags, table);
  PackData::AddField(table, "LengthUnit", packs.front().LengthUnit);
  const std::string leftOut = TextOf(ofPacks) + TextOf(ofCells);
  if (!leftOut.empty())
  {
    PackData::AddField(table, "LeftOut", leftOut);
  }
}

void vtkRUCCompareWithPack::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "Blocks: " << this->Blocks << "\n";
}
