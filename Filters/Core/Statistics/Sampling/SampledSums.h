// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace ruc
{
/** S_rs by sampling, with its standard errors, which are absolute probabilities as S_rs is. */
struct SampledTwoPoint
{
  /** The estimate; its Fractions are S_rr(0). */
  TwoPointProbability Mean;
  /** Standard errors, in the layout of Mean.Values. */
  std::vector<std::vector<double>> Errors;
  /** Standard errors of Mean.Fractions. */
  std::vector<double> FractionErrors;
  /** For every pair || C_rs / D - C_sr / D || over the mean of the two norms, as in equation (9)
   * but for the divisor; 0 for r = s. */
  std::vector<double> Asymmetry;
  /** The number of lines or throws taken. */
  std::int64_t Samples = 0;
  /** The sum over all N^2 ordered pairs of the discrete norm of Errors (k = 1…K); for K = 0 the sum
   * of FractionErrors. */
  double TotalError = 0.0;
  /** Whether sampling was stopped before there were as many samples as wanted. */
  bool Stopped = false;
};

/** Settings of all methods that sample S_rs. */
struct SamplingSettings
{
  std::uint32_t Seed = 1;
  /** The number of lines or throws, from 1 to 2^31. It is ignored when TargetError > 0. */
  std::int64_t Samples = 0;
  /** Where this is > 0, samples are added until TotalError <= TargetError. */
  double TargetError = 0.0;
};

/**
 * A function that is told the share that is done, also in words, on the calling thread, and returns
 * whether to go on. When any rank says no, sampling ends on all ranks with the samples taken by
 * then.
 */
using SamplingProgress = std::function<bool(double done, const std::string& text)>;

/**
 * A table of ratio estimates R = sum N / sum D over B batches of samples, with their standard
 * errors
 *
 *     sqrt(B / (B - 1) sum_b (N_b - R D_b)^2) / sum D.
 *
 * All numerators of a column share its denominator.
 *
 * Sums are integers, so that they are equal for any number of ranks and threads: n = N /
 * NumeratorMost and d = D / DenominatorMost, which are at most 1 in magnitude (to rounding), and
 * n^2, d^2 and n d are each rounded to a multiple of 2^-s. With up to B batches in all, s is the
 * lesser of 50 and 62 - ceil(log2 B), so that no sum exceeds 2^62 (1 + 1e-9) in units of 2^-s, and
 * no single number 2^51. The resolution is 9e-16 up to 4096 batches, and 1.5e-11 with 2^26 (2^31
 * samples in batches of 32), where the mean of the rounding errors is below 1e-14. A standard error
 * is lost in rounding where the batches vary by less than about 1e-7 of the greatest value that a
 * batch may have.
 */
class SampledRatios
{
public:
  /** With `withSecond`, rows have a second numerator, of which only the ratio is wanted. */
  SampledRatios(std::size_t rows, std::size_t columns, double numeratorMost, double denominatorMost,
    bool withSecond = false);

  std::size_t Columns() const { return this->Denominator.size(); }

  /**
   * A round of sampling. Between the two calls batches are added, on the ranks in any way, up to
   * `batches` in all rounds together. After EndRound, which is collective, every rank has the sums
   * of all.
   */
  void BeginRound(const Communicator& communicator, std::int64_t batches);
  void EndRound(Communicator& communicator);

  /**
   * AddBatch adds a batch by its denominators, one for each column. AddRow adds a row of the same
   * batch, with the same denominators; rows that are all 0 may be left out. Both may run
   * concurrently.
   */
  void AddBatch(const double* denominators);
  void AddRow(std::size_t row, const double* numerators, const double* denominators,
    const double* second = nullptr);

  /**
   * The estimate, which is NaN where sum D = 0, and its standard error, which is NaN there and for
   * B < 2.
   */
  double Ratio(std::size_t row, std::size_t column) const;
  double Error(std::size_t row, std::size_t column) const;
  double SecondRatio(std::size_t row, std::size_t column) const;

private:
  double RatioOf(std::int64_t numerator, std::size_t column) const;

  double NumeratorMost, DenominatorMost;
  int Bits = 50; // s of the class comment
  std::vector<std::int64_t> Batches = { 0 };
  std::vector<std::int64_t> Denominator, DenominatorSquared;              // columns
  std::vector<std::int64_t> Numerator, NumeratorSquared, Product, Second; // rows x columns
  std::array<std::mutex, 64> Locks;                                       // of the rows, in turn
};

/** The sums over batches behind a SampledTwoPoint. */
class SampledSums
{
public:
  /** `most` is an upper bound of every C_rs of a batch, and of their sum. */
  SampledSums(int modes, const LagGrid& lags, double most);

  /**
   * Adds a batch. `rows` has an entry for every ordered pair of phases, at r (modes + 1) + s: C_rs
   * for all K + 1 lags, the measure of those x with x in phase r and x + r_k n in phase s, or a
   * null pointer where all are 0. The denominator D is the sum over all pairs. May run
   * concurrently.
   */
  void AddBatch(const std::vector<const double*>& rows);

  SampledRatios& GetRatios() { return this->Ratios; }

  /**
   * Returns S_rs = (C_rs + C_sr) / (2 D). Values are NaN at lags without a pair of points; errors
   * are NaN there and where there are fewer than two batches. `Samples` is left to the caller.
   */
  SampledTwoPoint Result() const;

private:
  int Modes;
  LagGrid Lags;
  SampledRatios Ratios; // with a row for each pair, whose second numerator is C_rs, r < s
};

/** What a method calls its samples. */
struct SampleNames
{
  const char* Property; // "NumberOfLines"
  const char* Noun;     // "lines"
};

/**
 * Throws std::invalid_argument, in the words of the filters' properties, for settings or lags that
 * cannot be sampled.
 */
void CheckSampling(const SamplingSettings& settings, const SampleNames& names, int modes,
  const LagGrid& lags, const SamplingRegion& region);

/**
 * A number of samples is divided into this many batches, or into more where a batch may not hold as
 * many. With a TargetError this many come first.
 */
constexpr int FewestBatches = 64;

/**
 * Returns the number of samples in a batch: at most `most`, and exactly that with a TargetError.
 */
int SamplesInBatch(const SamplingSettings& settings, int most);

/** The batches First to End - 1 and their samples. The last of all batches may be shorter. */
struct BatchRange
{
  std::int64_t First, End;
  std::int64_t Samples; // in all batches
  int SamplesInBatch;

  std::int64_t Batches() const // the number of all batches
  {
    return (this->Samples + this->SamplesInBatch - 1) / this->SamplesInBatch;
  }
  std::int64_t FirstSample(std::int64_t batch) const { return batch * this->SamplesInBatch; }
  std::int64_t EndSample(std::int64_t batch) const
  {
    return std::min(this->Samples, (batch + 1) * this->SamplesInBatch);
  }
};

/**
 * Takes the samples that the settings ask for, `batchesAtOnce` batches at a time, and returns the
 * result. `take` adds this rank's batches of a range to `sums`, and to the `others` that go along.
 * With a TargetError, 64 batches come first. As the error falls with the square root of the number
 * of samples, it then tells how many are needed. Collective.
 *
 * Throws std::invalid_argument when a TargetError is out of reach: for more than 2^31 samples, or
 * at a lag without any pair of points.
 */
SampledTwoPoint TakeSamples(const SamplingSettings& settings, const SampleNames& names,
  int samplesInBatch, int batchesAtOnce, SampledSums& sums,
  const std::vector<SampledRatios*>& others, Communicator& communicator,
  const SamplingProgress& progress, const std::function<void(const BatchRange&)>& take);

/** The seconds that a pair of phases and a lag take in a batch. */
constexpr double SecondsPerBatchEntry = 3.7e-9;
}
