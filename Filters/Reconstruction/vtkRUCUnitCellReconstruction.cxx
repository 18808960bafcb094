// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCUnitCellReconstruction.h"

#include "CellEstimate.h"
#include "CellMessages.h"
#include "CellTables.h"
#include "PackData.h"
#include "PackEstimate.h"
#include "ProbabilityTable.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "vtkRUCStopRequest.h"
#include "ruc/Base/Require.h"
#include "ruc/Particles/ParticleModes.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/PairSums/PairSumErrors.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/TwoPointChecks.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <sys/stat.h>

vtkStandardNewMacro(vtkRUCUnitCellReconstruction);

namespace
{
// How far a target's probabilities may be off, as a table may be rounded, or sampled
constexpr double TargetTolerance = 0.005;

// Sets a value of a list that has one for each mode; returns false if there can be no such mode
template <class Value>
bool SetOfMode(std::vector<Value>& list, int mode, Value value)
{
  if (mode < 0 || mode >= ruc::MostModes)
  {
    return false;
  }
  list.resize(std::max(list.size(), std::size_t(mode) + 1));
  list[mode] = value;
  return true;
}
}

vtkRUCUnitCellReconstruction::vtkRUCUnitCellReconstruction()
{
  this->SetNumberOfOutputPorts(CellTables::NUMBER_OF_PORTS);
  this->Search.Gradient.Neighbours.ContactWeight = 1.0;
  this->Search.Gradient.Neighbours.PoreWeight = 1.0;
}

int vtkRUCUnitCellReconstruction::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == CellTables::CELL          ? "vtkPolyData"
      : port == CellTables::ALL_CELLS ? "vtkMultiBlockDataSet"
                                      : "vtkTable");
  return 1;
}

void vtkRUCUnitCellReconstruction::ClearModeDiameters()
{
  this->Cell.ModeDiameters.clear();
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetModeDiameter(int i, double diameter)
{
  if (!SetOfMode(this->Cell.ModeDiameters, i, diameter))
  {
    vtkErrorMacro(<< "ModeDiameters has places 0 to " << ruc::MostModes - 1 << ", got " << i);
  }
  this->Modified();
}

void vtkRUCUnitCellReconstruction::ClearModeCounts()
{
  this->Cell.ModeCounts.clear();
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetModeCount(int i, int count)
{
  if (!SetOfMode(this->Cell.ModeCounts, i, count))
  {
    vtkErrorMacro(<< "ModeCounts has places 0 to " << ruc::MostModes - 1 << ", got " << i);
  }
  this->Modified();
}

void vtkRUCUnitCellReconstruction::ClearThirdOrderDistances()
{
  this->Search.Gradient.ThirdOrder.Distances.clear();
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetThirdOrderDistance(int i, double distance)
{
  if (!SetOfMode(this->Search.Gradient.ThirdOrder.Distances, i, distance))
  {
    vtkErrorMacro(<< "ThirdOrderDistances has places 0 to " << ruc::MostModes - 1 << ", got " << i);
  }
  this->Modified();
}

void vtkRUCUnitCellReconstruction::ClearOperatorWeights()
{
  this->NumberOfOperatorWeights = 0;
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetOperatorWeight(int i, double weight)
{
  auto& weights = this->Search.Annealed.OperatorWeights;
  if (i >= 0 && i < static_cast<int>(weights.size()))
  {
    weights[i] = weight;
  }
  // CheckProperties refuses any other place
  this->NumberOfOperatorWeights = i < 0 ? -1 : std::max(this->NumberOfOperatorWeights, i + 1);
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetCheckpointFile(const char* name)
{
  this->Search.CheckpointFile = name ? name : "";
  this->Modified();
}

void vtkRUCUnitCellReconstruction::CheckProperties() const
{
  ruc::Range::AtLeast(0).Check("TimeLimit", this->TimeLimit);
  ruc::Range::AtLeast(0).Check("Seed", this->GetSeed());
  this->Cell.Check();
  ruc::Require(this->Search.Method == GRADIENT || this->Cell.Gap.IsNone(),
    "MinimumGap and MinimumGapShare", "0 where Method is not Gradient",
    std::max(this->GetMinimumGap(), this->GetMinimumGapShare()));
  if (this->Search.Method == ANNEALED_POPULATION)
  {
    ruc::Require(this->NumberOfOperatorWeights == ruc::NumberOfGeneticOperators, "OperatorWeights",
      "8 numbers", this->NumberOfOperatorWeights);
  }
  this->Search.Check();
}

double vtkRUCUnitCellReconstruction::FindEdge(
  const ruc::TwoPointProbability& probability, double diameter, RankCommunicator& ranks)
{
  double length = ruc::SaturationLength(probability, this->Cell.SaturationTolerance, diameter);
  if (std::isnan(length))
  {
    length = probability.Lags.Maximum();
    if (ranks.Rank() == 0)
    {
      vtkWarningMacro(<< "S_rs does not saturate within " << this->Cell.SaturationTolerance
                      << " up to a lag of " << length
                      << "; the cell's edge is about twice that. Set CellSize for another.");
    }
  }
  return 2.0 * length;
}

std::optional<ruc::Estimate> vtkRUCUnitCellReconstruction::MakeEstimate()
{
  this->CheckProperties();
  const RankCommunicator ranks(this->GetController());
  const double longest = this->TimeLimit > 0.0 ? this->TimeLimit * PackEstimate::Cores(ranks.Size())
                                               : std::numeric_limits<double>::infinity();
  vtkTable* table = vtkTable::SafeDownCast(this->GetInputDataObject(0, 0));
  if (table)
  {
    return CellEstimate::OfTable(table, this->Cell, this->Search, longest);
  }
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  return pack ? std::optional(CellEstimate::OfPack(*pack, this->Cell, this->Search, longest))
              : std::nullopt;
}

ruc::EndReason vtkRUCUnitCellReconstruction::FindStopReason(
  const ProgressReport& report, bool isFirstRank)
{
  if (this->TimeLimit > 0.0 && report.Seconds() >= this->TimeLimit)
  {
    return ruc::EndReason::TimeLimit;
  }
  if (!isFirstRank)
  {
    return ruc::EndReason::None;
  }
  if (this->GetAbortExecute())
  {
    return ruc::EndReason::Abort;
  }
  if (vtkRUCStopRequest::IsPending())
  {
    return ruc::EndReason::StopButton;
  }
  struct stat file;
  if (!this->StopFile.empty() && stat(this->StopFile.c_str(), &file) == 0 && S_ISREG(file.st_mode))
  {
    return ruc::EndReason::StopFile;
  }
  return ruc::EndReason::None;
}

void vtkRUCUnitCellReconstruction::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  RequireOne(inputs[0], "Input", "pack or table");
  vtkTable* table = vtkTable::GetData(inputs[0]);
  if (!table)
  {
    this->Superclass::Execute(inputs, outputs, ranks);
    return;
  }
  this->CheckProperties();
  this->CheckMemory(ranks);
  ProgressReport report(this, this->GetLabel());
  const ruc::TwoPointProbability target = ProbabilityTable::Read(table, "Input", ranks);
  ruc::RequireProbabilities(target, TargetTolerance);
  const ruc::ModeAmounts amounts(
    { target.Fractions.begin(), target.Fractions.end() - 1 }, this->Cell.ModeDiameters);
  const ruc::CellContents contents = this->Cell.FindContents(
    amounts, [&]() { return this->FindEdge(target, amounts.MeanDiameter(), ranks); });
  const ruc::NeighbourTarget& neighbours = this->Search.Gradient.Neighbours;
  if (this->Search.Method == GRADIENT && ranks.Rank() == 0 && neighbours.IsWanted())
  {
    vtkWarningMacro(
      << "ContactWeight, PoreWeight, SpectrumWeight and ThirdOrderWeight do not count, as a table "
         "of S_rs tells neither near neighbours nor pores nor third order: they require a pack.");
  }
  if (this->Cell.DiametersPerMode != 1 && ranks.Rank() == 0)
  {
    vtkWarningMacro(<< "DiametersPerMode does not count, as a table of S_rs tells no diameters "
                       "within a mode: it requires a pack.");
  }
  ruc::Require(!this->StopAtPackError, "StopAtPackError",
    "a pack, as a table of S_rs tells no errors", "a table");
  this->Reconstruct(contents, target, this->Search, std::numeric_limits<double>::quiet_NaN(),
    PackData::FindLengthUnit(table, ranks), outputs, ranks, report);
}

void vtkRUCUnitCellReconstruction::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->CheckProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack = this->FindShare(input, ranks);
  this->CheckOverlap(pack.Share, true, ranks);
  const auto findEdge = [&]()
  {
    const ruc::LagGrid lags =
      ruc::LagLimit::ForPairSum(pack.Share.Observed, pack.Share.LargestRadius)
        .MakeGrid(0.0, this->Cell.NumberOfLags);
    return this->FindEdge(ruc::SumPairs(pack.Share, lags, ranks, report.ForSums(ranks)),
      pack.Share.MeanDiameter(), ranks);
  };
  ruc::CellContents contents =
    this->Cell.FindContents(this->Cell.FindAmounts(pack.Share), findEdge);
  if (this->Cell.DiametersPerMode != 1)
  {
    contents = ruc::DivideModes(contents, this->Cell.DiametersPerMode, pack.Share, ranks);
  }
  const ruc::LagGrid lags =
    ruc::LagLimit::ForCell(contents.Edge).MakeGrid(this->Cell.MaximumLag, this->Cell.NumberOfLags);
  const ruc::TwoPointProbability target =
    ruc::SumPairs(pack.Share, lags, ranks, report.ForSums(ranks));
  CellSearch::Settings search = this->FindSearch(pack.Share, ranks);
  const double floor = this->FindFloor(pack.Share, target, ranks);
  if (this->StopAtPackError)
  {
    double& end = search.Gradient.TargetObjective;
    end = std::max(end, floor);
  }
  this->Reconstruct(contents, target, search, floor, pack.LengthUnit, outputs, ranks, report);
}

double vtkRUCUnitCellReconstruction::FindFloor(const ruc::PackShare& share,
  const ruc::TwoPointProbability& target, RankCommunicator& ranks) const
{
  constexpr int blocks = 64;
  try
  {
    return ruc::ObjectiveFloor(
      target, ruc::FindPairSumErrors(share, target, blocks, ranks, "StopAtPackError"));
  }
  catch (const std::invalid_argument&)
  {
    if (this->StopAtPackError)
    {
      throw;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
}

CellSearch::Settings vtkRUCUnitCellReconstruction::FindSearch(
  const ruc::PackShare& share, RankCommunicator& ranks)
{
  CellSearch::Settings search = this->Search;
  ruc::NeighbourTarget& neighbours = search.Gradient.Neighbours;
  if (search.Method != GRADIENT || !neighbours.IsWanted())
  {
    return search;
  }
  if (neighbours.SpectrumWeight > 0.0)
  {
    neighbours.Spectrum = ruc::MeasureSpectrum(share, "SpectrumWeight", ranks);
  }
  if (neighbours.ThirdOrderWeight > 0.0)
  {
    neighbours.ThirdOrder = ruc::MeasureNeighbourhoods(share, search.Gradient.ThirdOrder, ranks);
  }
  if (neighbours.ContactWeight + neighbours.PoreWeight == 0.0)
  {
    return search;
  }
  neighbours.Pack = ruc::MeasureNeighbourSums(share, ranks);
  const std::string warning = CellMessages::FindNeighbourWarning(neighbours);
  if (ranks.Rank() == 0 && !warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  return search;
}

void vtkRUCUnitCellReconstruction::Reconstruct(const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target, const CellSearch::Settings& search, double floor,
  const std::string& lengthUnit, vtkInformationVector* outputs, RankCommunicator& ranks,
  ProgressReport& report)
{
  ruc::LagLimit::ForCell(contents.Edge).Check(target.Lags);
  this->RequireMemory(CellEstimate::MegabytesOf(contents, target.Lags, search), ranks);
  const ruc::StageLengths lengths(
    search.Gradient.MaximumIterations, !search.Gradient.Neighbours.Empty());
  const double most =
    search.IsByPopulation() ? search.Annealed.MaximumGenerations + 1.0 : lengths.All() + 3.0;
  CellSearch::Callbacks callbacks;
  callbacks.StopReason = [&](int cell, const ruc::SearchState& state)
  {
    if (ranks.Rank() == 0)
    {
      report.Tell((cell + state.Iteration / most) / search.NumberOfCells,
        CellMessages::DescribeProgress(cell, state, search));
    }
    return this->FindStopReason(report, ranks.Rank() == 0);
  };
  callbacks.Warn = [&](const std::string& text) { vtkWarningMacro(<< text); };
  const std::vector<CellSearch::FoundCell> cells =
    CellSearch::Find(contents, target, search, callbacks, ranks);
  CellTables::FillOutputs(
    { cells, contents, target, search, floor, lengthUnit }, outputs, ranks.Rank() == 0);
  if (ranks.Rank() == 0)
  {
    for (const std::string& warning : CellMessages::FindWarnings(cells, contents, search))
    {
      vtkWarningMacro(<< warning);
    }
  }
}

void vtkRUCUnitCellReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& value, const auto&...)
  { os << indent << name << ": " << value << "\n"; };
  const auto printList = [&](const char* name, const auto& values)
  {
    os << indent << name << ":";
    for (const auto& value : values)
    {
      os << " " << value;
    }
    os << "\n";
  };
  CellProperties::VisitSearch(this->Cell, print);
  print("MaximumLag", this->Cell.MaximumLag);
  print("NumberOfLags", this->Cell.NumberOfLags);
  printList("ModeDiameters", this->Cell.ModeDiameters);
  printList("ModeCounts", this->Cell.ModeCounts);
  CellSearch::Settings::VisitSearch(this->Search, print);
  print("CheckpointFile", this->Search.CheckpointFile);
  print("TimeLimit", this->TimeLimit);
  print("StopAtPackError", this->StopAtPackError);
  print("StopFile", this->StopFile);
  ruc::GradientSearchSettings::VisitSearch(this->Search.Gradient, print);
  ruc::GradientSearchSettings::VisitEnd(this->Search.Gradient, print);
  print("ThirdOrderClasses", this->Search.Gradient.ThirdOrder.Classes);
  print("ThirdOrderDegree", this->Search.Gradient.ThirdOrder.Degree);
  printList("ThirdOrderDistances", this->Search.Gradient.ThirdOrder.Distances);
  ruc::PopulationSettings annealed = this->Search.Annealed;
  // The seed and the target are the same for every method
  static_cast<ruc::SearchSettings&>(annealed) = this->Search.Gradient;
  ruc::PopulationSettings::VisitSearch(annealed, print);
  ruc::PopulationSettings::VisitEnd(annealed, print);
  ruc::HybridSettings::VisitSearch(this->Search.Hybrid, print);
}
