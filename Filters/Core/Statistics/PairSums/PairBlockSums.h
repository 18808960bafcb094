// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Statistics/Results/TaperedBlocks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ruc
{
/**
 * How the pairs for standard errors are counted: in steps of the distance for each unordered pair
 * of modes, whose spheres stand for so many of their mean volume. Pairs matter up to the near lag.
 */
class PairSteps
{
public:
  PairSteps(const PackShare& share, const LagGrid& lags);

  // What a pair of a sphere of one mode with one of another needs
  struct Row
  {
    double SquaredReach, InverseStep, InverseCube;
    int Begin, Last;
  };
  const Row* RowOf(int mode) const { return &this->Rows[mode * this->Modes]; }

  int PairOf(int r, int s) const
  {
    const int low = std::min(r, s);
    return low * this->Modes - low * (low - 1) / 2 + std::max(r, s) - low;
  }
  int Size() const { return this->Begin.back(); }
  double LargestReach() const
  {
    return this->Near + 2.0 * *std::max_element(this->Radius.begin(), this->Radius.end());
  }

  int Modes;
  double Near;
  std::vector<double> Volume, Radius; // the mean of each mode
  std::vector<double> Reach, Step;    // of each pair of modes
  std::vector<int> Begin;
  std::vector<Row> Rows;
};

/** The near lag, in mean diameters, and the steps, in radii of the smaller of two modes. */
constexpr double NearLagOfErrors = 2.0;
constexpr double StepOfErrors = 0.25;

/** Sums over the spheres of the whole pack, which were added up as integers. */
struct BlockSums
{
  std::vector<double> Pairs;   // for each block and step the pairs, each met from both sides
  std::vector<double> Volumes; // for each cell and mode
  std::vector<double> Surface; // for each cell
  std::vector<double> Rings;   // the volume in rings of equal area, for a cylinder
};

/**
 * Sums up a pack in blocks. The result is equal, bit by bit, for any number of ranks and threads.
 * Collective.
 */
BlockSums SumBlocks(
  const PackShare& share, const PairSteps& steps, const TaperedBlocks& blocks, Communicator& ranks);
}
