// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonTables.h"

#include "PackData.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}
}

void ComparisonTables::Rows::Add(const std::string& quantity, double pack, double cell,
  double difference, double largest, double percent, double deviation)
{
  this->Quantity.push_back(quantity);
  const double numbers[] = { pack, cell, difference, largest, percent, deviation };
  for (int n = 0; n < 6; ++n)
  {
    this->Numbers[n].push_back(numbers[n]);
  }
}

void ComparisonTables::Rows::Fill(vtkTable* table, bool withDeviations) const
{
  const char* names[] = { "Pack", "Cell", "Difference", "LargestDifference", "Percent",
    "StandardDeviation" };
  PackData::AddColumn(table, "Quantity", this->Quantity);
  for (int n = 0; n < (withDeviations ? 6 : 5); ++n)
  {
    PackData::AddColumn(table, names[n], this->Numbers[n]);
  }
}

double ComparisonTables::Percent(double difference, double pack, double cell)
{
  const double mean = 0.5 * (pack + cell);
  return mean > 0.0 ? difference / mean * 100.0 : 0.0;
}

void ComparisonTables::FillComparison(const ruc::TwoPointProbability& pack,
  const ruc::MeanProbability& cells, bool several, vtkTable* table)
{
  Rows rows;
  const ruc::TwoPointProbability& cell = cells.Mean;
  const ruc::ProbabilityComparison comparison = ruc::CompareProbabilities(pack, cell);
  for (int phase = 0; phase < pack.Phases(); ++phase)
  {
    const double a = pack.Fractions[phase], b = cell.Fractions[phase];
    const double difference = std::abs(a - b);
    rows.Add("c_" + pack.PhaseName(phase), a, b, difference, difference,
      phase < pack.Modes ? comparison.FractionPercent[phase] : Percent(difference, a, b),
      cells.FractionDeviations[phase]);
  }
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 }, largest = 0.0;
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = r; s < pack.Phases(); ++s)
    {
      const double norms[] = { ruc::DiscreteNorm(pack.S(r, s)), ruc::DiscreteNorm(cell.S(r, s)),
        ruc::NormOfDifference(pack.S(r, s), cell.S(r, s)),
        ruc::DiscreteNorm(cells.Deviations[pack.PairOf(r, s)]) };
      const double most = LargestDifference(pack.S(r, s), cell.S(r, s));
      rows.Add(PackData::PairName(pack, r, s), norms[0], norms[1], norms[2], most,
        Percent(norms[2], norms[0], norms[1]), norms[3]);
      for (int n = 0; n < 4; ++n)
      {
        sums[n] += (r == s ? 1.0 : 2.0) * norms[n];
      }
      largest = std::max(largest, most);
    }
  }
  rows.Add("all", sums[0], sums[1], sums[2], largest, comparison.Percent, sums[3]);
  rows.Fill(table, several);
}

void ComparisonTables::FillCurves(const ruc::TwoPointProbability& pack,
  const ruc::MeanProbability& cells, bool several, vtkTable* table)
{
  PackData::AddLags(table, pack.Lags);
  for (int r = 0; r < pack.Phases(); ++r)
  {
    for (int s = r; s < pack.Phases(); ++s)
    {
      const std::string name = PackData::PairName(pack, r, s);
      const std::vector<double>&a = pack.S(r, s), &b = cells.Mean.S(r, s);
      std::vector<double> difference(a.size());
      std::transform(a.begin(), a.end(), b.begin(), difference.begin(), std::minus<>());
      PackData::AddColumn(table, name + "_pack", a);
      PackData::AddColumn(table, name + "_cell", b);
      PackData::AddColumn(table, name + "_difference", difference);
      if (several)
      {
        PackData::AddColumn(table, name + "_deviation", cells.Deviations[pack.PairOf(r, s)]);
      }
    }
  }
}
