// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Oracles.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/SearchState.h"
#include "ruc/Reconstruction/UnitCell.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include <gtest/gtest.h>

/** @file A problem for searches: a pack of 8 times 40 spheres, and a cell of 40. */

/** For a search that nobody stops. */
inline const auto CarryOn = [](const ruc::SearchState&) { return true; };

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

/** The same cell, found in the same way. */
inline void ExpectEqual(const ruc::UnitCell& a, const ruc::UnitCell& b)
{
  EXPECT_TRUE(a.Pack.X == b.Pack.X && a.Pack.Y == b.Pack.Y && a.Pack.Z == b.Pack.Z);
  EXPECT_EQ(a.Objective, b.Objective);
  EXPECT_EQ(a.StartObjective, b.StartObjective);
  EXPECT_EQ(a.EndedBy, b.EndedBy);
  EXPECT_EQ(a.Iterations, b.Iterations);
  EXPECT_TRUE(a.Probability.Values == b.Probability.Values);
  ASSERT_EQ(a.Convergence.size(), b.Convergence.size());
  for (std::size_t n = 0; n < a.Convergence.size(); ++n)
  {
    EXPECT_EQ(a.Convergence[n].Phase, b.Convergence[n].Phase);
    EXPECT_EQ(a.Convergence[n].Iteration, b.Convergence[n].Iteration);
    EXPECT_EQ(a.Convergence[n].Objective, b.Convergence[n].Objective);
    EXPECT_EQ(a.Convergence[n].OverlapPercent, b.Convergence[n].OverlapPercent);
    EXPECT_EQ(a.Convergence[n].SumOfMultipliers, b.Convergence[n].SumOfMultipliers);
    EXPECT_TRUE(ruc::NeighbourMisfits::Fields(a.Convergence[n].Misfits) ==
      ruc::NeighbourMisfits::Fields(b.Convergence[n].Misfits));
  }
}
