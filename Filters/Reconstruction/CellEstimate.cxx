// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CellEstimate.h"

#include "PackEstimate.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Results/LagLimit.h"

#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// The saturation length over the mean diameter, which is 4 to 6 for dense packs
constexpr double TypicalSaturation = 5.0;

double TwoDigits(double value)
{
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / digit) * digit;
}

// Returns the number of spheres of a cell, which has the `edge` if no number of spheres is given
double FindSpheres(const CellProperties& properties, double density, double edge)
{
  if (!properties.ModeCounts.empty())
  {
    return std::accumulate(properties.ModeCounts.begin(), properties.ModeCounts.end(), 0.0);
  }
  return properties.NumberOfParticles > 0 ? properties.NumberOfParticles
                                          : density * edge * edge * edge;
}

double FindEdge(const ruc::CellFigures& cell)
{
  return std::cbrt(cell.Spheres / cell.Density);
}

std::string DescribeSize(const CellProperties& properties, const ruc::CellFigures& cell)
{
  if (!properties.HasNoCounts())
  {
    return {};
  }
  const std::string number = ruc::Text("Number Of Particles ", TwoDigits(cell.Spheres));
  return properties.CellSize > 0.0 ? number
                                   : ruc::Text(number, ", Cell Size ", TwoDigits(FindEdge(cell)));
}

ruc::Estimate OfSearch(const ruc::CellFigures& cell, const ruc::LagGrid& lags,
  const CellSearch::Settings& search, double longest)
{
  ruc::Estimate estimate = search.IsByPopulation()
    ? ruc::EstimatePopulationSearch(cell, lags, search.FindPopulation())
    : ruc::EstimateGradientSearch(cell, lags, search.Gradient);
  estimate.Seconds = std::min(estimate.Seconds * search.NumberOfCells, longest);
  return estimate;
}
}

ruc::Estimate CellEstimate::OfPack(const ruc::PackFigures& pack, const CellProperties& properties,
  const CellSearch::Settings& search, double longestSearch)
{
  ruc::Estimate estimate = ruc::EstimatePack(pack);
  double edge = properties.CellSize;
  if (properties.HasNoCounts() && edge == 0.0)
  {
    const ruc::LagLimit limit = ruc::LagLimit::ForPairSum(pack.Observed, pack.LargestRadius);
    estimate += ruc::EstimatePairSum(pack, limit.MakeGrid(0.0, properties.NumberOfLags));
    edge = 2.0 * std::min(limit.Automatic, TypicalSaturation * pack.MeanDiameter);
  }
  const double density = pack.Density();
  ruc::CellFigures cell = { FindSpheres(properties, density, edge), density, pack.LargestRadius,
    pack.Modes, pack.ModeRadius, pack.ModeShare };
  if (!properties.ModeDiameters.empty())
  {
    cell.Radius.clear();
    for (double diameter : properties.ModeDiameters)
    {
      cell.Radius.push_back(0.5 * diameter);
    }
  }
  if (properties.DiametersPerMode != 1)
  {
    cell = cell.Divided(properties.DiametersPerMode);
    // All radii of a mode, on every rank, and those of all ranks before
    estimate.MegabytesOfRank += 2.0 * sizeof(double) * pack.Spheres / ruc::BytesOfMegabyte;
  }
  estimate.Automatic = DescribeSize(properties, cell);
  const ruc::LagGrid lags =
    ruc::LagLimit::ForCell(FindEdge(cell)).MakeGrid(properties.MaximumLag, properties.NumberOfLags);
  if (properties.MaximumLag == 0.0)
  {
    estimate.Automatic +=
      ruc::Text(estimate.Automatic.empty() ? "" : ", ", "Maximum Lag ", TwoDigits(lags.Maximum()));
  }
  estimate += ruc::EstimatePairSum(pack, lags);
  const ruc::NeighbourTarget& neighbours = search.Gradient.Neighbours;
  if (!search.IsByPopulation() && neighbours.ContactWeight + neighbours.PoreWeight > 0.0)
  {
    estimate += ruc::EstimateNeighbourSums(pack);
  }
  if (!search.IsByPopulation() && neighbours.SpectrumWeight > 0.0)
  {
    estimate += ruc::EstimateSpectrum(pack);
  }
  if (!search.IsByPopulation() && neighbours.ThirdOrderWeight > 0.0)
  {
    estimate += ruc::EstimateNeighbourhoods(pack, search.Gradient.ThirdOrder);
  }
  estimate += OfSearch(cell, lags, search, longestSearch);
  return estimate;
}

double CellEstimate::MegabytesOf(
  const ruc::CellContents& contents, const ruc::LagGrid& lags, const CellSearch::Settings& search)
{
  return OfSearch(ruc::FiguresOf(contents), lags, search, 0.0).MegabytesOfRank;
}

std::optional<ruc::Estimate> CellEstimate::OfTable(vtkTable* table,
  const CellProperties& properties, const CellSearch::Settings& search, double longestSearch)
{
  ruc::LagGrid lags = { 0.0, 0 };
  std::optional<ruc::CellFigures> cell =
    PackEstimate::FindCellFigures(table, properties.ModeDiameters, lags);
  if (!cell)
  {
    return {};
  }
  cell->Spheres = FindSpheres(properties, cell->Density,
    properties.CellSize > 0.0 ? properties.CellSize : 2.0 * lags.Maximum());
  ruc::Estimate estimate;
  estimate.Automatic = DescribeSize(properties, *cell);
  estimate += OfSearch(*cell, lags, search, longestSearch);
  return estimate;
}
