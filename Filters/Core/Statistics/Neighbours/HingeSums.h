// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

namespace ruc
{
/**
 * How often a number u, such as the gap between two spheres, takes which values, told by integrals
 * of its cumulative distribution: at each threshold Z the mean of (Z - u)+, or of (u - Z)+, where
 * (t)+ is t where t > 0, else 0. Such a hinge sum has a slope wherever it is not 0, so that a
 * descent can follow it, which a count has not.
 */
struct HingeSums
{
  std::vector<double> Threshold; // ascending
  std::vector<double> Value;     // in the unit of u
  std::vector<double> Error;     // the standard error of each value, > 0

  std::size_t Size() const { return this->Threshold.size(); }
  bool Empty() const { return this->Threshold.empty(); }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Threshold, self.Value, self.Error);
  }
};

/**
 * The values that a number took in a pack, counted in equal bins for each of several blocks of the
 * pack, whose scatter tells the standard error.
 */
struct BlockHistogram
{
  BlockHistogram(double low, double high, int blocks);

  static constexpr int Bins = 8192;

  /** The bin of a value; one below the lowest bin counts there, one above as the highest. */
  int BinOf(double value) const;
  /** The middle of a bin. */
  double ValueOf(int bin) const;

  double Low, High;
  int Blocks;
  std::vector<double> Weight; // Bins numbers for each block, one block after the other
  /** For each block, that by which its weights are divided to give a mean. */
  std::vector<double> Norm;
};

/** Which side of its threshold a hinge sum counts. */
enum class HingeSide
{
  Below, // (Z - u)+
  Above  // (u - Z)+
};

/**
 * Returns the hinge sums of a pack. The 21 thresholds lie where the share of the weight that is
 * counted, from the lowest value for Below and from the highest for Above, is (k / 64)^2, k = 3, 6,
 * ... 63. They are the denser, the rarer the values. The standard errors are those of the
 * delete-one jackknife over the blocks. Thresholds below `least`, and those without an error > 0,
 * are left out.
 */
HingeSums FindHingeSums(const BlockHistogram& histogram, HingeSide side, double least);

/**
 * Returns the mean over the thresholds of ((value - pack's value) / pack's error)^2, and fills
 * `slopes` with its derivative by each value. It is 0 where there are no thresholds.
 */
double FindMisfit(
  const HingeSums& pack, const std::vector<double>& values, std::vector<double>& slopes);
}
