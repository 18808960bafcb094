// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/ElasticVoxels.h"

#include "ruc/Base/VectorClones.h"

#include <algorithm>

namespace ruc
{
namespace
{
double LambdaOf(const ElasticModuli& of)
{
  return of.Bulk - 2.0 / 3.0 * of.Shear;
}

// A row of voxels: the arrays of ElasticVoxels
struct Laws
{
  const float* Values[7];
  const std::uint8_t* Material;
  const float *LambdaApart, *MuApart;
};

RUC_VECTOR_CLONES void IsotropicRow(
  const Laws& laws, int count, const float* const* gradient, float* const* stress)
{
  for (int x = 0; x < count; ++x)
  {
    const float mu = laws.Values[1][x], twice = 2.0f * mu;
    const float spherical = laws.Values[0][x] * (gradient[0][x] + gradient[4][x] + gradient[8][x]);
    stress[0][x] = spherical + twice * gradient[0][x];
    stress[1][x] = spherical + twice * gradient[4][x];
    stress[2][x] = spherical + twice * gradient[8][x];
    stress[3][x] = mu * (gradient[5][x] + gradient[7][x]);
    stress[4][x] = mu * (gradient[2][x] + gradient[6][x]);
    stress[5][x] = mu * (gradient[1][x] + gradient[3][x]);
  }
}

// Adds what a laminate's layers strain differently
RUC_VECTOR_CLONES void LaminateRow(
  const Laws& laws, int count, const float* const* gradient, float* const* stress)
{
  for (int x = 0; x < count; ++x)
  {
    const float lambda = laws.LambdaApart[laws.Material[x]], mu = laws.MuApart[laws.Material[x]];
    const float nx = laws.Values[4][x], ny = laws.Values[5][x], nz = laws.Values[6][x];
    const float yz = mu * (gradient[5][x] + gradient[7][x]);
    const float xz = mu * (gradient[2][x] + gradient[6][x]);
    const float xy = mu * (gradient[1][x] + gradient[3][x]);
    const float spherical = lambda * (gradient[0][x] + gradient[4][x] + gradient[8][x]);
    const float twice = 2.0f * mu;
    const float tx = (spherical + twice * gradient[0][x]) * nx + xy * ny + xz * nz;
    const float ty = xy * nx + (spherical + twice * gradient[4][x]) * ny + yz * nz;
    const float tz = xz * nx + yz * ny + (spherical + twice * gradient[8][x]) * nz;
    const float share = laws.Values[2][x];
    const float along = laws.Values[3][x] * (tx * nx + ty * ny + tz * nz);
    const float ax = along * nx - share * tx, ay = along * ny - share * ty,
                az = along * nz - share * tz;
    const float sum = lambda * (ax * nx + ay * ny + az * nz);
    stress[0][x] += sum + twice * ax * nx;
    stress[1][x] += sum + twice * ay * ny;
    stress[2][x] += sum + twice * az * nz;
    stress[3][x] += mu * (ay * nz + az * ny);
    stress[4][x] += mu * (ax * nz + az * nx);
    stress[5][x] += mu * (ax * ny + ay * nx);
  }
}
}

ElasticVoxels::ElasticVoxels(const CellSlab& slab, const ElasticModuli& matrix,
  const std::vector<ElasticModuli>& materials, InterfaceRule rule)
  : Slab(slab)
  , Matrix(matrix)
  , Materials(materials)
  , Rule(rule)
{
  const std::size_t voxels = slab.PlaneSize() * slab.VoxelPlanes();
  const bool laminate = rule == InterfaceRule::Laminate;
  for (std::size_t n = 0; n < this->Values.size(); ++n)
  {
    this->Values[n].resize(n < 2 || laminate ? voxels : 0);
  }
  this->Material.resize(laminate ? voxels : 0);
  for (const ElasticModuli& of : materials)
  {
    this->LambdaApart.push_back(static_cast<float>(LambdaOf(of) - LambdaOf(matrix)));
    this->MuApart.push_back(static_cast<float>(of.Shear - matrix.Shear));
  }
}

std::array<double, 2> ElasticVoxels::Reference() const
{
  double least[2] = { LambdaOf(this->Matrix), this->Matrix.Shear };
  double most[2] = { least[0], least[1] };
  for (const ElasticModuli& of : this->Materials)
  {
    const double values[2] = { LambdaOf(of), of.Shear };
    for (int n = 0; n < 2; ++n)
    {
      least[n] = std::min(least[n], values[n]);
      most[n] = std::max(most[n], values[n]);
    }
  }
  return { 0.5 * (least[0] + most[0]), 0.5 * (least[1] + most[1]) };
}

// Sets the voxel's Values but for the normal, and then the place of the material
void ElasticVoxels::SetVoxel(const PlaneMixture& mixture, std::size_t n, float* values) const
{
  double rest = 1.0, bulk = 0.0, shear = 0.0, inverseBulk = 0.0, inverseShear = 0.0;
  std::size_t most = 0;
  for (std::size_t m = 0; m < this->Materials.size(); ++m)
  {
    const double f = mixture.Fractions[m][n];
    most = f > mixture.Fractions[most][n] ? m : most;
    rest -= f;
    bulk += f * this->Materials[m].Bulk;
    shear += f * this->Materials[m].Shear;
    inverseBulk += f / this->Materials[m].Bulk;
    inverseShear += f / this->Materials[m].Shear;
  }
  rest = std::max(rest, 0.0);
  ElasticModuli mean = { bulk + rest * this->Matrix.Bulk, shear + rest * this->Matrix.Shear };
  if (this->Rule == InterfaceRule::Harmonic)
  {
    mean = { 1.0 / (inverseBulk + rest / this->Matrix.Bulk),
      1.0 / (inverseShear + rest / this->Matrix.Shear) };
  }
  values[0] = static_cast<float>(LambdaOf(mean));
  values[1] = static_cast<float>(mean.Shear);
  const double f = 1.0 - rest;
  const ElasticModuli& other = this->Materials[most];
  const double mu = rest * other.Shear + f * this->Matrix.Shear;
  const double lambda = rest * LambdaOf(other) + f * LambdaOf(this->Matrix);
  values[2] = static_cast<float>(f * rest / mu);
  values[3] = static_cast<float>(f * rest / mu * (lambda + mu) / (lambda + 2.0 * mu));
  values[4] = static_cast<float>(most);
}

void ElasticVoxels::SetPlane(int plane, const PlaneMixture& mixture)
{
  const int nx = this->Slab.Source.Dimensions[0], ny = this->Slab.Source.Dimensions[1];
  constexpr std::size_t kinds = 5;
  std::vector<float> values(kinds * nx * ny);
  for (std::size_t n = 0; n < values.size() / kinds; ++n)
  {
    this->SetVoxel(mixture, n, values.data() + kinds * n);
  }
  const std::array<int, 3> cell = this->Slab.Dimensions();
  const bool laminate = this->Rule == InterfaceRule::Laminate;
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
        for (std::size_t n = 0; n < (laminate ? 4 : 2); ++n)
        {
          this->Values[n][place] = values[kinds * from + n];
        }
        if (laminate)
        {
          this->Material[place] = static_cast<std::uint8_t>(values[kinds * from + 4]);
        }
        const std::array<int, 3> at = { x, y, z };
        for (int q = 0; q < 3 && laminate; ++q)
        {
          const float normal = mixture.Normal[q][from];
          this->Values[4 + q][place] = this->Slab.IsImage(q, at[q]) ? -normal : normal;
        }
      }
    }
  }
}

void ElasticVoxels::Flux(
  std::size_t place, int count, const float* const* gradient, float* const* flux) const
{
  Laws laws = {};
  for (std::size_t n = 0; n < this->Values.size(); ++n)
  {
    laws.Values[n] = this->Values[n].data() + place;
  }
  laws.Material = this->Material.data() + place;
  laws.LambdaApart = this->LambdaApart.data();
  laws.MuApart = this->MuApart.data();
  IsotropicRow(laws, count, gradient, flux);
  if (this->Rule == InterfaceRule::Laminate)
  {
    LaminateRow(laws, count, gradient, flux);
  }
}
}
