// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include "ruc/Statistics/Results/Phases.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ruc
{
TwoPointProbability::TwoPointProbability(int modes, const LagGrid& lags)
  : Modes(modes)
  , Lags(lags)
  , Fractions(modes + 1, 0.0)
  , Values((modes + 1) * (modes + 2) / 2, std::vector<double>(lags.Count + 1, 0.0))
{
}

int TwoPointProbability::PairOf(int r, int s) const
{
  const int low = std::min(r, s);
  return low * this->Phases() - low * (low - 1) / 2 + std::max(r, s) - low;
}

void TwoPointProbability::CompleteMatrix()
{
  const int m = this->Modes;
  double particles = 0.0;
  for (int r = 0; r < m; ++r)
  {
    particles += this->Fractions[r];
  }
  this->Fractions[m] = 1.0 - particles;
  std::vector<double>& matrix = this->S(m, m);
  matrix.assign(this->Lags.Count + 1, 1.0 - 2.0 * particles);
  for (int r = 0; r < m; ++r)
  {
    std::vector<double>& mixed = this->S(r, m);
    mixed.assign(this->Lags.Count + 1, this->Fractions[r]);
    for (int s = 0; s < m; ++s)
    {
      const std::vector<double>& pair = this->S(r, s);
      for (int k = 0; k <= this->Lags.Count; ++k)
      {
        mixed[k] -= pair[k];
        matrix[k] += pair[k];
      }
    }
  }
}

std::string TwoPointProbability::PhaseName(int phase) const
{
  return ruc::PhaseName(phase, this->Modes);
}

double DiscreteNorm(const std::vector<double>& values)
{
  double sum = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k)
  {
    sum += values[k] * values[k];
  }
  return std::sqrt(sum);
}

double TwoPointDifference(const TwoPointProbability& a, const TwoPointProbability& b)
{
  double total = 0.0;
  std::vector<double> difference(a.Lags.Count + 1);
  for (int r = 0; r < a.Phases(); ++r)
  {
    for (int s = r; s < a.Phases(); ++s)
    {
      std::transform(
        a.S(r, s).begin(), a.S(r, s).end(), b.S(r, s).begin(), difference.begin(), std::minus<>());
      total += (r == s ? 1.0 : 2.0) * DiscreteNorm(difference);
    }
  }
  return total;
}
}
