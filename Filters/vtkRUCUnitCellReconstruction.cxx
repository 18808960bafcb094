// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCUnitCellReconstruction.h"

#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "Reconstruction/CellContents.h"
#include "Reconstruction/GradientSearch.h"
#include "Statistics/TwoPointChecks.h"
#include "Text.h"
#include "TwoPointSum.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

vtkStandardNewMacro(vtkRUCUnitCellReconstruction);

namespace
{
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

void FillComparison(
  const ruc::TwoPointProbability& pack, const ruc::TwoPointProbability& cell, vtkTable* table)
{
  PackData::AddLags(table, pack.Lags);
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = r; s < pack.Phases(); ++s)
    {
      PackData::AddColumn(table, PackData::PairName(pack, r, s) + "_pack", pack.S(r, s));
      PackData::AddColumn(table, PackData::PairName(pack, r, s) + "_cell", cell.S(r, s));
    }
  }
}
}

vtkRUCUnitCellReconstruction::vtkRUCUnitCellReconstruction()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkRUCUnitCellReconstruction::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
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
  require(this->Method == GRADIENT, "Method", "the value 0", this->Method);
  require(
    this->NumberOfParticles >= 0, "NumberOfParticles", "a number >= 0", this->NumberOfParticles);
  require(this->CellSize >= 0.0 && std::isfinite(this->CellSize), "CellSize",
    "a finite number >= 0", this->CellSize);
  require(this->NumberOfParticles == 0 || this->CellSize == 0.0, "CellSize",
    "0 when NumberOfParticles is set", this->CellSize);
  require(this->SaturationTolerance > 0.0, "SaturationTolerance", "a number > 0",
    this->SaturationTolerance);
  require(
    this->MaximumIterations >= 0, "MaximumIterations", "a number >= 0", this->MaximumIterations);
  require(this->TargetObjective >= 0.0, "TargetObjective", "a number >= 0", this->TargetObjective);
  require(this->TimeLimit >= 0.0, "TimeLimit", "a number of seconds >= 0", this->TimeLimit);
  require(this->Seed >= 0, "Seed", "a number >= 0", this->Seed);
}

ruc::CellContents vtkRUCUnitCellReconstruction::FindContents(
  const ruc::PackShare& pack, RankCommunicator& ranks, ProgressReport& report)
{
  if (this->NumberOfParticles > 0)
  {
    return ruc::FindCellContents(pack, this->NumberOfParticles);
  }
  if (this->CellSize > 0.0)
  {
    return ruc::FindCellContents(pack, this->CellSize);
  }
  const ruc::LagGrid lags =
    TwoPointSum::MakeLags(0.0, this->NumberOfLags, TwoPointSum::AutomaticLag(pack));
  const ruc::TwoPointProbability probability = TwoPointSum::Compute(pack, lags, ranks, report);
  double length =
    ruc::SaturationLength(probability, this->SaturationTolerance, pack.MeanDiameter());
  if (std::isnan(length))
  {
    length = lags.Maximum();
    if (ranks.Rank() == 0)
    {
      vtkWarningMacro(<< this->GetLabel() << ": S_rs does not saturate within "
                      << this->SaturationTolerance << " up to a lag of " << length
                      << "; the cell's edge is about twice that. Set CellSize for another.");
    }
  }
  return ruc::FindCellContents(pack, 2.0 * length);
}

std::string vtkRUCUnitCellReconstruction::FindStopReason(const ProgressReport& report)
{
  if (this->GetAbortExecute())
  {
    return "Abort";
  }
  if (this->TimeLimit > 0.0 && report.Seconds() >= this->TimeLimit)
  {
    return "Time limit";
  }
  if (!this->StopFile.empty() && std::ifstream(this->StopFile).good())
  {
    return "Stop file";
  }
  return {};
}

void vtkRUCUnitCellReconstruction::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->SetAbortExecute(0); // VTK leaves the wish of a former run standing
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  const PackData::SharedPack pack =
    PackData::FindShare(input, this->GetWindowProperties(), true, ranks);
  const ruc::CellContents contents = this->FindContents(pack.Share, ranks, report);
  const ruc::LagGrid lags =
    TwoPointSum::MakeLags(this->MaximumLag, this->NumberOfLags, 0.5 * contents.Edge);
  const ruc::TwoPointProbability target = TwoPointSum::Compute(pack.Share, lags, ranks, report);

  ruc::GradientSearchSettings settings;
  settings.Seed = static_cast<std::uint32_t>(this->Seed);
  settings.MaximumIterations = this->MaximumIterations;
  settings.TargetObjective = this->TargetObjective;
  std::string stopReason;
  const ruc::UnitCell cell = ruc::SearchByGradient(contents, target, settings, ranks,
    [&](const ruc::SearchState& state)
    {
      if (ranks.Rank() > 0)
      {
        return true;
      }
      report.Update(state.Iteration / (this->MaximumIterations + 3.0),
        ruc::Text(state.Phase, ", iteration ", state.Iteration, ", F2 = ", state.Objective,
          ", overlap ", state.OverlapPercent, " %"));
      stopReason = this->FindStopReason(report);
      return stopReason.empty();
    });
  const bool stopped = cell.EndedBy == "Stopped";
  const std::string endedBy = stopped ? ranks.FirstText(stopReason) : cell.EndedBy;

  const PackData::PackOrigin origin = { cell.Box, "Unit cell", pack.LengthUnit };
  if (ranks.Rank() == 0)
  {
    PackData::FillPolyData(cell.Pack, vtkPolyData::GetData(outputs, 0));
    FillConvergence(cell, vtkTable::GetData(outputs, 1));
    FillComparison(target, cell.Probability, vtkTable::GetData(outputs, 2));
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* data = outputs->GetInformationObject(port)->Get(vtkDataObject::DATA_OBJECT());
    PackData::AddPackSummary(
      data, origin, cell.Pack.Size(), cell.Probability.Fractions, cell.Overlap.Percent);
    PackData::AddField(data, "Method", std::string("Gradient"));
    PackData::AddField(data, "Seed", std::vector<long long>{ this->Seed });
    PackData::AddField(data, "NumberOfLags", std::vector<long long>{ lags.Count });
    PackData::AddField(data, "MaximumLag", std::vector<double>{ lags.Maximum() });
    PackData::AddField(data, "Objective", std::vector<double>{ cell.Objective });
    PackData::AddField(data, "StartObjective", std::vector<double>{ cell.StartObjective });
    PackData::AddField(data, "OnePointDifference",
      std::vector<double>{ ruc::OnePointDifference(contents, target.Fractions, contents.Edge) });
    PackData::AddField(data, "Iterations", std::vector<long long>{ cell.Iterations });
    PackData::AddField(data, "EndedBy", endedBy);
    PackData::AddField(data, "Stopped", std::vector<long long>{ stopped });
  }
  if (ranks.Rank() == 0 && !cell.Overlap.IsNone())
  {
    vtkWarningMacro(<< this->GetLabel() << ": the cell still has overlap, " << cell.Overlap.Percent
                    << " % of the spheres' volume in " << cell.Overlap.Pairs << " pairs"
                    << (stopped ? "; it was stopped early." : "; it is too dense to free."));
  }
}

void vtkRUCUnitCellReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
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
}
