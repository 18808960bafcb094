// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/ConductivityVoxels.h"

#include "ruc/Base/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr double LeastContrast = 30.0; // of the rules for good conductors and for voids

RUC_VECTOR_CLONES void MultiplyRow(
  const float* mean, int count, const float* const* gradient, float* const* flux)
{
  for (int x = 0; x < count; ++x)
  {
    const float k = mean[x];
    flux[0][x] = k * gradient[0][x];
    flux[1][x] = k * gradient[1][x];
    flux[2][x] = k * gradient[2][x];
  }
}

RUC_VECTOR_CLONES void LaminateRow(const float* mean, const float* a, const float* b,
  const float* c, int count, const float* const* gradient, float* const* flux)
{
  for (int x = 0; x < count; ++x)
  {
    const float k = mean[x];
    const float across = a[x] * gradient[0][x] + b[x] * gradient[1][x] + c[x] * gradient[2][x];
    flux[0][x] = k * gradient[0][x] - across * a[x];
    flux[1][x] = k * gradient[1][x] - across * b[x];
    flux[2][x] = k * gradient[2][x] - across * c[x];
  }
}
}

InterfaceRule ConductivityVoxels::AutomaticRule(double matrix, const std::vector<double>& materials)
{
  const auto [least, most] = std::minmax_element(materials.begin(), materials.end());
  return *most >= LeastContrast * matrix ? InterfaceRule::Harmonic
    : *least * LeastContrast <= matrix   ? InterfaceRule::Arithmetic
                                         : InterfaceRule::Laminate;
}

ConductivityVoxels::ConductivityVoxels(
  const CellSlab& slab, double matrix, const std::vector<double>& materials, InterfaceRule rule)
  : Slab(slab)
  , Matrix(matrix)
  , Materials(materials)
  , Rule(rule)
  , Mean(slab.PlaneSize() * slab.VoxelPlanes())
{
  for (std::vector<float>& of : this->Normal)
  {
    of.resize(rule == InterfaceRule::Laminate ? this->Mean.size() : 0);
  }
}

std::array<double, 2> ConductivityVoxels::Reference() const
{
  // Of a scalar the steps do not depend on it
  return { 1.0, 0.0 };
}

void ConductivityVoxels::SetPlane(int plane, const PlaneMixture& mixture)
{
  const int nx = this->Slab.Source.Dimensions[0], ny = this->Slab.Source.Dimensions[1];
  const std::size_t voxels = std::size_t(nx) * ny;
  std::vector<float> mean(voxels), less(voxels);
  for (std::size_t n = 0; n < voxels; ++n)
  {
    double rest = 1.0, sum = 0.0, inverse = 0.0;
    for (std::size_t m = 0; m < this->Materials.size(); ++m)
    {
      const double f = mixture.Fractions[m][n];
      rest -= f;
      sum += f * this->Materials[m];
      inverse += f > 0.0 ? f / this->Materials[m] : 0.0;
    }
    rest = std::max(rest, 0.0);
    sum += rest * this->Matrix;
    inverse += rest > 0.0 ? rest / this->Matrix : 0.0;
    mean[n] = static_cast<float>(this->Rule == InterfaceRule::Harmonic ? 1.0 / inverse : sum);
    less[n] = static_cast<float>(std::sqrt(std::max(sum - 1.0 / inverse, 0.0)));
  }
  const std::array<int, 3> cell = this->Slab.Dimensions();
  for (int l = 0; l < this->Slab.VoxelPlanes(); ++l)
  {
    const int z = this->Slab.PlaneOf(l);
    if (this->Slab.SourceOf(2, z) != plane)
    {
      continue;
    }
    std::size_t place = l * this->Slab.PlaneSize();
    for (int y = 0; y < cell[1]; ++y)
    {
      for (int x = 0; x < cell[0]; ++x, ++place)
      {
        const std::size_t from =
          std::size_t(this->Slab.SourceOf(1, y)) * nx + this->Slab.SourceOf(0, x);
        this->Mean[place] = mean[from];
        const std::array<int, 3> at = { x, y, z };
        for (int q = 0; q < 3 && this->Rule == InterfaceRule::Laminate; ++q)
        {
          const float normal = less[from] * mixture.Normal[q][from];
          this->Normal[q][place] = this->Slab.IsImage(q, at[q]) ? -normal : normal;
        }
      }
    }
  }
}

void ConductivityVoxels::Flux(
  std::size_t place, int count, const float* const* gradient, float* const* flux) const
{
  const float* mean = this->Mean.data() + place;
  if (this->Rule != InterfaceRule::Laminate)
  {
    MultiplyRow(mean, count, gradient, flux);
    return;
  }
  LaminateRow(mean, this->Normal[0].data() + place, this->Normal[1].data() + place,
    this->Normal[2].data() + place, count, gradient, flux);
}
}
