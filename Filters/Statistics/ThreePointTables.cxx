// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreePointTables.h"

#include "PackData.h"
#include "ruc/Statistics/Results/Phases.h"
#include "ruc/Statistics/ThirdOrder/ThreePointLimits.h"

#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
// The rows of the table of checks
struct Checks
{
  std::vector<std::string> Triple, Place, Limit;
  std::vector<double> Difference, StandardError;

  void Add(const std::string& triple, const std::string& place, const std::string& limit,
    double difference, double error)
  {
    this->Triple.push_back(triple);
    this->Place.push_back(place);
    this->Limit.push_back(limit);
    this->Difference.push_back(difference);
    this->StandardError.push_back(error);
  }

  void Fill(vtkTable* table, bool withErrors) const
  {
    PackData::AddColumn(table, "Triple", this->Triple);
    PackData::AddColumn(table, "Place", this->Place);
    PackData::AddColumn(table, "Limit", this->Limit);
    PackData::AddColumn(table, "Difference", this->Difference);
    if (withErrors)
    {
      PackData::AddColumn(table, "StandardError", this->StandardError);
    }
  }
};

// The name of a column, such as "S_3_5_5_r1_axis"
std::string ColumnName(const std::string& triple, std::string place)
{
  std::replace(place.begin(), place.end(), ' ', '_');
  return triple + "_" + place;
}
}

void ThreePointTables::FillLimits(const ruc::ThreePointProbability& probability,
  const ruc::TwoPointProbability& twoPoint, vtkTable* curves, vtkTable* checks)
{
  const ruc::ThreePointGrid& grid = probability.GetGrid();
  const int last = grid.Lags.Count, opposite = grid.Angles() - 1;
  Checks rows;
  PackData::AddLags(curves, grid.Lags);
  for (std::size_t n = 0; n < probability.GetTriples().size(); ++n)
  {
    const ruc::PhaseTriple& phases = probability.GetTriples()[n];
    const std::string triple = ruc::TripleName(phases, probability.GetModes());
    for (const ruc::DegenerateLimit& limit : ruc::FindDegenerateLimits(probability, n, twoPoint))
    {
      const std::string column = ColumnName(triple, limit.Place);
      PackData::AddColumn(curves, column, limit.Values);
      PackData::AddColumn(curves, column + "_limit", limit.Limit);
      if (probability.HasErrors())
      {
        PackData::AddColumn(curves, column + "_error", limit.Errors);
      }
      rows.Add(triple, limit.Place, limit.Expected, limit.Difference(), limit.StandardError());
    }
    const double apart =
      twoPoint.Fractions[phases.R] * twoPoint.Fractions[phases.S] * twoPoint.Fractions[phases.Q];
    const auto c = [&](int phase) { return "c_" + twoPoint.PhaseName(phase); };
    rows.Add(triple, "far apart", c(phases.R) + " " + c(phases.S) + " " + c(phases.Q),
      std::abs(probability.Value(n, last, last, opposite) - apart),
      probability.Error(n, last, last, opposite));
  }
  rows.Fill(checks, probability.HasErrors());
}

std::string ThreePointTables::FillThirdOrder(
  const ruc::ThreePointProbability& probability, vtkTable* table)
{
  std::string unknown;
  std::vector<std::string> phase;
  std::vector<double> fraction, zeta, eta, zetaError, etaError;
  for (std::size_t n = 0; n < probability.GetTriples().size(); ++n)
  {
    const ruc::PhaseTriple& phases = probability.GetTriples()[n];
    if (phases.R != phases.S || phases.S != phases.Q)
    {
      continue;
    }
    const ruc::ThirdOrderParameters parameters = probability.ThirdOrder(n);
    const ruc::ThirdOrderParameters errors = probability.ThirdOrderError(n);
    const double c = probability.Value(n, 0, 0, 0);
    const std::string name = ruc::PhaseName(phases.R, probability.GetModes());
    if (!std::isfinite(parameters.Zeta))
    {
      unknown += (unknown.empty() ? "" : ", ") + name;
    }
    for (bool rest : { false, true })
    {
      phase.push_back(rest ? "all but " + name : name);
      fraction.push_back(rest ? 1.0 - c : c);
      zeta.push_back(rest ? 1.0 - parameters.Zeta : parameters.Zeta);
      eta.push_back(rest ? 1.0 - parameters.Eta : parameters.Eta);
      zetaError.push_back(errors.Zeta);
      etaError.push_back(errors.Eta);
    }
  }
  PackData::AddColumn(table, "Phase", phase);
  PackData::AddColumn(table, "VolumeFraction", fraction);
  PackData::AddColumn(table, "zeta", zeta);
  PackData::AddColumn(table, "eta", eta);
  if (probability.HasErrors())
  {
    PackData::AddColumn(table, "zeta_error", zetaError);
    PackData::AddColumn(table, "eta_error", etaError);
  }
  return unknown;
}

void ThreePointTables::FillMultipoles(
  const ruc::NeighbourhoodMultipoles& multipoles, bool isFirstRank, vtkTable* table)
{
  std::vector<long long> classOfMode, centres(multipoles.Centres.begin(), multipoles.Centres.end());
  for (int ofMode : multipoles.ClassOfMode)
  {
    classOfMode.push_back(ofMode + 1);
  }
  PackData::AddField(table, "ClassOfMode", classOfMode);
  PackData::AddField(table, "NumberOfCentres", centres);
  if (!isFirstRank)
  {
    return;
  }
  const ruc::ShellSettings& shells = multipoles.Shells;
  std::vector<long long> whole[4]; // r, s, q, l
  std::vector<double> first, second;
  const auto addRows = [&](int r, int s, int q, int l)
  {
    for (double one : shells.Distances)
    {
      for (double other : shells.Distances)
      {
        const int values[] = { r + 1, s + 1, q + 1, l };
        for (int column = 0; column < 4; ++column)
        {
          whole[column].push_back(values[column]);
        }
        first.push_back(one);
        second.push_back(other);
      }
    }
  };
  // In the order of NeighbourhoodMultipoles::PlaceOf
  for (int r = 0; r < shells.Classes; ++r)
  {
    for (int s = 0; s < shells.Classes; ++s)
    {
      for (int q = s; q < shells.Classes; ++q)
      {
        for (int l = 0; l <= shells.Degree; ++l)
        {
          addRows(r, s, q, l);
        }
      }
    }
  }
  const char* const names[] = { "r", "s", "q", "l" };
  for (int column = 0; column < 4; ++column)
  {
    PackData::AddColumn(table, names[column], whole[column]);
  }
  PackData::AddColumn(table, "Distance1", first);
  PackData::AddColumn(table, "Distance2", second);
  PackData::AddColumn(table, "T", multipoles.Value);
  PackData::AddColumn(table, "T_error", multipoles.Error);
}
