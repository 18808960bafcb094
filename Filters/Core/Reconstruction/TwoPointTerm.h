// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/PairCounts.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <vector>

namespace ruc
{
/**
 * F2, equation (13), of a periodic cell against a target, the first term of CellObjective.
 *
 * With lambda_rs(k) = dF2/dS_rs(r_k), the tabulated pair potential Phi_rs(d) = sum_k lambda_rs(k)
 * g_rs(r_k; d) gives dF2/dx_i as a sum of pair forces.
 *
 * The classes of pairs are shared out over the ranks. Every rank gets the same bits, whatever the
 * number of ranks.
 */
class TwoPointTerm
{
public:
  /** All that is referred to must outlive the term; `classes` are the cell's own. */
  TwoPointTerm(const CellContents& contents, const TwoPointProbability& target,
    const PairHistogram& classes, Communicator& communicator);

  /** Returns F2. Collective. */
  double Evaluate(const PairCounts& pairs);

  /**
   * Adds Phi_rs of the pairs evaluated last to `potential`, a function on the knots of all classes.
   * Collective.
   */
  void AddPotential(std::vector<double>& potential) const;

  /** S_rs of the pairs evaluated last. */
  const TwoPointProbability& GetProbability() const { return this->Probability; }

private:
  // Adds S_rs at every lag for a class of pairs: the shares of its pairs, both ways in one mode,
  // and of single particles where both types are the same
  void FindProbability(int pairClass, const PairCounts& pairs, double* probability) const;

  std::vector<int> Count; // the spheres of every type
  double Volume;          // of the cell
  const TwoPointProbability& Target;
  const PairHistogram& Classes;
  Communicator& Ranks;
  TwoPointProbability Probability;
};
}
