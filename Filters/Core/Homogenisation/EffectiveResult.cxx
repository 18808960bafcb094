// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveResult.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ruc
{
namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

// The fractions of the materials, the matrix last
std::vector<double> OfMaterials(
  const CellMaterials& materials, std::size_t count, const std::vector<double>& fractions)
{
  std::vector<double> merged(count + 1, 0.0);
  for (std::size_t mode = 0; mode < materials.OfMode.size(); ++mode)
  {
    merged[materials.OfMode[mode]] += fractions[mode];
  }
  merged[count] = fractions.back();
  return merged;
}

// I_qrs of the materials: that of modes, which add up
ManyPhaseIntegrals OfMaterials(
  const CellMaterials& materials, std::size_t count, const ThirdOrderOfSpheres& third)
{
  const std::size_t n = count + 1;
  const int modes = third.Sources;
  const auto material = [&](int phase)
  { return phase < modes ? static_cast<std::size_t>(materials.OfMode[phase]) : count; };
  ManyPhaseIntegrals merged;
  merged.Value.assign(n * n * n, 0.0);
  merged.Error.assign(n * n * n, 0.0);
  for (int q = 0; q <= modes; ++q)
  {
    for (int r = 0; r <= modes; ++r)
    {
      for (int s = 0; s <= modes; ++s)
      {
        const ThirdOrderFigure& of = third.Second[third.PlaceOf(q, std::min(r, s), std::max(r, s))];
        const std::size_t place = (material(q) * n + material(r)) * n + material(s);
        merged.Value[place] += of.Value;
        merged.Error[place] += of.Error;
      }
    }
  }
  return merged;
}
}

std::vector<PropertyBounds> BoundPack(const CellMaterials& materials,
  const std::vector<double>& fractions, const ThirdOrderOfSpheres* third)
{
  const bool elastic = materials.Property == CellProperty::Elasticity;
  const std::size_t count = elastic ? materials.Moduli.size() : materials.Conductivities.size();
  const std::vector<double> c = OfMaterials(materials, count, fractions);
  TwoPhaseParameters two = {};
  if (third)
  {
    const ThirdOrderOfSpheres::Parameters& of = third->Spheres;
    two = { of.Zeta.Value, of.Zeta.Error, of.Eta.Value, of.Eta.Error };
  }
  if (!elastic)
  {
    std::vector<double> values = materials.Conductivities;
    values.push_back(materials.MatrixConductivity);
    PropertyBounds bounds = BoundConductivity(c, values);
    if (third && count == 1)
    {
      AddThirdOrderConductivity(
        c[0], materials.MatrixConductivity, materials.Conductivities[0], two, bounds);
    }
    else if (third && *std::min_element(values.begin(), values.end()) > 0.0)
    {
      AddThirdOrderConductivity(c, values, OfMaterials(materials, count, *third), bounds);
    }
    return { bounds };
  }
  std::vector<ElasticModuli> moduli = materials.Moduli;
  moduli.push_back(materials.Matrix);
  PropertyBounds bulk = BoundBulk(c, moduli), shear = BoundShear(c, moduli);
  if (third && count == 1)
  {
    AddThirdOrderBulk(c[0], materials.Matrix, materials.Moduli[0], two, bulk);
    AddThirdOrderShear(c[0], materials.Matrix, materials.Moduli[0], two, shear);
  }
  else if (third)
  {
    AddThirdOrderBulk(c, moduli, OfMaterials(materials, count, *third), bulk);
  }
  return { bulk, shear };
}

namespace
{
// A property as a sum of a tensor's entries
struct Part
{
  int A, B;
  double Factor;
};
struct Recipe
{
  std::string Name;
  std::vector<Part> Parts;
};

std::vector<Recipe> Recipes(CellProperty property)
{
  if (property == CellProperty::Conductivity)
  {
    constexpr double third = 1.0 / 3.0;
    return { { "k_xx", { { 0, 0, 1.0 } } }, { "k_yy", { { 1, 1, 1.0 } } },
      { "k_zz", { { 2, 2, 1.0 } } }, { "k_yz", { { 1, 2, 1.0 } } }, { "k_xz", { { 0, 2, 1.0 } } },
      { "k_xy", { { 0, 1, 1.0 } } },
      { "k", { { 0, 0, third }, { 1, 1, third }, { 2, 2, third } } } };
  }
  std::vector<Recipe> recipes;
  Recipe bulk = { "K", {} }, shear = { "G", {} };
  for (int a = 0; a < MostFluxes; ++a)
  {
    for (int b = a; b < MostFluxes; ++b)
    {
      recipes.push_back({ Text("C_", a + 1, b + 1), { { a, b, 1.0 } } });
      if (b < 3)
      {
        bulk.Parts.push_back({ a, b, (a == b ? 1.0 : 2.0) / 9.0 });
        shear.Parts.push_back({ a, b, (a == b ? 1.0 : -1.0) / 15.0 });
      }
      else if (a == b)
      {
        shear.Parts.push_back({ a, a, 0.2 });
      }
    }
  }
  recipes.push_back(bulk);
  recipes.push_back(shear);
  return recipes;
}

double ValueOf(const Recipe& recipe, const CellRun& run)
{
  double sum = 0.0;
  for (const Part& of : recipe.Parts)
  {
    sum += of.Factor * run.Cell.Tensor.Value[of.A][of.B];
  }
  return sum;
}

// Entries off the diagonal are off by at most the root of the errors of both of theirs
double ErrorOf(const Recipe& recipe, const CellRun& run)
{
  const auto& errors = run.Cell.Tensor.IterationError;
  double sum = 0.0;
  for (const Part& of : recipe.Parts)
  {
    sum += std::abs(of.Factor) * std::sqrt(errors[of.A] * errors[of.B]);
  }
  return sum;
}

CellQuantity Combine(const Recipe& recipe, const std::vector<CellRun>& runs, double finest)
{
  CellQuantity quantity = { recipe.Name, 0.0, Unknown, 0.0 };
  int count = 0;
  for (const CellRun& run : runs)
  {
    if (run.Edge == finest)
    {
      quantity.Value += ValueOf(recipe, run);
      quantity.IterationError = std::max(quantity.IterationError, ErrorOf(recipe, run));
      ++count;
    }
  }
  quantity.Value /= count;
  if (runs.size() > 1)
  {
    quantity.DiscretisationError = 0.0;
  }
  const auto notice = [&](double value)
  {
    quantity.DiscretisationError =
      std::max(quantity.DiscretisationError, std::abs(value - quantity.Value));
  };
  for (const CellRun& fine : runs)
  {
    for (const CellRun& run : runs)
    {
      if (fine.Edge == finest && run.Rule == fine.Rule && runs.size() > 1)
      {
        const double here = ValueOf(recipe, fine);
        notice(run.Edge == finest
            ? here
            : here + (here - ValueOf(recipe, run)) * finest / (run.Edge - finest));
      }
    }
  }
  return quantity;
}
}

std::vector<CellQuantity> CombineRuns(CellProperty property, const std::vector<CellRun>& runs)
{
  double finest = std::numeric_limits<double>::infinity();
  for (const CellRun& run : runs)
  {
    finest = std::min(finest, run.Edge);
  }
  std::vector<CellQuantity> quantities;
  for (const Recipe& recipe : Recipes(property))
  {
    quantities.push_back(Combine(recipe, runs, finest));
  }
  return quantities;
}

std::array<double, MostFluxes> ExpansionOf(const EffectiveTensor& stiffness,
  const ElasticModuli& matrix, const ElasticModuli& spheres, double ofMatrix, double ofSpheres)
{
  // S times (1, 1, 1, 0, 0, 0), by elimination of a matrix that is positive definite
  auto c = stiffness.Value;
  std::array<double, MostFluxes> x = { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 };
  for (int p = 0; p < MostFluxes; ++p)
  {
    for (int row = p + 1; row < MostFluxes; ++row)
    {
      const double factor = c[row][p] / c[p][p];
      for (int column = p; column < MostFluxes; ++column)
      {
        c[row][column] -= factor * c[p][column];
      }
      x[row] -= factor * x[p];
    }
  }
  for (int p = MostFluxes - 1; p >= 0; --p)
  {
    for (int column = p + 1; column < MostFluxes; ++column)
    {
      x[p] -= c[p][column] * x[column];
    }
    x[p] /= c[p][p];
  }
  const double apart = 1.0 / spheres.Bulk - 1.0 / matrix.Bulk;
  for (int i = 0; i < MostFluxes; ++i)
  {
    const double own = i < 3 ? 1.0 : 0.0;
    x[i] = apart == 0.0
      ? Unknown
      : own * ofMatrix + (ofSpheres - ofMatrix) / apart * (3.0 * x[i] - own / matrix.Bulk);
  }
  return x;
}
}
