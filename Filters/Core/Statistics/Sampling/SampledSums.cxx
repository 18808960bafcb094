// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/SampledSums.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int FewestSamples = 2;
constexpr double MostSamples = 2147483648.0;

RUC_VECTOR_CLONES
void AddFixedPoint(
  const double* values, double factor, std::size_t count, double unit, std::int64_t* sums)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    sums[k] += RoundToFixedPoint(factor * values[k] * unit);
  }
}

RUC_VECTOR_CLONES
void AddFixedPointProducts(const double* a, double factorA, const double* b, double factorB,
  std::size_t count, double unit, std::int64_t* sums)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    sums[k] += RoundToFixedPoint((factorA * a[k]) * (factorB * b[k]) * unit);
  }
}
}

SampledRatios::SampledRatios(std::size_t rows, std::size_t columns, double numeratorMost,
  double denominatorMost, bool withSecond)
  : NumeratorMost(numeratorMost)
  , DenominatorMost(denominatorMost)
  , Denominator(columns, 0)
  , DenominatorSquared(columns, 0)
  , Numerator(rows * columns, 0)
  , NumeratorSquared(rows * columns, 0)
  , Product(rows * columns, 0)
  , Second(withSecond ? rows * columns : 0, 0)
{
}

void SampledRatios::BeginRound(const Communicator& communicator, std::int64_t batches)
{
  int bits = 50;
  while (bits > 0 && (batches - 1) >> (62 - bits) > 0)
  {
    --bits;
  }
  const int drop = std::max(this->Bits - bits, 0);
  this->Bits -= drop;
  for (std::vector<std::int64_t>* sums : { &this->Denominator, &this->DenominatorSquared,
         &this->Numerator, &this->NumeratorSquared, &this->Product, &this->Second })
  {
    for (std::int64_t& sum : *sums)
    {
      // Only rank 0 goes on from the sums that all ranks have in common.
      sum = communicator.Rank() != 0 ? 0 : drop > 0 ? ((sum >> (drop - 1)) + 1) >> 1 : sum;
    }
  }
  if (communicator.Rank() != 0)
  {
    this->Batches = { 0 };
  }
}

void SampledRatios::EndRound(Communicator& communicator)
{
  for (std::vector<std::int64_t>* sums :
    { &this->Batches, &this->Denominator, &this->DenominatorSquared, &this->Numerator,
      &this->NumeratorSquared, &this->Product, &this->Second })
  {
    communicator.Sum(sums->data(), sums->size());
  }
}

void SampledRatios::AddBatch(const double* denominators)
{
  const std::lock_guard<std::mutex> guard(this->Locks[0]);
  const double unit = std::ldexp(1.0, this->Bits), factor = 1.0 / this->DenominatorMost;
  const std::size_t columns = this->Columns();
  ++this->Batches[0];
  AddFixedPoint(denominators, factor, columns, unit, this->Denominator.data());
  AddFixedPointProducts(
    denominators, factor, denominators, factor, columns, unit, this->DenominatorSquared.data());
}

void SampledRatios::AddRow(
  std::size_t row, const double* numerators, const double* denominators, const double* second)
{
  const std::lock_guard<std::mutex> guard(this->Locks[row % this->Locks.size()]);
  const double unit = std::ldexp(1.0, this->Bits), factor = 1.0 / this->NumeratorMost;
  const std::size_t columns = this->Columns(), first = row * columns;
  AddFixedPoint(numerators, factor, columns, unit, &this->Numerator[first]);
  AddFixedPointProducts(
    numerators, factor, numerators, factor, columns, unit, &this->NumeratorSquared[first]);
  AddFixedPointProducts(numerators, factor, denominators, 1.0 / this->DenominatorMost, columns,
    unit, &this->Product[first]);
  if (second)
  {
    AddFixedPoint(second, factor, columns, unit, &this->Second[first]);
  }
}

double SampledRatios::RatioOf(std::int64_t numerator, std::size_t column) const
{
  const std::int64_t denominator = this->Denominator[column];
  return denominator > 0 ? this->NumeratorMost / this->DenominatorMost *
      (static_cast<double>(numerator) / static_cast<double>(denominator))
                         : NotANumber;
}

double SampledRatios::Ratio(std::size_t row, std::size_t column) const
{
  return this->RatioOf(this->Numerator[row * this->Columns() + column], column);
}

double SampledRatios::SecondRatio(std::size_t row, std::size_t column) const
{
  return this->RatioOf(this->Second[row * this->Columns() + column], column);
}

double SampledRatios::Error(std::size_t row, std::size_t column) const
{
  const double batches = static_cast<double>(this->Batches[0]);
  const double denominator = static_cast<double>(this->Denominator[column]);
  if (batches < 2.0 || !(denominator > 0.0))
  {
    return NotANumber;
  }
  const std::size_t n = row * this->Columns() + column;
  const double ratio = static_cast<double>(this->Numerator[n]) / denominator;
  const double squares = static_cast<double>(this->NumeratorSquared[n]) -
    2.0 * ratio * static_cast<double>(this->Product[n]) +
    ratio * ratio * static_cast<double>(this->DenominatorSquared[column]);
  const double unit = std::ldexp(1.0, this->Bits);
  return this->NumeratorMost / this->DenominatorMost *
    std::sqrt(std::max(squares, 0.0) * unit * batches / (batches - 1.0)) / denominator;
}

SampledSums::SampledSums(int modes, const LagGrid& lags, double most)
  : Modes(modes)
  , Lags(lags)
  , Ratios(static_cast<std::size_t>(modes + 1) * (modes + 2) / 2, lags.Count + 1, most, most, true)
{
}

void SampledSums::AddBatch(const std::vector<const double*>& rows)
{
  const std::size_t columns = this->Ratios.Columns();
  const std::vector<double> zeros(columns, 0.0);
  std::vector<double> denominators(columns, 0.0), symmetric(columns);
  for (const double* row : rows)
  {
    for (std::size_t k = 0; row && k < columns; ++k)
    {
      denominators[k] += row[k];
    }
  }
  this->Ratios.AddBatch(denominators.data());
  const int phases = this->Modes + 1;
  std::size_t pair = 0;
  for (int r = 0; r < phases; ++r)
  {
    for (int s = r; s < phases; ++s, ++pair)
    {
      const double* rs = rows[static_cast<std::size_t>(r) * phases + s];
      const double* sr = rows[static_cast<std::size_t>(s) * phases + r];
      if (rs || sr)
      {
        rs = rs ? rs : zeros.data();
        sr = sr ? sr : zeros.data();
        for (std::size_t k = 0; k < columns; ++k)
        {
          symmetric[k] = 0.5 * (rs[k] + sr[k]);
        }
        this->Ratios.AddRow(pair, symmetric.data(), denominators.data(), rs);
      }
    }
  }
}

SampledTwoPoint SampledSums::Result() const
{
  SampledTwoPoint result = { TwoPointProbability(this->Modes, this->Lags), {}, {}, {}, 0, 0.0 };
  TwoPointProbability& mean = result.Mean;
  result.Errors = mean.Values;
  result.Asymmetry.assign(mean.Pairs(), 0.0);
  std::vector<double> rs(this->Lags.Count + 1), sr = rs, difference = rs;
  for (int r = 0; r < mean.Phases(); ++r)
  {
    for (int s = r; s < mean.Phases(); ++s)
    {
      const int pair = mean.PairOf(r, s);
      for (int k = 0; k <= this->Lags.Count; ++k)
      {
        mean.Values[pair][k] = this->Ratios.Ratio(pair, k);
        result.Errors[pair][k] = this->Ratios.Error(pair, k);
        rs[k] = this->Ratios.SecondRatio(pair, k);
        sr[k] = 2.0 * mean.Values[pair][k] - rs[k];
        difference[k] = rs[k] - sr[k];
      }
      const double norms = DiscreteNorm(rs) + DiscreteNorm(sr);
      if (r != s && norms != 0.0)
      {
        result.Asymmetry[pair] = DiscreteNorm(difference) / (0.5 * norms);
      }
      result.TotalError += (r == s ? 1.0 : 2.0) * DiscreteNorm(result.Errors[pair]);
    }
    mean.Fractions[r] = mean.S(r, r)[0];
    result.FractionErrors.push_back(result.Errors[mean.PairOf(r, r)][0]);
  }
  if (this->Lags.Count == 0)
  {
    for (double error : result.FractionErrors)
    {
      result.TotalError += error;
    }
  }
  return result;
}

void CheckSampling(const SamplingSettings& settings, const SampleNames& names, int modes,
  const LagGrid& lags, const SamplingRegion& region)
{
  Require(settings.TargetError >= 0.0 && std::isfinite(settings.TargetError), "TargetError",
    "a finite number >= 0", settings.TargetError);
  if (settings.TargetError == 0.0 && settings.Samples < FewestSamples)
  {
    throw std::invalid_argument(Text(names.Property, " requires a number >= ", FewestSamples,
      ", without which no standard error is known, got ", settings.Samples, "."));
  }
  if (settings.TargetError == 0.0 && settings.Samples > static_cast<std::int64_t>(MostSamples))
  {
    throw std::invalid_argument(Text(names.Property, " requires a number <= ",
      static_cast<std::int64_t>(MostSamples), ", got ", settings.Samples, "."));
  }
  if (lags.Count != 0)
  {
    CheckNumberOfLags(modes, lags);
  }
  if (lags.Count > 0)
  {
    LagLimit::ForSampling(region.GetShape(), region.GetShape()).Check(lags);
  }
}

int SamplesInBatch(const SamplingSettings& settings, int most)
{
  return settings.TargetError > 0.0
    ? most
    : static_cast<int>(
        std::clamp<std::int64_t>((settings.Samples + FewestBatches - 1) / FewestBatches, 1, most));
}

namespace
{
// Takes the batches of a round that are not taken yet. Returns false where it was stopped;
// range.Samples are then those taken so far. `expected` is the number of samples in all rounds.
bool TakeRound(BatchRange& range, int batchesAtOnce, double expected, const SampleNames& names,
  Communicator& communicator, const SamplingProgress& progress,
  const std::function<void(const BatchRange&)>& take)
{
  const std::int64_t batches = range.Batches();
  while (range.End < batches)
  {
    range.First = range.End;
    range.End = std::min(batches, range.First + batchesAtOnce);
    take(range);
    const std::int64_t taken = range.EndSample(range.End - 1);
    if (!communicator.All(
          !progress || progress(std::min(taken / expected, 1.0), Text(taken, " ", names.Noun))))
    {
      range.Samples = taken;
      return false;
    }
  }
  return true;
}

// How many samples the target takes, judged by the samples taken so far
double SamplesForTarget(const SampledTwoPoint& result, double targetError, const SampleNames& names)
{
  for (int k = 0; k <= result.Mean.Lags.Count; ++k)
  {
    if (std::isnan(result.Mean.Values[0][k]))
    {
      throw std::invalid_argument(
        Text("TargetError requires pairs of points at every lag, got none at ",
          k * result.Mean.Lags.Spacing, " on ", result.Samples, " ", names.Noun, "."));
    }
  }
  const double ratio = result.TotalError / targetError;
  const double expected = result.Samples * ratio * ratio;
  if (!(expected <= MostSamples))
  {
    throw std::invalid_argument(Text("TargetError requires at least about ",
      result.TotalError * std::sqrt(result.Samples / MostSamples), ", got ", targetError, "."));
  }
  return expected;
}
}

SampledTwoPoint TakeSamples(const SamplingSettings& settings, const SampleNames& names,
  int samplesInBatch, int batchesAtOnce, SampledSums& sums,
  const std::vector<SampledRatios*>& others, Communicator& communicator,
  const SamplingProgress& progress, const std::function<void(const BatchRange&)>& take)
{
  std::vector<SampledRatios*> tables = others;
  tables.push_back(&sums.GetRatios());
  const bool aimed = settings.TargetError > 0.0;
  BatchRange range = { 0, 0, settings.Samples, samplesInBatch };
  double expected = static_cast<double>(settings.Samples);
  if (aimed)
  {
    range.Samples = std::int64_t(FewestBatches) * range.SamplesInBatch;
    expected = std::numeric_limits<double>::infinity();
  }
  for (;;)
  {
    for (SampledRatios* table : tables)
    {
      table->BeginRound(communicator, range.Batches());
    }
    const bool finished =
      TakeRound(range, batchesAtOnce, expected, names, communicator, progress, take);
    for (SampledRatios* table : tables)
    {
      table->EndRound(communicator);
    }
    SampledTwoPoint result = sums.Result();
    result.Samples = range.Samples;
    result.Stopped = !finished;
    if (!aimed || !finished || result.TotalError <= settings.TargetError)
    {
      return result;
    }
    expected = SamplesForTarget(result, settings.TargetError, names);
    // Early errors are themselves uncertain, so a round goes neither too far at once nor in too
    // small steps
    const double next = std::clamp(1.02 * expected, 1.05 * range.Samples, 8.0 * range.Samples);
    range.Samples = range.SamplesInBatch *
      static_cast<std::int64_t>(std::ceil(std::min(next, MostSamples) / range.SamplesInBatch));
  }
}
}
