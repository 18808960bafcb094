// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Descent.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/ContactMultipliers.h"
#include "ruc/Reconstruction/SearchState.h"

#include <tuple>
#include <vector>

namespace ruc
{
/**
 * The whole state of a search between two iterations, from which it resumes to the same end, bit by
 * bit.
 */
struct GradientState
{
  DescentState Descent;
  std::vector<double> Best; // the centres of the best cell so far
  double StartObjective = 0.0;
  double Kept = 0.0;  // F2 at the last multiple of IterationsBetweenKept
  double Tried = 0.0; // F2 when a cell was last freed from overlap
  bool Converged = false;
  std::vector<SearchState> Convergence;
  // Of near neighbours and pores, once they are added
  double Reference = 0.0; // F0 of SearchObjective, > 0
  int Before = 0;         // iterations before
  int Lattice = 0;        // the place of the pores' lattice
  // Of a dense cell
  ContactState Contacts;
  double Edge = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Descent, self.Best, self.StartObjective, self.Kept, self.Tried,
      self.Converged, self.Convergence, self.Reference, self.Before, self.Lattice, self.Contacts,
      self.Edge);
  }
};

/**
 * Throws std::invalid_argument for a state, such as one that was read, that cannot be of a search
 * for a cell of these contents. A `dense` cell may have become larger.
 */
void CheckState(const GradientState& state, const CellContents& contents, bool dense);
}
