// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackEstimate.h"

#include "PackData.h"
#include "ruc/Base/Text.h"
#include "ruc/Reconstruction/CellContents.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkTable.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace
{
// This many spheres are enough to know the sizes of all
constexpr vtkIdType MostLookedAt = 20000;

// Returns null where there is no such column with two rows or more
vtkDataArray* FindColumn(vtkTable* table, const std::string& name)
{
  return PackData::FindArray(table->GetRowData(), name.c_str(), 2);
}

ruc::PackFigures FindSizes(vtkDataArray* radius, vtkDataArray* mode, vtkIdType points)
{
  ruc::PackFigures pack;
  double cubes = 0.0, number = 0.0;
  std::set<std::pair<double, double>> types;
  std::map<double, std::pair<double, double>> modes; // number, sum of cubes
  for (vtkIdType i = 0; i < points; i += 1 + points / MostLookedAt)
  {
    const double r = radius->GetTuple1(i);
    pack.MeanRadius += r;
    pack.MeanSquareRadius += r * r;
    cubes += r * r * r;
    number += 1.0;
    types.insert({ mode->GetTuple1(i), r });
    auto& [ofMode, cubesOfMode] = modes[mode->GetTuple1(i)];
    ofMode += 1.0;
    cubesOfMode += r * r * r;
  }
  for (const auto& [mode, sums] : modes)
  {
    pack.ModeRadius.push_back(std::cbrt(sums.second / sums.first));
    pack.ModeShare.push_back(sums.first / number);
  }
  pack.MeanRadius /= number;
  pack.MeanSquareRadius /= number;
  pack.MeanDiameter = 2.0 * std::cbrt(cubes / number);
  pack.LargestRadius = radius->GetRange(0)[1];
  pack.Modes = static_cast<int>(std::clamp(mode->GetRange(0)[1], 1.0, 1e6));
  pack.Types = static_cast<int>(types.size());
  return pack;
}

// The window of a pack without one, of which a rank knows its piece: the bounds of the piece, or a
// cube of the pack's volume where the piece is not all of it
ruc::Window GuessWindow(vtkPointSet* piece, double share)
{
  double bounds[6];
  piece->GetBounds(bounds);
  ruc::Vector3 edges = { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
  if (share < 1.0)
  {
    const double volume = edges[0] * edges[1] * edges[2] / share;
    edges.fill(std::cbrt(volume));
  }
  return ruc::Window::MakeBox({ 0.0, 0.0, 0.0 }, edges, { false, false, false });
}
}

std::optional<double> PackEstimate::FindSpheres(vtkPointSet* piece, double told, int ranks)
{
  if (told > 0.0)
  {
    return told;
  }
  if (!piece || ranks == 1)
  {
    return piece ? std::optional<double>(piece->GetNumberOfPoints()) : std::nullopt;
  }
  vtkDataArray* total = piece->GetFieldData()->GetArray("NumberOfSpheres");
  if (!total || total->GetNumberOfValues() != 1)
  {
    return {};
  }
  return total->GetTuple1(0);
}

std::optional<ruc::PackFigures> PackEstimate::FindFigures(
  vtkPointSet* piece, const PackData::WindowProperties& properties, double spheres, int ranks)
{
  const vtkIdType points = piece ? piece->GetNumberOfPoints() : 0;
  vtkDataArray* radius =
    points > 0 ? PackData::FindArray(piece->GetPointData(), "Radius", points) : nullptr;
  vtkDataArray* mode =
    points > 0 ? PackData::FindArray(piece->GetPointData(), "Mode", points) : nullptr;
  const std::optional<double> all =
    points > 0 ? FindSpheres(piece, spheres, ranks) : std::optional<double>();
  if (!radius || !mode || !all)
  {
    return {};
  }
  ruc::PackFigures pack = FindSizes(radius, mode, points);
  if (!(pack.MeanRadius > 0.0 && std::isfinite(pack.MeanDiameter)))
  {
    return {};
  }
  pack.Spheres = *all;
  const std::optional<ruc::Window> window = PackData::FindWindowHere(piece, properties);
  pack.Observed = window ? *window : GuessWindow(piece, points / pack.Spheres);
  return pack;
}

std::optional<ruc::CellFigures> PackEstimate::FindCellFigures(
  vtkTable* table, const std::vector<double>& diameters, ruc::LagGrid& lags)
{
  vtkDataArray* r = FindColumn(table, "r");
  if (!r)
  {
    return {};
  }
  lags.Count = static_cast<int>(r->GetNumberOfTuples()) - 1;
  lags.Spacing = r->GetTuple1(lags.Count) / lags.Count;
  std::vector<double> fractions;
  for (std::size_t mode = 1; mode <= diameters.size(); ++mode)
  {
    vtkDataArray* s = FindColumn(table, ruc::Text("S_", mode, "_", mode));
    if (!s)
    {
      return {};
    }
    fractions.push_back(s->GetTuple1(0));
  }
  const ruc::ModeAmounts amounts(fractions, diameters);
  ruc::CellFigures cell;
  cell.Modes = amounts.NumberOfModes();
  for (int mode = 0; mode < cell.Modes; ++mode)
  {
    cell.Density += amounts.Number[mode];
    cell.LargestRadius = std::max(cell.LargestRadius, amounts.Radius[mode]);
  }
  cell.Radius = amounts.Radius;
  for (double number : amounts.Number)
  {
    cell.Share.push_back(number / cell.Density);
  }
  return cell;
}

double PackEstimate::Cores(int ranks)
{
  return static_cast<double>(ranks) * omp_get_max_threads();
}
