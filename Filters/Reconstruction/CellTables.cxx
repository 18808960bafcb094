// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTables.h"

#include "ComparisonTables.h"
#include "PackData.h"
#include "ruc/Base/Text.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
const char* const MethodNames[] = { "Gradient", "Annealed Population", "Hybrid" };

long long SeedOf(const CellSearch::FoundCell& found, const CellSearch::Settings& settings)
{
  return static_cast<long long>(settings.Gradient.Seed) + found.Number;
}

void FillConvergence(
  const ruc::UnitCell& cell, const ruc::NeighbourTarget& neighbours, vtkTable* table)
{
  std::vector<long long> iteration;
  std::vector<double> objective, overlap, multipliers, gaps, nearest, pores, spectrum, third;
  for (const ruc::SearchState& state : cell.Convergence)
  {
    iteration.push_back(state.Iteration);
    objective.push_back(state.Objective);
    overlap.push_back(state.OverlapPercent);
    multipliers.push_back(state.SumOfMultipliers);
    const ruc::NeighbourMisfits& misfits = state.Misfits;
    const double unknown = misfits.Largest() > 0.0 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    gaps.push_back(misfits.Gaps + unknown);
    nearest.push_back(misfits.Nearest + unknown);
    pores.push_back(misfits.Pores + unknown);
    spectrum.push_back(misfits.Spectrum + unknown);
    third.push_back(misfits.ThirdOrder + unknown);
  }
  PackData::AddColumn(table, "Iteration", iteration);
  PackData::AddColumn(table, "Objective", objective);
  PackData::AddColumn(table, "OverlapPercent", overlap);
  if (std::any_of(multipliers.begin(), multipliers.end(), [](double sum) { return sum > 0.0; }))
  {
    PackData::AddColumn(table, "SumOfMultipliers", multipliers);
  }
  if (neighbours.HasContacts() || neighbours.HasPores())
  {
    PackData::AddColumn(table, "GapMisfit", gaps);
    PackData::AddColumn(table, "NearestMisfit", nearest);
    PackData::AddColumn(table, "PoreMisfit", pores);
  }
  if (neighbours.HasSpectrum())
  {
    PackData::AddColumn(table, "SpectrumMisfit", spectrum);
  }
  if (neighbours.HasThirdOrder())
  {
    PackData::AddColumn(table, "ThirdOrderMisfit", third);
  }
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

// Fills the table of cells, which is like Table I of the paper
void FillTableOfCells(const CellTables::Reconstruction& all, vtkTable* table)
{
  std::vector<long long> number, seeds, iterations;
  std::vector<double> columns[9];
  std::vector<std::string> endedBy;
  for (const CellSearch::FoundCell& found : all.Cells)
  {
    number.push_back(found.Number + 1);
    seeds.push_back(SeedOf(found, all.Settings));
    iterations.push_back(found.Cell.Iterations);
    endedBy.push_back(ruc::NameOf(found.Cell.EndedBy));
    const double values[] = { found.Before.Minimum, found.Before.Mean, found.Before.Maximum,
      found.After.Minimum, found.After.Mean, found.After.Maximum, found.Cell.Overlap.Percent,
      found.Cell.Objective, ruc::CompareProbabilities(all.Target, found.Cell.Probability).Percent };
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

// The first iteration at which F2 is at the floor and every other term that counts within the
// pack's error; -1 where there is none
int FindPackErrorIteration(const ruc::UnitCell& cell, const CellTables::Reconstruction& all)
{
  const bool withTerms =
    !all.Settings.IsByPopulation() && !all.Settings.Gradient.Neighbours.Empty();
  for (const ruc::SearchState& state : cell.Convergence)
  {
    const bool hasTerms = !withTerms || state.Phase == ruc::SearchPhase::FittingNeighbours;
    if (hasTerms && state.Objective <= all.Floor && state.Misfits.Largest() <= 1.0)
    {
      return state.Iteration;
    }
  }
  return -1;
}

void AddCellFields(
  vtkDataObject* data, const CellSearch::FoundCell& found, const CellTables::Reconstruction& all)
{
  const ruc::UnitCell& cell = found.Cell;
  const auto whole = [&](const char* name, long long value)
  { PackData::AddField(data, name, std::vector<long long>{ value }); };
  const auto number = [&](const char* name, double value)
  { PackData::AddField(data, name, std::vector<double>{ value }); };
  PackData::AddPackSummary(data, { cell.Box, "Unit cell", all.LengthUnit, {} }, cell.Pack.Size(),
    cell.Probability.Fractions, cell.Overlap.Percent);
  PackData::AddField(data, "Method", std::string(MethodNames[all.Settings.Method]));
  whole("Seed", SeedOf(found, all.Settings));
  whole("Cell", found.Number + 1);
  whole("NumberOfLags", all.Target.Lags.Count);
  number("MaximumLag", all.Target.Lags.Maximum());
  number("Objective", cell.Objective);
  number("StartObjective", cell.StartObjective);
  number("OnePointDifference",
    ruc::OnePointDifference(all.Contents, all.Target.Fractions, cell.Box.Size[0]));
  if (!std::isnan(all.Floor))
  {
    number("ObjectiveFloor", all.Floor);
    whole("PackErrorIteration", FindPackErrorIteration(cell, all));
  }
  const ruc::NeighbourTarget& neighbours = all.Settings.Gradient.Neighbours;
  const ruc::NeighbourMisfits& misfits = cell.Convergence.back().Misfits;
  if (neighbours.HasContacts() || neighbours.HasPores())
  {
    number("GapMisfit", misfits.Gaps);
    number("NearestMisfit", misfits.Nearest);
    number("PoreMisfit", misfits.Pores);
  }
  if (neighbours.HasSpectrum())
  {
    number("SpectrumMisfit", misfits.Spectrum);
    number("Zeta", cell.Zeta);
    number("ZetaOfPack", neighbours.Spectrum.Zeta);
    number("ZetaOfPack_error", neighbours.Spectrum.ZetaError);
  }
  if (neighbours.HasThirdOrder())
  {
    number("ThirdOrderMisfit", misfits.ThirdOrder);
  }
  whole("Iterations", cell.Iterations);
  PackData::AddField(data, "EndedBy", std::string(ruc::NameOf(cell.EndedBy)));
  whole("Stopped", ruc::IsFromOutside(cell.EndedBy));
  whole("Stops", found.Stops);
}

void FillAllCells(
  const CellTables::Reconstruction& all, vtkMultiBlockDataSet* blocks, bool isFirstRank)
{
  for (const CellSearch::FoundCell& found : all.Cells)
  {
    const unsigned int block = blocks->GetNumberOfBlocks();
    blocks->SetNumberOfBlocks(block + 1);
    if (isFirstRank)
    {
      vtkNew<vtkPolyData> data;
      PackData::FillPolyData(found.Cell.Pack, data);
      AddCellFields(data, found, all);
      blocks->SetBlock(block, data);
    }
    blocks->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), ruc::Text("Cell ", found.Number + 1).c_str());
  }
}

ruc::MeanProbability MeanOf(const std::vector<CellSearch::FoundCell>& cells)
{
  std::vector<ruc::TwoPointProbability> probabilities;
  for (const CellSearch::FoundCell& found : cells)
  {
    probabilities.push_back(found.Cell.Probability);
  }
  return ruc::AverageProbabilities(probabilities);
}
}

void CellTables::FillOutputs(
  const Reconstruction& all, vtkInformationVector* outputs, bool isFirstRank)
{
  FillAllCells(all, vtkMultiBlockDataSet::GetData(outputs, ALL_CELLS), isFirstRank);
  const CellSearch::FoundCell& best = all.Cells[CellSearch::FindBest(all.Cells)];
  const ruc::MeanProbability mean = MeanOf(all.Cells);
  const bool several = all.Cells.size() > 1;
  vtkTable* comparison = vtkTable::GetData(outputs, COMPARISON);
  if (isFirstRank)
  {
    PackData::FillPolyData(best.Cell.Pack, vtkPolyData::GetData(outputs, CELL));
    FillConvergence(
      best.Cell, all.Settings.Gradient.Neighbours, vtkTable::GetData(outputs, CONVERGENCE));
    FillProbabilities(
      all.Target, best.Cell.Probability, mean, several, vtkTable::GetData(outputs, PROBABILITIES));
    FillTableOfCells(all, vtkTable::GetData(outputs, TABLE_OF_CELLS));
    ComparisonTables::FillComparison(all.Target, mean, several, comparison);
  }
  for (int port = 0; port < NUMBER_OF_PORTS; ++port)
  {
    AddCellFields(
      outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT()), best, all);
  }
  PackData::AddField(comparison, "DifferencePercent",
    std::vector<double>{ ruc::CompareProbabilities(all.Target, mean.Mean).Percent });
}
