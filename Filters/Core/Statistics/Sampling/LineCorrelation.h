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
 * C_rs(r_k) summed over lines: the length of the x on the line with x in phase r and x + r_k n in
 * phase s. As a function of the lag it is piecewise linear, with a change of slope for every pair
 * of phase changes; these are what is added up, as second differences on the lags.
 */
class LineCorrelation
{
public:
  LineCorrelation(int modes, const LagGrid& lags);

  void AddLine(const std::vector<PhaseChange>& changes);

  /** C_rs of all ordered pairs, as SampledSums::AddBatch takes them; valid until Clear. */
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

  int States; // phases and the outside
  int Lags;
  double Unit;               // of length
  std::vector<double*> Rows; // second differences of each ordered pair of states met so far
  std::vector<std::vector<double>> Storage;
  std::size_t Used = 0; // of the storage
  std::vector<const double*> Correlations;
};
}
