// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SizeClasses.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/OverlapTerm.h"
#include "ruc/Reconstruction/TwoPointTerm.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * The weight of the overlap penalty in a descent. The contacts are the stiffest
 * part of the objective. The less they weigh, the quicker a descent goes, but the more overlap is
 * left to be removed from a cell that is kept. Weights from 0.01 to 0.03 both go well.
 */
constexpr double DescentPenaltyWeight = 0.02;

/**
 * The objective of the reconstruction and its gradient, a sum of terms: F2, equation (13), of a
 * periodic cell against a target (TwoPointTerm), plus a penalty for spheres that overlap
 * (OverlapTerm).
 *
 * Both terms depend on the centres through the pair distances alone. The pairs are counted once for
 * all terms into a histogram, from which each term works out its value. For the gradient, each term
 * adds to one tabulated pair potential: by how much one more pair at that distance would change the
 * term's value. One more pass over the pairs then gives the gradient as a sum of pair forces. A
 * term that depends on more than pairs would be evaluated beside these, and add to the gradient
 * after that pass.
 *
 * The pairs are split over the ranks. Sums over pairs are integers, so that every rank gets the
 * same bits, whatever the number of ranks.
 */
class CellObjective
{
public:
  /** `target` and `communicator` are kept as references. */
  CellObjective(
    const CellContents& contents, const TwoPointProbability& target, Communicator& communicator);
  CellObjective(const CellObjective&) = delete; // the terms refer to the histogram
  void operator=(const CellObjective&) = delete;

  /** Sets the weight of the overlap penalty, which is 1 at first. */
  void SetPenaltyWeight(double weight) { this->Overlap.SetWeight(weight); }

  struct Terms
  {
    double TwoPoint = 0.0; // F2
    double Penalty = 0.0;  // for overlap
    double Total() const { return this->TwoPoint + this->Penalty; }
  };

  /**
   * Evaluates the objective. `centres` holds x, y, z of every sphere in the order of the modes,
   * first all of mode 1, anywhere in space. `gradient` receives as many numbers, or is null when it
   * is not wanted. `signal` is a number of the caller's, such as a wish to stop, that is replaced
   * by its sum over the ranks on the way; it may be null. Collective.
   */
  Terms Evaluate(const double* centres, double* gradient, std::int64_t* signal = nullptr);

  /** The two-point probability of the cell evaluated last. */
  const TwoPointProbability& GetProbability() const { return this->TwoPoint.GetProbability(); }

private:
  PairCounts CountAllPairs(
    const CellList& cells, const std::vector<std::int32_t>& types, std::int64_t* signal);
  // The derivative of the potential's sum over all pairs with respect to the centres
  void FindGradient(
    const CellList& cells, const std::vector<std::int32_t>& types, double* gradient) const;

  CellContents Contents;
  Communicator& Ranks;
  SizeClasses Sizes;
  std::vector<std::int32_t> TypeOf; // of every sphere
  PairHistogram Histogram;
  TwoPointTerm TwoPoint;
  OverlapTerm Overlap;
  std::vector<std::int64_t> Sums;
  std::vector<double> Potential;
};

/** What estimates have to know about a cell. */
struct CellFigures
{
  double Spheres = 0.0;
  double Density = 0.0; // spheres per volume
  double LargestRadius = 0.0;
  int Modes = 1;
  std::vector<double> Radius; // of every type, as far as they are known
  std::vector<double> Share;  // of each type in the number of spheres, where that is known
  std::vector<int> Mode = {}; // of every type, or empty where types are modes

  /** The same with up to so many diameters in every mode, see DivideModes. */
  CellFigures Divided(int diameters) const;
};

/** Returns the figures of the spheres that fill a cell. */
CellFigures FiguresOf(const CellContents& contents);

/**
 * Returns the bytes that an objective takes on every rank. They grow with the ratio of the largest
 * radius, or of the last lag, to the smallest radius.
 */
double EstimateObjectiveBytes(const CellFigures& cell, const LagGrid& lags);

/** The seconds that one evaluation of the objective takes on one core. */
double EstimateEvaluation(const CellFigures& cell, const LagGrid& lags, bool withGradient);
}
