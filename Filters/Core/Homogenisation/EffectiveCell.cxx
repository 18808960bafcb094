// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveCell.h"

#include "ruc/Base/Require.h"
#include "ruc/Homogenisation/ElasticVoxels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
// Sets the place of each value of the modes among those that differ
template <class Value, class Same>
std::vector<Value> Distinct(
  const std::vector<Value>& ofModes, std::vector<int>& places, Same&& same)
{
  std::vector<Value> values;
  for (const Value& value : ofModes)
  {
    const auto found = std::find_if(
      values.begin(), values.end(), [&](const Value& other) { return same(value, other); });
    places.push_back(static_cast<int>(found - values.begin()));
    if (found == values.end())
    {
      values.push_back(value);
    }
  }
  return values;
}

std::vector<double> ForEveryMode(const char* name, const std::vector<double>& values, int modes)
{
  Require(values.size() == 1 || values.size() == static_cast<std::size_t>(modes), name,
    Text("one number, or one for each of the ", modes, " modes"), values.size());
  return values.size() == 1 ? std::vector<double>(modes, values[0]) : values;
}

void RequireContrast(const char* name, double value, double matrix)
{
  Require(value == 0.0 || (value <= MostContrast * matrix && matrix <= MostContrast * value), name,
    Text("at most ", MostContrast, " times the matrix's value, ", matrix,
      ", and at least a part of it as small; 10000 times stands for spheres of no resistance"),
    value);
}
}

double CellMaterials::Contrast() const
{
  double contrast = 1.0;
  const auto take = [&](double value, double matrix) {
    contrast = std::max({ contrast, value / matrix, value > 0.0 ? matrix / value : MostContrast });
  };
  for (double k : this->Conductivities)
  {
    take(k, this->MatrixConductivity);
  }
  for (const ElasticModuli& of : this->Moduli)
  {
    take(of.Bulk, this->Matrix.Bulk);
    take(of.Shear, this->Matrix.Shear);
  }
  return contrast;
}

InterfaceRule CellMaterials::AutomaticRule() const
{
  return this->Property == CellProperty::Elasticity
    ? InterfaceRule::Laminate
    : ConductivityVoxels::AutomaticRule(this->MatrixConductivity, this->Conductivities);
}

CellMaterials MakeConductors(double matrix, const std::vector<double>& ofModes, int modes)
{
  Require(
    std::isfinite(matrix) && matrix > 0.0, "MatrixConductivity", "a finite number > 0", matrix);
  CellMaterials materials;
  materials.MatrixConductivity = matrix;
  const std::vector<double> all = ForEveryMode("ModeConductivities", ofModes, modes);
  for (double value : all)
  {
    Require(
      std::isfinite(value) && value >= 0.0, "ModeConductivities", "finite numbers >= 0", value);
    RequireContrast("ModeConductivities", value, matrix);
  }
  materials.Conductivities =
    Distinct(all, materials.OfMode, [](double a, double b) { return a == b; });
  return materials;
}

CellMaterials MakeElastic(double matrixYoung, double matrixPoisson,
  const std::vector<double>& youngOfModes, const std::vector<double>& poissonOfModes, int modes)
{
  const auto check = [](const char* name, double young, const char* ratio, double poisson)
  {
    Require(std::isfinite(young) && young > 0.0, name, "finite numbers > 0", young);
    Require(poisson > -1.0 && poisson < 0.5, ratio, "numbers > -1 and < 0.5", poisson);
  };
  check("MatrixModulus", matrixYoung, "MatrixPoissonRatio", matrixPoisson);
  CellMaterials materials;
  materials.Property = CellProperty::Elasticity;
  materials.Matrix = ModuliOf(matrixYoung, matrixPoisson);
  const std::vector<double> young = ForEveryMode("ModeModuli", youngOfModes, modes);
  const std::vector<double> poisson = ForEveryMode("ModePoissonRatios", poissonOfModes, modes);
  std::vector<ElasticModuli> all;
  for (int mode = 0; mode < modes; ++mode)
  {
    check("ModeModuli", young[mode], "ModePoissonRatios", poisson[mode]);
    RequireContrast("ModeModuli", young[mode], matrixYoung);
    all.push_back(ModuliOf(young[mode], poisson[mode]));
  }
  materials.Moduli = Distinct(all, materials.OfMode,
    [](const auto& a, const auto& b) { return a.Bulk == b.Bulk && a.Shear == b.Shear; });
  return materials;
}

CellGrid MakeCellGrid(const Window& box, int resolution, bool mirrored)
{
  constexpr int most = 4096;
  Require(resolution >= 2 && resolution <= most, "Resolution", Text("a number from 2 to ", most),
    resolution);
  std::array<int, 3> dimensions;
  for (int q = 0; q < 3; ++q)
  {
    const double voxels = box.Size[q] / box.ShortestEdge() * resolution;
    Require(voxels <= 2.0 * most, "Resolution",
      Text("at most ", 2 * most, " voxels along each edge"), voxels);
    dimensions[q] = LineTransform::FastLength(static_cast<int>(std::lround(voxels)));
  }
  return { MakeVoxelGrid(box, 0.0, dimensions), mirrored };
}

namespace
{
VoxelSlab<float> MakeSlab(const CellSlab& slab)
{
  VoxelSlab<float> values = { slab.Dimensions(), slab.Begin, slab.End, {} };
  values.Values.resize(slab.PlaneSize() * slab.OwnPlanes());
  return values;
}

// The shares of spheres: their sum by planes of the grid of this rank's own, and the field
class Fractions
{
public:
  Fractions(const CellSlab& slab, CellFields* fields)
    : Slab(slab)
    , Fields(fields)
    , Sums(slab.OwnPlanes(), 0.0)
  {
    if (fields)
    {
      fields->VolumeFraction = MakeSlab(slab);
    }
  }
  void Take(int plane, const PlaneMixture& mixture)
  {
    const std::array<int, 3>& source = this->Slab.Source.Dimensions;
    const std::size_t voxels = std::size_t(source[0]) * source[1];
    std::vector<float> sum(voxels, 0.0f);
    for (const float* of : mixture.Fractions)
    {
      std::transform(sum.begin(), sum.end(), of, sum.begin(), std::plus<>());
    }
    const double all = std::accumulate(sum.begin(), sum.end(), 0.0);
    const std::array<int, 3> cell = this->Slab.Dimensions();
    for (int z = this->Slab.Begin; z < this->Slab.End; ++z)
    {
      if (this->Slab.SourceOf(2, z) != plane)
      {
        continue;
      }
      this->Sums[z - this->Slab.Begin] = all / static_cast<double>(voxels);
      for (int y = 0; this->Fields && y < cell[1]; ++y)
      {
        float* row = this->Fields->VolumeFraction.Row(y, z);
        for (int x = 0; x < cell[0]; ++x)
        {
          row[x] =
            sum[std::size_t(this->Slab.SourceOf(1, y)) * source[0] + this->Slab.SourceOf(0, x)];
        }
      }
    }
  }
  double Mean(Communicator& ranks) const
  {
    return SumInOrder(this->Sums, ranks) / static_cast<double>(this->Slab.Planes.Count);
  }

private:
  const CellSlab& Slab;
  CellFields* Fields;
  std::vector<double> Sums;
};

void TakeFields(const CellSlab& slab, int of, const CornerField& u, const CornerOperator& equations,
  CellFields& fields)
{
  const int components = u.Components(), fluxes = components == 1 ? 3 : MostFluxes;
  const MacroGradient uniform = CellSolver::GradientOf(components, of);
  fields.Flux.assign(fluxes, MakeSlab(slab));
  fields.Unknown.assign(components, MakeSlab(slab));
  CornerField rest(slab, components);
  equations.Apply(u, uniform, rest,
    [&](int z, const float* const* flux)
    {
      for (int f = 0; f < fluxes; ++f)
      {
        std::copy_n(flux[f], slab.PlaneSize(), fields.Flux[f].Row(0, z));
      }
    });
  const int nx = slab.Dimensions()[0], ny = slab.Dimensions()[1];
  const Vector3& h = slab.Source.Spacing;
  for (int c = 0; c < components; ++c)
  {
    for (int z = slab.Begin; z < slab.End; ++z)
    {
      const float* below = u.Plane(c, z - slab.Begin + 1);
      const float* above = u.Plane(c, z - slab.Begin + 2);
      for (int y = 0; y < ny; ++y)
      {
        float* row = fields.Unknown[c].Row(y, z);
        for (int x = 0; x < nx; ++x)
        {
          const std::size_t rows[2] = { std::size_t(y) * nx, std::size_t((y + 1) % ny) * nx };
          const int columns[2] = { x, (x + 1) % nx };
          double sum = 0.0;
          for (std::size_t at : rows)
          {
            for (int column : columns)
            {
              sum += below[at + column] + above[at + column];
            }
          }
          row[x] = static_cast<float>(sum / 8.0 + uniform[3 * c] * (x + 0.5) * h[0] +
            uniform[3 * c + 1] * (y + 0.5) * h[1] + uniform[3 * c + 2] * (z + 0.5) * h[2]);
        }
      }
    }
  }
}

template <class Law>
SolvedCell Solve(const SpherePack& piece, const Window& window, const CellSlab& slab, Law& law,
  const CellMaterials& materials, InterfaceRule rule, const SolverSettings& settings,
  Communicator& ranks, const CellSolver::Progress& progress, CellFields* fields)
{
  Fractions fractions(slab, fields);
  MixtureOfPack(piece, window, slab, materials.OfMode, rule == InterfaceRule::Laminate, ranks,
    [&](int plane, const PlaneMixture& mixture)
    {
      law.SetPlane(plane, mixture);
      fractions.Take(plane, mixture);
    });
  SolvedCell solved;
  solved.Fraction = fractions.Mean(ranks);
  CellSolver solver(slab, law, ranks);
  solved.Tensor = solver.Solve(settings, progress,
    [&](int of, const CornerField& u, const CornerOperator& equations)
    {
      if (fields && fields->Case == of)
      {
        TakeFields(slab, of, u, equations, *fields);
      }
    });
  return solved;
}
}

SolvedCell SolveCell(const SpherePack& piece, const Window& window, const CellGrid& cell,
  const CellMaterials& materials, InterfaceRule rule, const SolverSettings& settings,
  Communicator& ranks, const CellSolver::Progress& progress, CellFields* fields)
{
  ValidateSolver(settings);
  const CellSlab slab(cell, ranks.Rank(), ranks.Size());
  if (materials.Property == CellProperty::Conductivity)
  {
    ConductivityVoxels law(slab, materials.MatrixConductivity, materials.Conductivities, rule);
    return Solve(piece, window, slab, law, materials, rule, settings, ranks, progress, fields);
  }
  ElasticVoxels law(slab, materials.Matrix, materials.Moduli, rule);
  return Solve(piece, window, slab, law, materials, rule, settings, ranks, progress, fields);
}

double FindFraction(const SpherePack& piece, const Window& window, const CellGrid& cell,
  const CellMaterials& materials, Communicator& ranks, CellFields* fields)
{
  const CellSlab slab(cell, ranks.Rank(), ranks.Size());
  Fractions fractions(slab, fields);
  MixtureOfPack(piece, window, slab, materials.OfMode, false, ranks,
    [&](int plane, const PlaneMixture& mixture) { fractions.Take(plane, mixture); });
  return fractions.Mean(ranks);
}

Estimate EstimateCell(
  const CellGrid& cell, const CellMaterials& materials, InterfaceRule rule, bool withFields)
{
  const std::array<int, 3> n = cell.Dimensions();
  const double voxels = 1.0 * n[0] * n[1] * n[2];
  const bool elastic = materials.Property == CellProperty::Elasticity;
  const int components = elastic ? 3 : 1, cases = elastic ? 6 : 3;
  // Steps grow as the root of the contrast, and hardly with voids
  const double contrast = materials.Contrast();
  const double steps = rule == InterfaceRule::Arithmetic && !elastic
    ? 15.0
    : std::max(10.0, 2.5 * std::sqrt(std::min(contrast, MostContrast)));
  constexpr double secondsPerVoxel = 3e-8;
  Estimate estimate;
  estimate.Seconds = voxels * cases * components * (steps + 2.0) * secondsPerVoxel;
  const double law =
    elastic ? ElasticVoxels::BytesOfVoxel(rule) : ConductivityVoxels::BytesOfVoxel(rule);
  const double fields = withFields ? 4.0 * (1 + 2 * components + (elastic ? 6 : 3)) : 4.0;
  estimate.MegabytesOfAll = voxels * (BytesOfSolver(components) + law + fields) / BytesOfMegabyte;
  // Planes more of the neighbours, in all fields
  estimate.MegabytesOfRank = 2.0 * n[0] * n[1] * BytesOfSolver(components) / BytesOfMegabyte;
  return estimate;
}
}
