// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Statistics/Sampling/SampledSums.h"
#include "ruc/Tracing/PhaseChanges.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Chord-length functions of every phase (modes from 0, the matrix last), at the lags r_k, pooled
 * over all lines. A chord is a longest interval of a line in one phase (Torquato, Random
 * Heterogeneous Materials, Springer 2002, chapter 2). Errors are standard errors in the unit of
 * their function.
 *
 * Density is the chord-length probability density p_r(r_k), in 1 / length: its mean over the bin of
 * width Spacing around r_k (half of that at r_0). It counts chords with both ends inside, and
 * corrects for those that a line of finite length cannot hold. The number of such chords per length
 * is the sum of chords in the bin over the integral over the bin of the sum of (l - z)+, where l
 * are the lengths of the lines; it is divided by the number of all chords per length. The standard
 * error takes this divisor as exact.
 *
 * LinealPath is the lineal-path function L_r(r_k), the probability that a segment of length r_k
 * lies in phase r: the sum of (c - r_k)+ over all chords c, cut ones included, over the sum of (l -
 * r_k)+. L_r(0) = c_r.
 *
 * MeanChord is c_r over the number of chords per length, which is half the number of ends of chords
 * inside. It is unbiased, unlike a mean over chords with both ends inside. It is NaN where there is
 * no end, and so is Density.
 */
struct ChordLengths
{
  LagGrid Lags{};
  std::vector<std::vector<double>> Density, DensityError, LinealPath, LinealPathError;
  std::vector<double> MeanChord;
};

/** The sums over batches of lines behind ChordLengths. There is at least one lag. */
class ChordLengthSums
{
public:
  /**
   * `longest` is an upper bound of the length of a line, and `mostLines` of the number of lines in
   * a batch.
   */
  ChordLengthSums(int modes, const LagGrid& lags, double longest, double mostLines);

  /** What one batch adds up, on one thread. */
  struct Batch
  {
    /** Second differences of the sum of (c - r)+: (phases + 1) x (K + 2) numbers, of which the last
     * row is for the lines themselves. */
    std::vector<double> Paths;
    /** The number of chords with both ends inside in every bin: phases x (K + 1). */
    std::vector<double> Counts;
    /** The integral over every bin of the sum of (l - z)+: K + 1. */
    std::vector<double> Opportunity;
    /** Half the number of ends of chords inside, for every phase. */
    std::vector<double> Ends;
  };
  Batch NewBatch() const;
  void AddLine(const std::vector<PhaseChange>& changes, const std::vector<LineInterval>& inside,
    Batch& batch) const;
  /** Adds a batch and empties it. May run concurrently. */
  void AddBatch(Batch& batch);

  std::vector<SampledRatios*> GetRatios() { return { &this->Counts, &this->Paths, &this->Ends }; }

  ChordLengths Result() const;

private:
  int Phases;
  LagGrid Lags;
  double MostCounts;
  SampledRatios Counts, Paths, Ends;
};
}
