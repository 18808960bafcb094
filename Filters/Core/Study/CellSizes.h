// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Reconstruction/GradientSearch.h"
#include "ruc/Statistics/Comparison/ReportCard.h"

#include <functional>
#include <string>
#include <vector>

namespace ruc
{
/** The cells that are made of a pack to see how large one must be. */
struct CellSizeSettings
{
  std::vector<int> Sizes;  // spheres in a cell, each > 0
  int Cells = 3;           // of each size, with seeds from Search.Seed on; from 1 to 100
  double MaximumLag = 0.0; // 0 stands for the automatic lag of the pack or, if that is less, the
                           // edge of the smallest cell
  int NumberOfLags = 277;
  int Blocks = 64; // for the pack's own errors (DescriptorSettings)
  /** The terms that weigh more than 0 are measured for the pack here. */
  GradientSearchSettings Search;
};

/** How cells of one size compare with the pack. */
struct CellsOfSize
{
  int Spheres = 0;
  double Edge = 0.0;
  std::vector<double> Objectives; // F2 of each cell
  ReportCard Card;

  /** The largest |Z| of all descriptors, or of those that the search fits. */
  double LargestZ(bool fittedAlone) const;
};

struct CellSizeStudy
{
  std::vector<CellsOfSize> Sizes;   // ascending
  std::vector<std::string> LeftOut; // why sizes are left out, in whole sentences
  LagGrid Lags{};
  double Floor = 0.0; // ObjectiveFloor of the pack
  bool Stopped = false;

  /**
   * Returns the least size from which on every |Z| is at most ReportCard::MostZ, of all descriptors
   * or of those that the search fits; 0 where there is none.
   */
  int LeastSize(bool fittedAlone) const;
  /** One sentence. */
  std::string Verdict() const;
};

/**
 * Makes cells of each size by SearchByGradient and compares them with the pack (MakeReportCard).
 * Sizes at which a mode would have no sphere, or the cell no room, are left out. `carryOn` is told
 * the share that is done, in words, and is asked on every rank whether to go on; what was finished
 * by then is kept. The result is equal, bit by bit, for any number of ranks and threads.
 * Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for settings out of range, a pack without
 * room for blocks, and where every size is left out.
 */
CellSizeStudy StudyCellSizes(const PackShare& share, CellSizeSettings settings, Communicator& ranks,
  const std::function<bool(double done, const std::string& what)>& carryOn);

/** What StudyCellSizes takes. */
Estimate EstimateCellSizes(const PackFigures& pack, const CellSizeSettings& settings);
}
