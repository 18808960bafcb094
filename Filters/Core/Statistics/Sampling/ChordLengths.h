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
 * Chord-length functions of every phase (modes from 0, the matrix last), at the lags r_k. A chord
 * is a longest interval of a line in one phase. L is the length of the lines in the region, pooled.
 *
 * Density: chord-length probability density p_r(r_k), in 1 / length, the mean over the bin of width
 * Spacing around r_k (half of that at r_0). It counts chords with both ends inside, and corrects
 * for those a line of finite length cannot hold: their number per length is sum of chords in bin /
 * (integral over bin of sum of (l - z)+), l the lengths of the lines; divided by the number of
 * chords per length. Its standard error takes the latter as exact.
 * LinealPath: lineal-path function L_r(r_k), the probability that a segment of length r_k lies in
 * phase r: sum of (c - r_k)+ over all chords, cut ones included / sum of (l - r_k)+. L_r(0) = c_r.
 * MeanChord: c_r / (number of chords per length), the latter from the ends of chords inside,
 * halved; unbiased, unlike a mean over chords with both ends inside. NaN without any end, as is
 * Density.
 */
struct ChordLengths
{
  LagGrid Lags{};
  std::vector<std::vector<double>> Density, DensityError, LinealPath, LinealPathError;
  std::vector<double> MeanChord;
};

/** The sums over batches of lines behind ChordLengths; at least one lag. */
class ChordLengthSums
{
public:
  /** No line is longer than `longest`, no batch has more than `mostLines`. */
  ChordLengthSums(int modes, const LagGrid& lags, double longest, double mostLines);

  /** What one batch adds up, on one thread. */
  struct Batch
  {
    std::vector<double> Paths;       // (phases + 1) x (K + 2), the lines themselves last
    std::vector<double> Counts;      // phases x (K + 1): chords with both ends inside
    std::vector<double> Opportunity; // K + 1: integral over the bin of sum of (l - z)+
    std::vector<double> Ends;        // phases: ends of chords inside, halved
  };
  Batch NewBatch() const;
  void AddLine(const std::vector<PhaseChange>& changes, const std::vector<LineInterval>& inside,
    Batch& batch) const;
  /** Empties the batch. Safe to be called concurrently. */
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
