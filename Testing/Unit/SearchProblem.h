// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Oracles.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

/** @file A problem for searches: a pack of 8 times 40 spheres, and a cell of 40. */

struct SearchProblem
{
  SearchProblem()
    : Box(oracle::PeriodicCube(12.7))
    , Contents(ruc::FindCellContents(
        ruc::SharePack(oracle::RelaxedPack({ 107, 213 }, { 1.0, 0.6 }, this->Box, 70), this->Box),
        40))
    , Target(ruc::SumPairs(
        oracle::RelaxedPack({ 107, 213 }, { 1.0, 0.6 }, this->Box, 70), this->Box, { 0.15, 24 }))
  {
  }
  ruc::Window Box;
  ruc::CellContents Contents;
  ruc::TwoPointProbability Target;
};

inline const SearchProblem& TheSearchProblem()
{
  static const SearchProblem problem;
  return problem;
}
