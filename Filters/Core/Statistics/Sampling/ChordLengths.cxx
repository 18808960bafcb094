// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/ChordLengths.h"

#include "ruc/Statistics/Sampling/SecondDifferences.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
// A line is not to be expected to meet more chords of one phase. A power of 2 keeps their counts
// exact.
constexpr double MostChords = 65536.0;

double Positive(double x)
{
  return std::max(x, 0.0);
}
}

ChordLengthSums::ChordLengthSums(int modes, const LagGrid& lags, double longest, double mostLines)
  : Phases(modes + 1)
  , Lags(lags)
  , MostCounts(std::exp2(std::ceil(std::log2(MostChords * mostLines))))
  , Counts(modes + 1, lags.Count + 1, MostCounts, mostLines * longest * lags.Spacing)
  , Paths(modes + 1, lags.Count + 1, mostLines * longest, mostLines * longest)
  , Ends(modes + 1, 1, MostCounts, mostLines * longest)
{
}

ChordLengthSums::Batch ChordLengthSums::NewBatch() const
{
  const std::size_t lags = this->Lags.Count + 1, phases = this->Phases;
  return { std::vector<double>((phases + 1) * (lags + 1), 0.0),
    std::vector<double>(phases * lags, 0.0), std::vector<double>(lags, 0.0),
    std::vector<double>(phases, 0.0) };
}

void ChordLengthSums::AddLine(const std::vector<PhaseChange>& changes,
  const std::vector<LineInterval>& inside, Batch& batch) const
{
  const int lags = this->Lags.Count;
  const int outside = this->Phases;
  // Adds for every lag the part of an interval from which a step of that lag stays inside
  const auto addPath = [&](double length, int row)
  {
    double* differences = batch.Paths.data() + static_cast<std::size_t>(row) * (lags + 2);
    const double scaled = length / this->Lags.Spacing;
    AddConstant(scaled, differences);
    AddRamp(-1.0, 0.0, differences);
    if (scaled <= lags)
    {
      AddRamp(1.0, scaled, differences);
    }
  };
  for (const LineInterval& interval : inside)
  {
    const double length = interval.End - interval.Begin;
    addPath(length, outside);
    double left = length; // (l - z)+ at the lower end of the bin
    for (int k = 0; k <= lags && left > 0.0; ++k)
    {
      const double after = Positive(length - (k + 0.5) * this->Lags.Spacing);
      batch.Opportunity[k] += 0.5 * (left * left - after * after);
      left = after;
    }
  }
  for (std::size_t i = 0; i + 1 < changes.size(); ++i)
  {
    const int phase = changes[i].After;
    if (phase == outside)
    {
      continue;
    }
    const double length = changes[i + 1].Position - changes[i].Position;
    addPath(length, phase);
    const bool begins = changes[i].Before != outside, ends = changes[i + 1].After != outside;
    batch.Ends[phase] += 0.5 * (begins + ends);
    const double bin = std::floor(length / this->Lags.Spacing + 0.5);
    if (begins && ends && bin <= lags)
    {
      batch.Counts[static_cast<std::size_t>(phase) * (lags + 1) + static_cast<int>(bin)] += 1.0;
    }
  }
}

void ChordLengthSums::AddBatch(Batch& batch)
{
  const std::size_t lags = this->Lags.Count + 1;
  double* lines = batch.Paths.data() + this->Phases * (lags + 1);
  Integrate(this->Lags.Spacing, this->Lags.Count, lines);
  this->Paths.AddBatch(lines);
  this->Counts.AddBatch(batch.Opportunity.data());
  this->Ends.AddBatch(lines);
  for (double& count : batch.Counts)
  {
    count = std::min(count, this->MostCounts);
  }
  for (int r = 0; r < this->Phases; ++r)
  {
    double* path = batch.Paths.data() + r * (lags + 1);
    Integrate(this->Lags.Spacing, this->Lags.Count, path);
    this->Paths.AddRow(r, path, lines);
    this->Counts.AddRow(r, batch.Counts.data() + r * lags, batch.Opportunity.data());
    batch.Ends[r] = std::min(batch.Ends[r], this->MostCounts);
    this->Ends.AddRow(r, &batch.Ends[r], lines);
  }
  for (std::vector<double>* values :
    { &batch.Paths, &batch.Counts, &batch.Opportunity, &batch.Ends })
  {
    std::fill(values->begin(), values->end(), 0.0);
  }
}

ChordLengths ChordLengthSums::Result() const
{
  ChordLengths result;
  result.Lags = this->Lags;
  const std::vector<double> zeros(this->Lags.Count + 1, 0.0);
  for (std::vector<std::vector<double>>* functions :
    { &result.Density, &result.DensityError, &result.LinealPath, &result.LinealPathError })
  {
    functions->assign(this->Phases, zeros);
  }
  for (int r = 0; r < this->Phases; ++r)
  {
    const double perLength = this->Ends.Ratio(r, 0);
    const double chords = perLength > 0.0 ? perLength : std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k <= this->Lags.Count; ++k)
    {
      result.Density[r][k] = this->Counts.Ratio(r, k) / chords;
      result.DensityError[r][k] = this->Counts.Error(r, k) / chords;
      result.LinealPath[r][k] = this->Paths.Ratio(r, k);
      result.LinealPathError[r][k] = this->Paths.Error(r, k);
    }
    result.MeanChord.push_back(result.LinealPath[r][0] / chords);
  }
  return result;
}
}
