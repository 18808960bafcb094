// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Comparison/PackDescriptors.h"

#include <string>
#include <vector>

namespace ruc
{
/** A figure of packs and of cells side by side. */
struct ReportRow
{
  std::string Name;
  DescriptorKind Kind;
  double Pack, PackError;
  double Cell; // the mean over the cells
  /** The standard deviation over the cells; of one cell its own standard error, or NaN. */
  double CellDeviation;
  /**
   * (Cell - Pack) over its standard error, which is the root of PackError^2 + CellDeviation^2 /
   * number of cells. 0 where both are equal, infinite where nothing is known to scatter.
   */
  double Z;
  bool Fitted; // whether the search that found the cells fits it
};

/** Whether cells are as another piece of their pack, in the pack's own standard errors. */
struct ReportCard
{
  std::vector<ReportRow> Rows;
  double Floor = 0.0; // ObjectiveFloor of the packs
  int Packs = 0, Cells = 0;

  /** |Z| up to this is as another piece of the pack. */
  static constexpr double MostZ = 2.0;
  int Within() const;
  double LargestZ() const;
  /**
   * One sentence: "Representative within the pack's own error in 17 of 19 descriptors; not in: ..."
   */
  std::string Verdict() const;
};

/**
 * Compares cells with packs of one process, of each of which there is at least one. All have the
 * same modes and lags. Of one pack the errors are its own; of several, they are the scatter of the
 * packs, s / sqrt(number). `fitted` tells of each kind whether the search fits it. Figures that one
 * of them does not have are left out.
 *
 * Besides the figures of PackDescriptors there are the rows `S_rs`, the mean F2 of the cells over
 * the packs' mean S_rs, and `S_m_m`, the discrete norm of the difference of the matrix's function
 * alone. Of both Pack is 0 and PackError what the medium is expected to differ by: ObjectiveFloor,
 * and the norm of the errors.
 */
ReportCard MakeReportCard(const std::vector<PackDescriptors>& packs,
  const std::vector<PackDescriptors>& cells, const std::vector<bool>& fitted);
}
