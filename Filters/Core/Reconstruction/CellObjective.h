// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * The objective of the reconstruction and its gradient: F2, equation (13), of a periodic cell
 * against a target, plus a penalty for spheres that overlap,
 *
 *     F2 + w sum over overlapping pairs of ((a + b - d) / r)^2,
 *
 * r the mean radius, weighted by volume, of the cell's spheres.
 *
 * F2 depends on the centres through the pair distances alone. With lambda_rs(k) = dF2/dS_rs(r_k)
 * the tabulated pair potential Phi_rs(d) = sum_k lambda_rs(k) g_rs(r_k; d) gives dF2/dx_i as a sum
 * of pair forces, at the cost of one more pass over the pairs. The penalty is part of the same
 * tables. Centres are in the order of the modes: first all of mode 1, …
 *
 * The pairs are split over the ranks; sums over pairs are integers, so every rank gets the same
 * bits, whatever their number.
 */
class CellObjective
{
public:
  CellObjective(
    const CellContents& contents, const TwoPointProbability& target, Communicator& communicator);

  void SetPenaltyWeight(double weight) { this->PenaltyWeight = weight; }

  struct Terms
  {
    double TwoPoint; // F2
    double Penalty;  // w times the sum
    double Total() const { return this->TwoPoint + this->Penalty; }
  };

  /**
   * Collective. `centres` holds x, y, z of every sphere, anywhere in space; `gradient` as many
   * numbers, or null when it is not wanted. `signal` is a number of the ranks' own that is summed
   * along, such as a wish to stop; it may be null.
   */
  Terms Evaluate(const double* centres, double* gradient, std::int64_t* signal = nullptr);

  /** The two-point probability of the cell evaluated last. */
  const TwoPointProbability& GetProbability() const { return this->Probability; }

private:
  // Adds sum_k lambda g to the potential that holds the penalty
  void AddTwoPointPotential(double volume);

  CellContents Contents;
  const TwoPointProbability& Target;
  Communicator& Ranks;
  PairHistogram Histogram;
  TwoPointProbability Probability;
  double PenaltyWeight = 1.0;
  double PenaltyRadius;
  std::vector<std::int64_t> Sums;
  std::vector<double> Potential;
};

/** What estimates have to know of a cell. */
struct CellFigures
{
  double Spheres = 0.0;
  double Density = 0.0; // spheres per volume
  double LargestRadius = 0.0;
  int Modes = 1;
};

/** Seconds of one evaluation of the objective, on one core. */
double EstimateEvaluation(const CellFigures& cell, const LagGrid& lags, bool withGradient);
}
