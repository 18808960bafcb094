// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Tracing/PhaseChanges.h"

#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * C_rs(r_k) summed over lines: the length of those x on a line with x in phase r and x + r_k n in
 * phase s, n being the direction of the line. As a function of the lag it is piecewise linear, with
 * a change of slope for every pair of phase changes. These changes of slope are what is added up,
 * as second differences on the lags.
 */
class LineCorrelation
{
public:
  LineCorrelation(int modes, const LagGrid& lags);

  void AddLine(const std::vector<PhaseChange>& changes);

  /**
   * Returns C_rs of all ordered pairs of phases, as SampledSums::AddBatch takes them; valid until
   * Clear.
   */
  const std::vector<const double*>& Finish();

  /** Begins anew. */
  void Clear();

private:
  double* RowOf(int r, int s)
  {
    double*& row = this->Rows[static_cast<std::size_t>(r) * this->States + s];
    return row ? row : this->NewRow(row);
  }
  double* NewRow(double*& row);

  int States; // the number of phases, and one for the outside
  int Lags;
  double Unit;               // the unit of length
  std::vector<double*> Rows; // second differences of each ordered pair of states met so far
  std::vector<std::vector<double>> Storage;
  std::size_t Used = 0; // how many rows of Storage are in use
  std::vector<const double*> Correlations;
};
}
