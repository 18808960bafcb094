// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackOverlap.h"
#include "ruc/Reconstruction/SearchState.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace ruc
{
/** What a search returns. */
struct UnitCell
{
  SpherePack Pack; // centres in [0, edge)^3
  Window Box;
  double Objective = 0.0; // F2 of `Pack`
  /** F2 of the random start, freed from overlap as far as it went; of a population the mean F2 of
   * the first. */
  double StartObjective = 0.0;
  PackOverlap Overlap;
  int Iterations = 0;                  // or generations
  EndReason EndedBy = EndReason::None; // Stopped when the caller ended the search
  TwoPointProbability Probability;
  /** Of every iteration; the last is the cell returned. Of a gradient search 0 is the random start
   * and 1 has its overlap removed; of a population 0 is the best of the first. */
  std::vector<SearchState> Convergence;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Pack, self.Box, self.Objective, self.StartObjective, self.Overlap,
      self.Iterations, self.EndedBy, self.Probability, self.Convergence);
  }
};

/**
 * Collective: the cell of these spheres in a periodic box, freed from overlap (RemoveOverlap, with
 * its seed and `carryOn`, which must return the same on every rank), with its overlap, and its S_rs
 * and F2 by the estimator that made the target. What belongs to a search is left empty.
 */
UnitCell FinishUnitCell(SpherePack pack, const Window& box, const TwoPointProbability& target,
  std::uint32_t seed, Communicator& ranks, const std::function<bool()>& carryOn);
}
