// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EffectiveTables.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "VoxelOutput.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
const char* const RuleNames[] = { "Laminate", "Harmonic", "Arithmetic" };

struct Column
{
  const char* Name;
  double ruc::PropertyBounds::*Value;
};
constexpr Column Columns[] = { { "Voigt", &ruc::PropertyBounds::Voigt },
  { "Reuss", &ruc::PropertyBounds::Reuss },
  { "HashinShtrikmanLower", &ruc::PropertyBounds::HashinShtrikmanLower },
  { "HashinShtrikmanUpper", &ruc::PropertyBounds::HashinShtrikmanUpper },
  { "ThirdOrderLower", &ruc::PropertyBounds::ThirdOrderLower },
  { "ThirdOrderLower_error", &ruc::PropertyBounds::ThirdOrderLowerError },
  { "ThirdOrderUpper", &ruc::PropertyBounds::ThirdOrderUpper },
  { "ThirdOrderUpper_error", &ruc::PropertyBounds::ThirdOrderUpperError },
  { "Estimate", &ruc::PropertyBounds::Estimate } };

std::vector<std::string> BoundedNames(ruc::CellProperty property)
{
  return property == ruc::CellProperty::Conductivity ? std::vector<std::string>{ "k" }
                                                     : std::vector<std::string>{ "K", "G" };
}

// The values of this rank's piece, one after the other for each voxel
void AddArray(const char* name, std::vector<ruc::VoxelSlab<float>> parts,
  const ruc::VoxelBlock& block, vtkImageData* image, RankCommunicator& ranks)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(parts.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(block.Voxels()));
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    const std::vector<float> values = ruc::TakeBlock(std::exchange(parts[part], {}), block, ranks);
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      array->SetTypedComponent(static_cast<vtkIdType>(n), static_cast<int>(part), values[n]);
    }
  }
  image->GetCellData()->AddArray(array);
}
}

void EffectiveTables::FillProperties(
  ruc::CellProperty property, const Properties& of, vtkTable* table)
{
  const std::vector<std::string> bounded = BoundedNames(property);
  std::vector<std::string> names;
  std::vector<double> values, discretisation, iteration;
  for (const ruc::CellQuantity& quantity : of.Quantities)
  {
    names.push_back(quantity.Name);
    values.push_back(quantity.Value);
    discretisation.push_back(quantity.DiscretisationError);
    iteration.push_back(quantity.IterationError);
  }
  if (names.empty())
  {
    names = bounded;
  }
  PackData::AddColumn(table, "Quantity", names);
  for (const Column& column : Columns)
  {
    std::vector<double> numbers(names.size(), Unknown);
    for (std::size_t row = 0; row < names.size(); ++row)
    {
      for (std::size_t n = 0; n < of.Bounds.size(); ++n)
      {
        numbers[row] = names[row] == bounded[n] ? of.Bounds[n].*column.Value : numbers[row];
      }
    }
    PackData::AddColumn(table, column.Name, numbers);
  }
  const auto add = [&](const char* name, std::vector<double>& numbers)
  {
    numbers.resize(names.size(), Unknown);
    PackData::AddColumn(table, name, numbers);
  };
  add("Solver", values);
  add("DiscretisationError", discretisation);
  add("IterationError", iteration);
}

void EffectiveTables::FillConvergence(
  ruc::CellProperty property, const std::vector<ruc::CellRun>& runs, vtkTable* table)
{
  constexpr const char* axes[] = { "xx", "yy", "zz", "yz", "xz", "xy" };
  std::vector<std::string> cases, rules;
  std::vector<long long> resolutions, iterations;
  std::vector<double> energies;
  for (const ruc::CellRun& run : runs)
  {
    for (const ruc::SolverStep& step : run.Cell.Tensor.Steps)
    {
      const bool elastic = property == ruc::CellProperty::Elasticity;
      cases.emplace_back(elastic ? axes[step.Case] : std::string(1, axes[step.Case][0]));
      rules.emplace_back(RuleNames[static_cast<int>(run.Rule)]);
      resolutions.push_back(run.Resolution);
      iterations.push_back(step.Iteration);
      energies.push_back(step.Energy);
    }
  }
  PackData::AddColumn(table, "Case", cases);
  PackData::AddColumn(table, "Resolution", resolutions);
  PackData::AddColumn(table, "InterfaceRule", rules);
  PackData::AddColumn(table, "Iteration", iterations);
  PackData::AddColumn(table, "Energy", energies);
}

void EffectiveTables::FillFields(
  const ruc::CellGrid& cell, ruc::CellFields fields, vtkImageData* image, RankCommunicator& ranks)
{
  const ruc::VoxelBlock block = VoxelOutput::FindPiece(cell.Source, false, ranks);
  const bool elastic = fields.Unknown.size() == 3;
  AddArray("VolumeFraction", { std::move(fields.VolumeFraction) }, block, image, ranks);
  if (!fields.Unknown.empty())
  {
    AddArray(
      elastic ? "Displacement" : "Temperature", std::move(fields.Unknown), block, image, ranks);
    AddArray(elastic ? "Stress" : "Flux", std::move(fields.Flux), block, image, ranks);
  }
  image->GetCellData()->SetActiveScalars("VolumeFraction");
}
