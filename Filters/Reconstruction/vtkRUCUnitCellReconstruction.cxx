// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCUnitCellReconstruction.h"

#include "CellSearch.h"
#include "ComparisonTables.h"
#include "PackData.h"
#include "PackEstimate.h"
#include "ProbabilityTable.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "vtkRUCStopRequest.h"
#include "ruc/Base/Text.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Reconstruction/Population/PopulationSettings.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/TwoPointChecks.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <numeric>
#include <stdexcept>
#include <system_error>

vtkStandardNewMacro(vtkRUCUnitCellReconstruction);

namespace
{
enum Ports
{
  CELL = 0,
  CONVERGENCE = 1,
  PROBABILITIES = 2,
  ALL_CELLS = 3,
  TABLE_OF_CELLS = 4,
  COMPARISON = 5
};

const char* const MethodNames[] = { "Gradient", "Annealed Population", "Hybrid" };

// Of a target: a table may be rounded, or sampled
constexpr double TargetTolerance = 0.005;

// Saturation length over mean diameter, for estimates; of dense packs 4 to 6
constexpr double TypicalSaturation = 5.0;

void FillConvergence(const ruc::UnitCell& cell, vtkTable* table)
{
  std::vector<long long> iteration;
  std::vector<double> objective, overlap;
  for (const ruc::SearchState& state : cell.Convergence)
  {
    iteration.push_back(state.Iteration);
    objective.push_back(state.Objective);
    overlap.push_back(state.OverlapPercent);
  }
  PackData::AddColumn(table, "Iteration", iteration);
  PackData::AddColumn(table, "Objective", objective);
  PackData::AddColumn(table, "OverlapPercent", overlap);
}

void FillProbabilities(const ruc::TwoPointProbability& pack, const ruc::TwoPointProbability& cell,
  const ruc::MeanProbability& cells, bool several, vtkTable* table)
{
  PackData::AddLags(table, pack.Lags);
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = r; s < pack.Phases(); ++s)
    {
      const std::string name = PackData::PairName(pack, r, s);
      PackData::AddColumn(table, name + "_pack", pack.S(r, s));
      PackData::AddColumn(table, name + "_cell", cell.S(r, s));
      if (several)
      {
        PackData::AddColumn(table, name + "_mean", cells.Mean.S(r, s));
        PackData::AddColumn(table, name + "_deviation", cells.Deviations[pack.PairOf(r, s)]);
      }
    }
  }
}

// As the paper's Table I
void FillTableOfCells(const std::vector<CellSearch::FoundCell>& cells,
  const ruc::TwoPointProbability& target, int seed, vtkTable* table)
{
  std::vector<long long> number, seeds, iterations;
  std::vector<double> columns[9];
  std::vector<std::string> endedBy;
  for (const CellSearch::FoundCell& found : cells)
  {
    number.push_back(found.Number + 1);
    seeds.push_back(static_cast<long long>(seed) + found.Number);
    iterations.push_back(found.Cell.Iterations);
    endedBy.push_back(ruc::NameOf(found.Cell.EndedBy));
    const double values[] = { found.Before.Minimum, found.Before.Mean, found.Before.Maximum,
      found.After.Minimum, found.After.Mean, found.After.Maximum, found.Cell.Overlap.Percent,
      found.Cell.Objective, ruc::CompareProbabilities(target, found.Cell.Probability).Percent };
    for (int n = 0; n < 9; ++n)
    {
      columns[n].push_back(values[n]);
    }
  }
  const char* const names[] = { "BeforeMinimum", "BeforeMean", "BeforeMaximum", "AfterMinimum",
    "AfterMean", "AfterMaximum", "OverlapPercent", "Objective", "DifferencePercent" };
  PackData::AddColumn(table, "Cell", number);
  PackData::AddColumn(table, "Seed", seeds);
  for (int n = 0; n < 9; ++n)
  {
    if (n == 6)
    {
      PackData::AddColumn(table, "Iterations", iterations);
    }
    PackData::AddColumn(table, names[n], columns[n]);
  }
  PackData::AddColumn(table, "EndedBy", endedBy);
}

double TwoDigits(double value)
{
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / digit) * digit;
}

// The place of the least F2, of cells without overlap if there are any
std::size_t FindBest(const std::vector<CellSearch::FoundCell>& cells)
{
  const auto better = [](const CellSearch::FoundCell& a, const CellSearch::FoundCell& b)
  {
    const bool freeA = a.Cell.Overlap.IsNone(), freeB = b.Cell.Overlap.IsNone();
    return freeA != freeB ? freeA : a.Cell.Objective < b.Cell.Objective;
  };
  return std::min_element(cells.begin(), cells.end(), better) - cells.begin();
}
}

vtkRUCUnitCellReconstruction::vtkRUCUnitCellReconstruction()
{
  this->SetNumberOfOutputPorts(6);
}

int vtkRUCUnitCellReconstruction::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

int vtkRUCUnitCellReconstruction::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == CELL          ? "vtkPolyData"
      : port == ALL_CELLS ? "vtkMultiBlockDataSet"
                          : "vtkTable");
  return 1;
}

void vtkRUCUnitCellReconstruction::ClearModeDiameters()
{
  this->ModeDiameters.clear();
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetModeDiameter(int i, double diameter)
{
  this->ModeDiameters.resize(std::max(this->ModeDiameters.size(), std::size_t(i) + 1), 0.0);
  this->ModeDiameters[i] = diameter;
  this->Modified();
}

void vtkRUCUnitCellReconstruction::ClearModeCounts()
{
  this->ModeCounts.clear();
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetModeCount(int i, int count)
{
  this->ModeCounts.resize(std::max(this->ModeCounts.size(), std::size_t(i) + 1), 0);
  this->ModeCounts[i] = count;
  this->Modified();
}

void vtkRUCUnitCellReconstruction::ClearOperatorWeights()
{
  this->OperatorWeights.clear();
  this->Modified();
}

void vtkRUCUnitCellReconstruction::SetOperatorWeight(int i, double weight)
{
  this->OperatorWeights.resize(std::max(this->OperatorWeights.size(), std::size_t(i) + 1), 0.0);
  this->OperatorWeights[i] = weight;
  this->Modified();
}

void vtkRUCUnitCellReconstruction::ValidateProperties() const
{
  const auto require = [](bool good, const char* name, const char* what, double got)
  {
    if (!good)
    {
      throw std::invalid_argument(ruc::Text(name, " requires ", what, ", got ", got, "."));
    }
  };
  require(this->Method >= GRADIENT && this->Method <= HYBRID, "Method", "a value from 0 to 2",
    this->Method);
  require(this->NumberOfCells >= 1, "NumberOfCells", "a number >= 1", this->NumberOfCells);
  require(this->CheckpointInterval >= 0.0, "CheckpointInterval", "a number of seconds >= 0",
    this->CheckpointInterval);
  require(
    this->NumberOfParticles >= 0, "NumberOfParticles", "a number >= 0", this->NumberOfParticles);
  require(this->CellSize >= 0.0 && std::isfinite(this->CellSize), "CellSize",
    "a finite number >= 0", this->CellSize);
  require(this->NumberOfParticles == 0 || this->CellSize == 0.0, "CellSize",
    "0 when NumberOfParticles is set", this->CellSize);
  require(this->ModeCounts.empty() || this->CellSize == 0.0, "CellSize",
    "0 when ModeCounts are set", this->CellSize);
  require(this->ModeCounts.empty() || this->NumberOfParticles == 0, "NumberOfParticles",
    "0 when ModeCounts are set", this->NumberOfParticles);
  require(this->SaturationTolerance > 0.0, "SaturationTolerance", "a number > 0",
    this->SaturationTolerance);
  require(
    this->MaximumIterations >= 0, "MaximumIterations", "a number >= 0", this->MaximumIterations);
  require(this->TargetObjective >= 0.0, "TargetObjective", "a number >= 0", this->TargetObjective);
  require(this->TimeLimit >= 0.0, "TimeLimit", "a number of seconds >= 0", this->TimeLimit);
  require(this->Seed >= 0, "Seed", "a number >= 0", this->Seed);
  if (this->Method == ANNEALED_POPULATION)
  {
    require(this->OperatorWeights.size() == ruc::NumberOfGeneticOperators, "OperatorWeights",
      "8 numbers", static_cast<double>(this->OperatorWeights.size()));
  }
  // ruc::CheckSettings knows these by other names, and takes no steps for an annealed population
  if (this->Method == HYBRID)
  {
    require(
      this->HybridPopulation >= 2, "HybridPopulation", "a number >= 2", this->HybridPopulation);
    require(this->HybridMatingPool >= 1 && this->HybridMatingPool <= this->HybridPopulation,
      "HybridMatingPool", "a number from 1 to HybridPopulation", this->HybridMatingPool);
    require(this->HybridMutationReach > 0.0 && this->HybridMutationReach <= 1.0,
      "HybridMutationReach", "a number > 0, <= 1", this->HybridMutationReach);
    require(this->RefinementSteps >= 1, "RefinementSteps", "a number >= 1", this->RefinementSteps);
  }
}

ruc::ModeAmounts vtkRUCUnitCellReconstruction::FindAmounts(const ruc::ModeAmounts& ofInput) const
{
  if (this->ModeDiameters.empty())
  {
    return ofInput;
  }
  std::vector<double> fractions;
  for (int mode = 0; mode < ofInput.NumberOfModes(); ++mode)
  {
    fractions.push_back(ofInput.Fraction(mode));
  }
  return ruc::ModeAmounts(fractions, this->ModeDiameters);
}

ruc::CellContents vtkRUCUnitCellReconstruction::FindContents(
  const ruc::ModeAmounts& amounts, const std::function<double()>& findEdge) const
{
  if (!this->ModeCounts.empty())
  {
    return ruc::FindCellContents(amounts, this->ModeCounts);
  }
  if (this->NumberOfParticles > 0)
  {
    return ruc::FindCellContents(amounts, this->NumberOfParticles);
  }
  return ruc::FindCellContents(amounts, this->CellSize > 0.0 ? this->CellSize : findEdge());
}

double vtkRUCUnitCellReconstruction::FindEdge(
  const ruc::TwoPointProbability& probability, double diameter, RankCommunicator& ranks)
{
  double length = ruc::SaturationLength(probability, this->SaturationTolerance, diameter);
  if (std::isnan(length))
  {
    length = probability.Lags.Maximum();
    if (ranks.Rank() == 0)
    {
      vtkWarningMacro(<< this->GetLabel() << ": S_rs does not saturate within "
                      << this->SaturationTolerance << " up to a lag of " << length
                      << "; the cell's edge is about twice that. Set CellSize for another.");
    }
  }
  return 2.0 * length;
}

CellSearch::Settings vtkRUCUnitCellReconstruction::GetSearchSettings() const
{
  CellSearch::Settings settings;
  settings.ByPopulation = this->Method != GRADIENT;
  settings.NumberOfCells = this->NumberOfCells;
  settings.CheckpointFile = this->CheckpointFile;
  settings.CheckpointInterval = this->CheckpointInterval;
  settings.Gradient.Seed = static_cast<std::uint32_t>(this->Seed);
  settings.Gradient.MaximumIterations = this->MaximumIterations;
  settings.Gradient.TargetObjective = this->TargetObjective;
  ruc::PopulationSettings& population = settings.Population;
  if (this->Method == HYBRID)
  {
    population = ruc::HybridSettings();
    population.Population = this->HybridPopulation;
    population.MatingPool = this->HybridMatingPool;
    population.MutationReach = this->HybridMutationReach;
    population.RefinementSteps = this->RefinementSteps;
  }
  else
  {
    population.Population = this->Population;
    population.MatingPool = this->MatingPool;
    population.SelectionPressure = this->SelectionPressure;
    population.MutationReach = this->MutationReach;
    std::copy(this->OperatorWeights.begin(), this->OperatorWeights.end(),
      population.OperatorWeights.begin());
  }
  population.Seed = static_cast<std::uint32_t>(this->Seed);
  population.TargetObjective = this->TargetObjective;
  population.RandomShare = this->RandomShare;
  population.DepositionDegree = this->DepositionDegree;
  population.MaximumGenerations = this->MaximumGenerations;
  population.PatienceGenerations = this->PatienceGenerations;
  population.HalfOverlap = this->HalfOverlap;
  population.MutatedShare = this->MutatedShare;
  population.MutationShape = this->MutationShape;
  population.MutationGenerations = this->MutationGenerations;
  population.MassSpringProbability = this->MassSpringProbability;
  population.InitialTemperature = this->InitialTemperature;
  population.CoolingFactor = this->CoolingFactor;
  population.ReheatingGenerations = this->ReheatingGenerations;
  if (settings.ByPopulation)
  {
    ruc::CheckSettings(population);
  }
  return settings;
}

ruc::CellFigures vtkRUCUnitCellReconstruction::FindCellFigures(
  ruc::LagGrid& lags, ruc::Estimate& input)
{
  ruc::CellFigures cell;
  double edge = this->CellSize;
  if (vtkTable* table = vtkTable::SafeDownCast(this->GetInputDataObject(0, 0)))
  {
    cell = PackEstimate::FindCellFigures(table, this->ModeDiameters, lags);
    edge = edge > 0.0 ? edge : 2.0 * lags.Maximum();
  }
  else
  {
    const ruc::PackFigures pack = this->FindFigures();
    cell = { 0.0, pack.Density(), pack.LargestRadius, pack.Modes };
    input = ruc::EstimatePack(pack);
    if (this->NumberOfParticles == 0 && this->ModeCounts.empty() && edge == 0.0)
    {
      const ruc::LagLimit limit = ruc::LagLimit::ForPairSum(pack.Observed, pack.LargestRadius);
      input += ruc::EstimatePairSum(pack, limit.MakeGrid(0.0, this->NumberOfLags));
      edge = 2.0 * std::min(limit.Automatic, TypicalSaturation * pack.MeanDiameter);
    }
  }
  cell.Spheres = !this->ModeCounts.empty()
    ? std::accumulate(this->ModeCounts.begin(), this->ModeCounts.end(), 0.0)
    : this->NumberOfParticles > 0 ? this->NumberOfParticles
                                  : cell.Density * edge * edge * edge;
  return cell;
}

ruc::Estimate vtkRUCUnitCellReconstruction::MakeEstimate()
{
  this->ValidateProperties();
  const CellSearch::Settings settings = this->GetSearchSettings();
  ruc::LagGrid lags = { 0.0, 0 };
  ruc::Estimate estimate;
  const ruc::CellFigures cell = this->FindCellFigures(lags, estimate);
  const double edge = std::cbrt(cell.Spheres / cell.Density);
  if (this->NumberOfParticles == 0 && this->ModeCounts.empty())
  {
    estimate.Automatic = ruc::Text("Number Of Particles ", TwoDigits(cell.Spheres));
    estimate.Automatic +=
      this->CellSize > 0.0 ? std::string() : ruc::Text(", Cell Size ", TwoDigits(edge));
  }
  if (lags.Count == 0)
  {
    lags = ruc::LagLimit::ForCell(edge).MakeGrid(this->MaximumLag, this->NumberOfLags);
    if (this->MaximumLag == 0.0)
    {
      estimate.Automatic += ruc::Text(
        estimate.Automatic.empty() ? "" : ", ", "Maximum Lag ", TwoDigits(lags.Maximum()));
    }
    estimate += ruc::EstimatePairSum(this->FindFigures(), lags);
  }
  ruc::Estimate search = settings.ByPopulation
    ? ruc::EstimatePopulationSearch(cell, lags, settings.Population)
    : ruc::EstimateGradientSearch(cell, lags, this->MaximumIterations);
  search.Seconds *= this->NumberOfCells;
  if (this->TimeLimit > 0.0)
  {
    const RankCommunicator ranks(this->GetController());
    search.Seconds = std::min(search.Seconds, this->TimeLimit * PackEstimate::Cores(ranks.Size()));
  }
  estimate += search;
  return estimate;
}

ruc::EndReason vtkRUCUnitCellReconstruction::FindStopReason(const ProgressReport& report)
{
  if (this->GetAbortExecute())
  {
    return ruc::EndReason::Abort;
  }
  if (vtkRUCStopRequest::IsPending())
  {
    return ruc::EndReason::StopButton;
  }
  if (this->TimeLimit > 0.0 && report.Seconds() >= this->TimeLimit)
  {
    return ruc::EndReason::TimeLimit;
  }
  std::error_code ignored;
  if (!this->StopFile.empty() && std::filesystem::is_regular_file(this->StopFile, ignored))
  {
    return ruc::EndReason::StopFile;
  }
  return ruc::EndReason::None;
}

void vtkRUCUnitCellReconstruction::Execute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  vtkTable* table = vtkTable::GetData(inputs[0]);
  if (!table)
  {
    this->Superclass::Execute(inputs, outputs, ranks);
    return;
  }
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const ruc::TwoPointProbability target = ProbabilityTable::Read(table, "Input", ranks);
  ruc::RequireProbabilities(target, TargetTolerance);
  const ruc::ModeAmounts amounts(
    { target.Fractions.begin(), target.Fractions.end() - 1 }, this->ModeDiameters);
  const ruc::CellContents contents = this->FindContents(
    amounts, [&]() { return this->FindEdge(target, amounts.MeanDiameter(), ranks); });
  this->Reconstruct(
    contents, target, PackData::FindLengthUnit(table, ranks), outputs, ranks, report);
}

void vtkRUCUnitCellReconstruction::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack =
    PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  const auto findEdge = [&]()
  {
    const ruc::LagGrid lags =
      ruc::LagLimit::ForPairSum(pack.Share.Observed, pack.Share.LargestRadius)
        .MakeGrid(0.0, this->NumberOfLags);
    return this->FindEdge(ruc::SumPairs(pack.Share, lags, ranks, report.ForPairs(ranks)),
      pack.Share.MeanDiameter(), ranks);
  };
  const ruc::CellContents contents = this->FindContents(this->FindAmounts(pack.Share), findEdge);
  const ruc::LagGrid lags =
    ruc::LagLimit::ForCell(contents.Edge).MakeGrid(this->MaximumLag, this->NumberOfLags);
  const ruc::TwoPointProbability target =
    ruc::SumPairs(pack.Share, lags, ranks, report.ForPairs(ranks));
  this->Reconstruct(contents, target, pack.LengthUnit, outputs, ranks, report);
}

void vtkRUCUnitCellReconstruction::Reconstruct(const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target, const std::string& lengthUnit,
  vtkInformationVector* outputs, RankCommunicator& ranks, ProgressReport& report)
{
  const CellSearch::Settings settings = this->GetSearchSettings();
  const double most =
    this->Method == GRADIENT ? this->MaximumIterations + 3.0 : this->MaximumGenerations + 1.0;
  CellSearch::Callbacks callbacks;
  callbacks.StopReason = [&](int cell, const ruc::SearchState& state)
  {
    if (ranks.Rank() == 0)
    {
      RunProgress progress;
      progress.Activity =
        ruc::Text(this->NumberOfCells > 1 ? ruc::Text("cell ", cell + 1, ", ") : std::string(),
          ruc::NameOf(state.Phase), ", ", this->Method == GRADIENT ? "iteration " : "generation ",
          state.Iteration, ", overlap ", std::setprecision(2), state.OverlapPercent, " %");
      progress.Stoppable = true;
      progress.Quantity = "F2";
      progress.Value = state.Objective;
      report.Tell((cell + state.Iteration / most) / this->NumberOfCells, progress);
    }
    return this->FindStopReason(report);
  };
  callbacks.Warn = [&](const std::string& text)
  { vtkWarningMacro(<< this->GetLabel() << ": " << text); };
  const std::vector<CellSearch::FoundCell> cells =
    CellSearch::Find(contents, target, settings, callbacks, ranks);
  const std::size_t best = FindBest(cells);
  this->FillOutputs(cells, best, contents, target, lengthUnit, outputs, ranks);

  for (const CellSearch::FoundCell& found : cells)
  {
    const ruc::PackOverlap& overlap = found.Cell.Overlap;
    if (ranks.Rank() == 0 && !overlap.IsNone())
    {
      vtkWarningMacro(<< this->GetLabel() << ": cell " << found.Number + 1 << " still has overlap, "
                      << overlap.Percent << " % of the spheres' volume in " << overlap.Pairs
                      << " pairs"
                      << (ruc::IsFromOutside(found.Cell.EndedBy) ? "; it was stopped early."
                                                                 : "; it is too dense to free."));
    }
  }
  if (ranks.Rank() == 0 && cells.size() < static_cast<std::size_t>(this->NumberOfCells))
  {
    vtkWarningMacro(<< this->GetLabel() << ": stopped before " << this->NumberOfCells - cells.size()
                    << " of " << this->NumberOfCells << " cells were begun.");
  }
}

void vtkRUCUnitCellReconstruction::FillOutputs(const std::vector<CellSearch::FoundCell>& cells,
  std::size_t best, const ruc::CellContents& contents, const ruc::TwoPointProbability& target,
  const std::string& lengthUnit, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  std::vector<ruc::TwoPointProbability> probabilities;
  vtkMultiBlockDataSet* all = vtkMultiBlockDataSet::GetData(outputs, ALL_CELLS);
  for (const CellSearch::FoundCell& found : cells)
  {
    probabilities.push_back(found.Cell.Probability);
    const unsigned int block = all->GetNumberOfBlocks();
    all->SetNumberOfBlocks(block + 1);
    if (ranks.Rank() == 0)
    {
      vtkNew<vtkPolyData> data;
      PackData::FillPolyData(found.Cell.Pack, data);
      this->AddCellFields(data, found, contents, target, lengthUnit);
      all->SetBlock(block, data);
    }
    all->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), ruc::Text("Cell ", found.Number + 1).c_str());
  }
  const ruc::MeanProbability mean = ruc::AverageProbabilities(probabilities);
  const bool several = cells.size() > 1;
  if (ranks.Rank() == 0)
  {
    const ruc::UnitCell& cell = cells[best].Cell;
    PackData::FillPolyData(cell.Pack, vtkPolyData::GetData(outputs, CELL));
    FillConvergence(cell, vtkTable::GetData(outputs, CONVERGENCE));
    FillProbabilities(
      target, cell.Probability, mean, several, vtkTable::GetData(outputs, PROBABILITIES));
    FillTableOfCells(cells, target, this->Seed, vtkTable::GetData(outputs, TABLE_OF_CELLS));
    ComparisonTables::FillComparison(target, mean, several, vtkTable::GetData(outputs, COMPARISON));
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->AddCellFields(outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT()),
      cells[best], contents, target, lengthUnit);
  }
  PackData::AddField(vtkTable::GetData(outputs, COMPARISON), "DifferencePercent",
    std::vector<double>{ ruc::CompareProbabilities(target, mean.Mean).Percent });
}

void vtkRUCUnitCellReconstruction::AddCellFields(vtkDataObject* data,
  const CellSearch::FoundCell& found, const ruc::CellContents& contents,
  const ruc::TwoPointProbability& target, const std::string& lengthUnit) const
{
  const ruc::UnitCell& cell = found.Cell;
  PackData::AddPackSummary(data, { cell.Box, "Unit cell", lengthUnit }, cell.Pack.Size(),
    cell.Probability.Fractions, cell.Overlap.Percent);
  PackData::AddField(data, "Method", std::string(MethodNames[this->Method]));
  PackData::AddField(
    data, "Seed", std::vector<long long>{ static_cast<long long>(this->Seed) + found.Number });
  PackData::AddField(data, "Cell", std::vector<long long>{ found.Number + 1 });
  PackData::AddField(data, "NumberOfLags", std::vector<long long>{ target.Lags.Count });
  PackData::AddField(data, "MaximumLag", std::vector<double>{ target.Lags.Maximum() });
  PackData::AddField(data, "Objective", std::vector<double>{ cell.Objective });
  PackData::AddField(data, "StartObjective", std::vector<double>{ cell.StartObjective });
  PackData::AddField(data, "OnePointDifference",
    std::vector<double>{ ruc::OnePointDifference(contents, target.Fractions, contents.Edge) });
  PackData::AddField(data, "Iterations", std::vector<long long>{ cell.Iterations });
  PackData::AddField(data, "EndedBy", std::string(ruc::NameOf(cell.EndedBy)));
  PackData::AddField(data, "Stopped", std::vector<long long>{ ruc::IsFromOutside(cell.EndedBy) });
}

void vtkRUCUnitCellReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "NumberOfCells: " << this->NumberOfCells << "\n";
  os << indent << "NumberOfParticles: " << this->NumberOfParticles << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "MaximumLag: " << this->MaximumLag << "\n";
  os << indent << "NumberOfLags: " << this->NumberOfLags << "\n";
  os << indent << "SaturationTolerance: " << this->SaturationTolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "TargetObjective: " << this->TargetObjective << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "StopFile: " << this->StopFile << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "CheckpointFile: " << this->CheckpointFile << "\n";
  os << indent << "CheckpointInterval: " << this->CheckpointInterval << "\n";
  os << indent << "Population: " << this->Population << "\n";
  os << indent << "RandomShare: " << this->RandomShare << "\n";
  os << indent << "DepositionDegree: " << this->DepositionDegree << "\n";
  os << indent << "MatingPool: " << this->MatingPool << "\n";
  os << indent << "MaximumGenerations: " << this->MaximumGenerations << "\n";
  os << indent << "PatienceGenerations: " << this->PatienceGenerations << "\n";
  os << indent << "SelectionPressure: " << this->SelectionPressure << "\n";
  os << indent << "HalfOverlap: " << this->HalfOverlap << "\n";
  os << indent << "MutatedShare: " << this->MutatedShare << "\n";
  os << indent << "MutationShape: " << this->MutationShape << "\n";
  os << indent << "MutationReach: " << this->MutationReach << "\n";
  os << indent << "MutationGenerations: " << this->MutationGenerations << "\n";
  os << indent << "MassSpringProbability: " << this->MassSpringProbability << "\n";
  os << indent << "InitialTemperature: " << this->InitialTemperature << "\n";
  os << indent << "CoolingFactor: " << this->CoolingFactor << "\n";
  os << indent << "ReheatingGenerations: " << this->ReheatingGenerations << "\n";
  os << indent << "HybridPopulation: " << this->HybridPopulation << "\n";
  os << indent << "HybridMatingPool: " << this->HybridMatingPool << "\n";
  os << indent << "HybridMutationReach: " << this->HybridMutationReach << "\n";
  os << indent << "RefinementSteps: " << this->RefinementSteps << "\n";
  const auto print = [&](const char* name, const auto& values)
  {
    os << indent << name << ":";
    for (const auto& value : values)
    {
      os << " " << value;
    }
    os << "\n";
  };
  print("ModeDiameters", this->ModeDiameters);
  print("ModeCounts", this->ModeCounts);
  print("OperatorWeights", this->OperatorWeights);
}
