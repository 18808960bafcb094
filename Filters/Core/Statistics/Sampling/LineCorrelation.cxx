// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/LineCorrelation.h"

#include "ruc/Statistics/Sampling/SecondDifferences.h"

#include <algorithm>

namespace ruc
{
LineCorrelation::LineCorrelation(int modes, const LagGrid& lags)
  : States(modes + 2)
  , Lags(lags.Count)
  , Unit(lags.Count > 0 ? lags.Spacing : 1.0)
  , Rows(static_cast<std::size_t>(States) * States, nullptr)
  , Correlations(static_cast<std::size_t>(modes + 1) * (modes + 1), nullptr)
{
}

double* LineCorrelation::NewRow(double*& row)
{
  if (this->Used == this->Storage.size())
  {
    this->Storage.emplace_back(this->Lags + 2);
  }
  std::vector<double>& differences = this->Storage[this->Used++];
  std::fill(differences.begin(), differences.end(), 0.0);
  return row = differences.data();
}

void LineCorrelation::AddLine(const std::vector<PhaseChange>& changes)
{
  // With the indicator function I_r of a phase on the line, C_rs'' at the lag p is minus the sum,
  // over all pairs of phase changes p apart, of (jump of I_r at the first) x (jump of I_s at the
  // second).
  const int outside = this->States - 1;
  const double scale = 1.0 / this->Unit;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const int before = changes[i].Before, after = changes[i].After;
    // A change with itself adds half of the kink at lag 0, which is all of it for lags >= 0
    if (before != outside)
    {
      AddRamp(-1.0, 0.0, this->RowOf(before, before));
      AddRamp(1.0, 0.0, this->RowOf(before, after));
    }
    if (after != outside)
    {
      AddConstant(
        scale * (changes[i + 1].Position - changes[i].Position), this->RowOf(after, after));
    }
    for (std::size_t j = i + 1; j < changes.size(); ++j)
    {
      const double apart = scale * (changes[j].Position - changes[i].Position);
      if (apart > this->Lags)
      {
        break;
      }
      AddRamp(-1.0, apart, this->RowOf(after, changes[j].After));
      AddRamp(1.0, apart, this->RowOf(after, changes[j].Before));
      AddRamp(1.0, apart, this->RowOf(before, changes[j].After));
      AddRamp(-1.0, apart, this->RowOf(before, changes[j].Before));
    }
  }
}

const std::vector<const double*>& LineCorrelation::Finish()
{
  const int phases = this->States - 1;
  for (int r = 0; r < phases; ++r)
  {
    for (int s = 0; s < phases; ++s)
    {
      double* row = this->Rows[static_cast<std::size_t>(r) * this->States + s];
      if (row)
      {
        Integrate(this->Unit, this->Lags, row);
      }
      this->Correlations[static_cast<std::size_t>(r) * phases + s] = row;
    }
  }
  return this->Correlations;
}

void LineCorrelation::Clear()
{
  std::fill(this->Rows.begin(), this->Rows.end(), nullptr);
  this->Used = 0;
}
}
