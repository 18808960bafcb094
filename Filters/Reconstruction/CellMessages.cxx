// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMessages.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <iomanip>

using ruc::Text;

RunProgress CellMessages::DescribeProgress(
  int cell, const ruc::SearchState& state, const CellSearch::Settings& settings)
{
  RunProgress progress;
  progress.Activity =
    Text(settings.NumberOfCells > 1 ? Text("cell ", cell + 1, ", ") : std::string(),
      ruc::NameOf(state.Phase), ", ", settings.IsByPopulation() ? "generation " : "iteration ",
      state.Iteration, ", overlap ", std::setprecision(2), state.OverlapPercent, " %");
  progress.Stoppable = true;
  progress.Quantity = "F2";
  progress.Value = state.Objective;
  return progress;
}

std::string CellMessages::FindNeighbourWarning(const ruc::NeighbourTarget& neighbours)
{
  std::string missing;
  const auto check = [&](double weight, const ruc::HingeSums& sums, const char* what, double margin)
  {
    if (weight > 0.0 && sums.Empty())
    {
      missing += Text(missing.empty() ? "" : ", ", what, " (", margin, ")");
    }
  };
  check(neighbours.ContactWeight, neighbours.Pack.Gaps, "gaps of neighbours", 0.0);
  check(neighbours.ContactWeight, neighbours.Pack.Nearest, "nearest gaps",
    1.0 + ruc::LargestNeighbourGap);
  check(neighbours.PoreWeight, neighbours.Pack.Pores, "pores", 1.0);
  return missing.empty() ? missing
                         : Text("These do not count, as the pack tells none: ", missing,
                             ". They require ", ruc::LeastCentresOfSums,
                             " spheres as many largest diameters away from the faces as stands "
                             "behind each, which differ "
                             "from place to place.");
}

std::vector<std::string> CellMessages::FindWarnings(const std::vector<CellSearch::FoundCell>& cells,
  const ruc::CellContents& contents, const CellSearch::Settings& settings)
{
  std::vector<std::string> warnings;
  for (const CellSearch::FoundCell& found : cells)
  {
    ruc::CellContents larger = contents;
    larger.Edge = found.Cell.Box.Size[0];
    if (larger.Edge > contents.Edge)
    {
      warnings.push_back(
        Text("cell ", found.Number + 1, " is larger than wanted: its spheres jam at a fraction of ",
          larger.Fraction(), ", below the ", contents.Fraction(), " of the pack."));
    }
    const ruc::PackOverlap& overlap = found.Cell.Overlap;
    if (!overlap.IsNone())
    {
      warnings.push_back(Text("cell ", found.Number + 1, " still has overlap, ", overlap.Percent,
        " % of the spheres' volume in ", overlap.Pairs, " pairs",
        ruc::IsFromOutside(found.Cell.EndedBy) ? "; it was stopped early."
                                               : "; it is too dense to free."));
    }
    else if (!found.Cell.TooNear.IsNone())
    {
      warnings.push_back(Text("cell ", found.Number + 1, " has ", found.Cell.TooNear.Pairs,
        " pairs of spheres nearer than MinimumGap and MinimumGapShare require",
        ruc::IsFromOutside(found.Cell.EndedBy) ? "; it was stopped early."
                                               : "; it is too dense for such gaps."));
    }
  }
  const auto wasStopped = [](const CellSearch::FoundCell& found)
  { return ruc::IsFromOutside(found.Cell.EndedBy); };
  const auto stopped = std::find_if(cells.begin(), cells.end(), wasStopped);
  if (stopped == cells.end())
  {
    return warnings;
  }
  const char* why = ruc::NameOf(stopped->Cell.EndedBy);
  if (stopped->IsShown)
  {
    warnings.push_back(Text("shown as it was when it was stopped (", why,
      "), from its CheckpointFile; to go on, set ContinueAfterStops to ", stopped->Stops, "."));
  }
  else if (settings.CheckpointFile.empty())
  {
    warnings.push_back(Text("stopped (", why,
      "); a state file does not keep the cell and searches anew when it is loaded. Save the data, "
      "or set CheckpointFile."));
  }
  const std::size_t wanted = settings.NumberOfCells;
  if (cells.size() < wanted)
  {
    warnings.push_back(
      Text("stopped before ", wanted - cells.size(), " of ", wanted, " cells were begun."));
  }
  return warnings;
}
