// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace ruc
{
/**
 * The matrix of the equations of a ball, BallSums::Normal, as L L^T (Cholesky). It cannot be solved
 * where too few voxels see the ball.
 */
class BallEquations
{
public:
  explicit BallEquations(const std::array<double, 10>& upper)
  {
    double a[4][4];
    for (int i = 0, n = 0; i < 4; ++i)
    {
      for (int j = i; j < 4; ++j, ++n)
      {
        a[j][i] = upper[n];
      }
    }
    for (int j = 0; j < 4 && this->Good; ++j)
    {
      for (int i = j; i < 4; ++i)
      {
        double sum = a[i][j];
        for (int k = 0; k < j; ++k)
        {
          sum -= this->L[i][k] * this->L[j][k];
        }
        this->Good = this->Good && (i > j || sum > 1e-6 * a[j][j]);
        this->L[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / this->L[j][j];
      }
    }
  }

  bool AreSolvable() const { return this->Good; }

  std::array<double, 4> Solve(std::array<double, 4> b) const
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int k = 0; k < i; ++k)
      {
        b[i] -= this->L[i][k] * b[k];
      }
      b[i] /= this->L[i][i];
    }
    for (int i = 3; i >= 0; --i)
    {
      for (int k = i + 1; k < 4; ++k)
      {
        b[i] -= this->L[k][i] * b[k];
      }
      b[i] /= this->L[i][i];
    }
    return b;
  }

private:
  bool Good = true;
  double L[4][4] = {};
};
}
