// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "HardPack.h"
#include "SearchProblem.h"
#include "ThreadRanks.h"
#include "ruc/Reconstruction/CellStart.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <vector>

/** @file What tests of the terms of third order have in common. */

/** Hard spheres after some collisions, and a cell of a part of them. */
struct TermProblem
{
  TermProblem()
    : Made(80, 200, 0.45)
    , Contents(ruc::FindCellContents(ruc::SharePack(Made.Pack, Made.Box), 70))
    , Target(ruc::SumPairs(Made.Pack, Made.Box, { 0.15, 20 }))
  {
    this->PackAsCell.Count = { 80, 200 };
    this->PackAsCell.Radius = { 1.0, 0.6 };
    this->PackAsCell.Edge = this->Made.Box.Size[0];
  }
  HardPack Made;
  ruc::CellContents Contents, PackAsCell;
  ruc::TwoPointProbability Target;

  /** Random centres of the cell, which overlap unless they are `loose`. */
  std::vector<double> SomeCentres(bool loose = true) const
  {
    ruc::SpherePack pack = this->Contents.MakePack(ruc::RandomCentres(Contents, 5, 0).data());
    if (loose)
    {
      ruc::RemoveOverlap(pack, this->Contents.MakeBox(), 5, []() { return true; });
    }
    return ruc::CentresOf(pack);
  }
};

/** evaluate(centres, gradient), where gradient may be null, adds the gradient of what it returns.
 */
template <class Evaluate>
void ExpectGradientOfValue(
  std::vector<double> centres, int stride, double step, double tolerance, Evaluate&& evaluate)
{
  std::vector<double> gradient(centres.size(), 0.0);
  evaluate(centres, gradient.data());
  double largest = 0.0, sum[3] = { 0.0, 0.0, 0.0 };
  for (std::size_t n = 0; n < gradient.size(); ++n)
  {
    largest = std::max(largest, std::abs(gradient[n]));
    sum[n % 3] += gradient[n];
  }
  ASSERT_GT(largest, 0.0);
  for (double along : sum)
  {
    EXPECT_NEAR(along, 0.0, 1e-9 * largest) << "moving all spheres changes nothing";
  }
  for (std::size_t n = 0; n < gradient.size(); n += stride)
  {
    const double before = centres[n];
    centres[n] = before + step;
    const double up = evaluate(centres, nullptr);
    centres[n] = before - step;
    const double down = evaluate(centres, nullptr);
    centres[n] = before;
    EXPECT_NEAR((up - down) / (2.0 * step), gradient[n], tolerance * largest);
  }
}

/** evaluate(ranks, gradient) gives the same bits on any ranks and threads; gradient begins with 0.
 */
template <class Evaluate>
void ExpectSameOnAnyRanks(std::size_t size, Evaluate&& evaluate)
{
  ruc::Communicator alone;
  std::vector<double> expected(size, 0.0);
  const double value = evaluate(alone, expected.data());
  for (int ranks = 1; ranks <= 4; ++ranks)
  {
    oracle::ThreadRanks::Run(ranks,
      [&](ruc::Communicator& communicator)
      {
        omp_set_num_threads(5 - ranks);
        std::vector<double> gradient(size, 0.0);
        EXPECT_EQ(evaluate(communicator, gradient.data()), value);
        EXPECT_TRUE(gradient == expected);
      });
  }
}
