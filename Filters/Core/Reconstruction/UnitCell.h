// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Reconstruction/SearchState.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

namespace ruc
{
/** The cell that a search returns. */
struct UnitCell
{
  SpherePack Pack; // with centres in [0, edge)^3
  Window Box;
  double Objective = 0.0; // F2 of `Pack`
  /**
   * F2 of the start: of a gradient search that of the random centres, freed from overlap as far as
   * it went; of a population the mean of the first.
   */
  double StartObjective = 0.0;
  PackOverlap Overlap;
  /** The overlap of the spheres enlarged by the least gap of the cell; without one it is Overlap.
   */
  PackOverlap TooNear;
  int Iterations = 0;                  // or generations
  EndReason EndedBy = EndReason::None; // Stopped when the caller ended the search
  TwoPointProbability Probability;
  /**
   * Where the search stood in every iteration; the last is the cell returned. In a gradient search
   * entry 0 is the random start and entry 1 has its overlap removed; in a population entry 0 is the
   * best of the first.
   */
  std::vector<SearchState> Convergence;
  /** Zeta of `Pack` (MeasureZeta); NaN where the search has no spectrum, or the cell overlap. */
  double Zeta = std::numeric_limits<double>::quiet_NaN();

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Pack, self.Box, self.Objective, self.StartObjective, self.Overlap,
      self.TooNear, self.Iterations, self.EndedBy, self.Probability, self.Convergence, self.Zeta);
  }
};

/**
 * Returns the cell of these spheres in a periodic box. Its overlap is measured, and its S_rs and F2
 * are found by the estimator that made the target. The fields that belong to a search are left
 * empty. Collective.
 */
UnitCell MeasureUnitCell(
  SpherePack pack, const Window& box, const TwoPointProbability& target, Communicator& ranks);

/**
 * The same, freed from overlap before by RemoveOverlap (with its seed and `carryOn`, which must
 * return the same on every rank). Collective.
 */
UnitCell FinishUnitCell(SpherePack pack, const Window& box, const TwoPointProbability& target,
  std::uint32_t seed, Communicator& ranks, const std::function<bool()>& carryOn);

/**
 * Returns the overlap of a cell in percent, as MeasureOverlap defines it, from S_rs(0), to which
 * every pair that overlaps adds its lens volume twice.
 */
double OverlapPercentOf(const TwoPointProbability& probability);
}
