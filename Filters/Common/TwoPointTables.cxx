// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TwoPointTables.h"

#include "PackData.h"

#include "vtkTable.h"

#include <cstddef>

namespace TwoPointTables
{
namespace
{
using ruc::TwoPointProbability;

// Calls visit(pair, "1_2") for every unordered pair of phases, in the order of the functions
template <class Visit>
void ForEachPair(const TwoPointProbability& probability, Visit&& visit)
{
  for (int r = 0; r < probability.Phases(); ++r)
  {
    for (int s = r; s < probability.Phases(); ++s)
    {
      visit(probability.PairOf(r, s), probability.PhaseName(r) + "_" + probability.PhaseName(s));
    }
  }
}

void AddPairs(const TwoPointProbability& probability,
  const std::vector<std::vector<double>>& values, const std::string& prefix,
  const std::string& suffix, vtkTable* table)
{
  ForEachPair(probability,
    [&](int pair, const std::string& name)
    { PackData::AddColumn(table, prefix + name + suffix, values[pair]); });
}
}

void FillProbabilities(const ruc::SampledTwoPoint& measured, vtkTable* table)
{
  PackData::AddLags(table, measured.Mean.Lags);
  AddPairs(measured.Mean, measured.Mean.Values, "S_", "", table);
  if (!measured.Errors.empty())
  {
    AddPairs(measured.Mean, measured.Errors, "S_", "_error", table);
  }
}

void FillChecks(const TwoPointProbability& probability,
  const std::vector<ruc::TwoPointCheck>& checks, const std::vector<double>& asymmetry,
  vtkTable* table)
{
  std::vector<std::string> pair;
  std::vector<double> limit, zero, infinity, saturation;
  ForEachPair(probability, [&](int, const std::string& name) { pair.push_back("S_" + name); });
  for (const ruc::TwoPointCheck& check : checks)
  {
    limit.push_back(check.Limit);
    zero.push_back(check.ErrorAtZero);
    infinity.push_back(check.ErrorAtInfinity);
    saturation.push_back(check.SaturationLength);
  }
  PackData::AddColumn(table, "Pair", pair);
  PackData::AddColumn(table, "Limit", limit);
  if (asymmetry.empty())
  {
    PackData::AddColumn(table, "ErrorAtZero", zero);
  }
  PackData::AddColumn(table, "ErrorAtInfinity", infinity);
  if (!asymmetry.empty())
  {
    PackData::AddColumn(table, "Asymmetry", asymmetry);
  }
  PackData::AddColumn(table, "SaturationLength", saturation);
}

void FillGradients(const TwoPointProbability& probability, vtkTable* table)
{
  std::vector<std::vector<double>> gradients;
  for (const std::vector<double>& values : probability.Values)
  {
    gradients.push_back(ruc::Gradient(values, probability.Lags.Spacing));
  }
  PackData::AddLags(table, probability.Lags);
  AddPairs(probability, gradients, "S_", "", table);
}

void FillIsotropy(const ruc::DirectionalProbability& directional, vtkTable* table)
{
  const TwoPointProbability& first = directional.Values.front();
  PackData::AddLags(table, first.Lags);
  AddPairs(first, ruc::IsotropyDeviation(directional), "sigma_S_", "", table);
  if (!directional.Errors.empty())
  {
    AddPairs(first, ruc::IsotropyNoise(directional), "sigma_S_", "_noise", table);
  }
}

void FillDirections(const ruc::DirectionalProbability& directional, vtkTable* table)
{
  const TwoPointProbability& first = directional.Values.front();
  const std::size_t lags = first.Lags.Count + 1;
  std::vector<long long> number;
  std::vector<double> nx, ny, nz, r;
  for (std::size_t d = 0; d < directional.Directions.size(); ++d)
  {
    const ruc::Vector3& n = directional.Directions[d];
    for (std::size_t k = 0; k < lags; ++k)
    {
      number.push_back(static_cast<long long>(d));
      nx.push_back(n[0]);
      ny.push_back(n[1]);
      nz.push_back(n[2]);
      r.push_back(k * first.Lags.Spacing);
    }
  }
  PackData::AddColumn(table, "Direction", number);
  PackData::AddColumn(table, "nx", nx);
  PackData::AddColumn(table, "ny", ny);
  PackData::AddColumn(table, "nz", nz);
  PackData::AddColumn(table, "r", r);
  const auto add = [&](const std::string& suffix, const auto& valuesOf)
  {
    ForEachPair(first,
      [&](int pair, const std::string& name)
      {
        std::vector<double> column;
        for (std::size_t d = 0; d < directional.Directions.size(); ++d)
        {
          const std::vector<double>& values = valuesOf(d)[pair];
          column.insert(column.end(), values.begin(), values.end());
        }
        PackData::AddColumn(table, "S_" + name + suffix, column);
      });
  };
  add(
    "", [&](std::size_t d) -> const auto& { return directional.Values[d].Values; });
  if (!directional.Errors.empty())
  {
    add(
      "_error", [&](std::size_t d) -> const auto& { return directional.Errors[d]; });
  }
}

void FillChordLengths(const ruc::ChordLengths& chords, vtkTable* table)
{
  PackData::AddLags(table, chords.Lags);
  const auto add =
    [&](const std::string& prefix, const std::string& suffix, const auto& valuesOfPhases)
  {
    for (std::size_t phase = 0; phase < valuesOfPhases.size(); ++phase)
    {
      const std::string name =
        phase + 1 < valuesOfPhases.size() ? std::to_string(phase + 1) : std::string("m");
      PackData::AddColumn(table, prefix + name + suffix, valuesOfPhases[phase]);
    }
  };
  add("p_", "", chords.Density);
  add("L_", "", chords.LinealPath);
  add("p_", "_error", chords.DensityError);
  add("L_", "_error", chords.LinealPathError);
  PackData::AddField(table, "MeanChordLength", chords.MeanChord);
}

void FillRadialDistribution(const ruc::RadialDistribution& distribution, vtkTable* table)
{
  PackData::AddLags(table, distribution.Lags);
  for (int r = 0; r < distribution.Modes; ++r)
  {
    for (int s = r; s < distribution.Modes; ++s)
    {
      PackData::AddColumn(table, "g_" + std::to_string(r + 1) + "_" + std::to_string(s + 1),
        distribution.Values[distribution.PairOf(r, s)]);
    }
  }
  PackData::AddColumn(table, "g", distribution.Total);
}

void FillAutocovariance(const TwoPointProbability& probability, vtkTable* table)
{
  std::vector<std::vector<double>> values = probability.Values;
  for (int r = 0; r < probability.Phases(); ++r)
  {
    for (int s = r; s < probability.Phases(); ++s)
    {
      for (double& value : values[probability.PairOf(r, s)])
      {
        value -= probability.Fractions[r] * probability.Fractions[s];
      }
    }
  }
  PackData::AddLags(table, probability.Lags);
  AddPairs(probability, values, "chi_", "", table);
}
}
