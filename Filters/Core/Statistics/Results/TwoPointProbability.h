// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"

#include <string>
#include <tuple>
#include <vector>

namespace ruc
{
/**
 * The two-point probability functions S_rs(r_k) of a medium with N_p particle modes and the matrix.
 *
 * Phases are counted from 0 here: 0 to N_p - 1 are the modes 1 to N_p, and N_p is the matrix. The
 * normalisation is raw: S_rs(0) = c_r delta_rs and S_rs(infinity) = c_r c_s. As S_rs = S_sr, each
 * is stored once.
 */
struct TwoPointProbability
{
  /** All numbers are 0 at first. */
  TwoPointProbability(int modes, const LagGrid& lags);

  int Modes;
  LagGrid Lags;
  /** c_r of every phase, the matrix last. */
  std::vector<double> Fractions;
  /** S_rs of every unordered pair of phases, K + 1 numbers each: (0,0), (0,1), …, (1,1), … */
  std::vector<std::vector<double>> Values;

  int Phases() const { return this->Modes + 1; }
  int Pairs() const { return static_cast<int>(this->Values.size()); }
  /** The place in Values of a pair of phases. */
  int PairOf(int r, int s) const;
  std::vector<double>& S(int r, int s) { return this->Values[this->PairOf(r, s)]; }
  const std::vector<double>& S(int r, int s) const { return this->Values[this->PairOf(r, s)]; }

  /**
   * Fills in the matrix's fraction and functions from those of the particles, which is exact for
   * spheres that do not overlap: S_rm = c_r - sum_s S_rs and S_mm = 1 - 2 sum_r c_r + sum_rs S_rs.
   */
  void CompleteMatrix();

  /** The name of a phase: "1", "2", … or "m". */
  std::string PhaseName(int phase) const;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Modes, self.Lags, self.Fractions, self.Values);
  }
};

/**
 * Returns ||f|| = sqrt(sum over k = 1…K of f(r_k)^2), the paper's discrete L2 norm. It is not
 * divided by K.
 */
double DiscreteNorm(const std::vector<double>& values);

/**
 * Returns F2, equation (13): the sum over all N^2 ordered pairs of phases of || S_rs of a - S_rs of
 * b ||. Both must have the same phases and lags.
 */
double TwoPointDifference(const TwoPointProbability& a, const TwoPointProbability& b);
}
