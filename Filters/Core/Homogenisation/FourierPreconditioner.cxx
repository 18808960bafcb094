// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/FourierPreconditioner.h"

#include "ruc/Base/Vector3.h"
#include "ruc/Base/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr int Lanes = LineTransform::Lanes;

// What the frequencies of a line along z have in common, for each of the lanes along x
struct Line
{
  double SineX[Lanes], CosineX[Lanes];
  double Weight[Lanes]; // 2 where a frequency stands for its conjugate as well
  double SineY, CosineY;
  const double *SineZ, *CosineZ;
  int Count; // along z
  double *Real[3], *Imaginary[3];
};

// Divides a line of a temperature by k0 d^2, and adds up r z
RUC_VECTOR_CLONES void DivideTemperature(const Line& line, double k0, double* sums)
{
  for (int z = 0; z < line.Count; ++z)
  {
    double* real = line.Real[0] + std::size_t(z) * Lanes;
    double* imaginary = line.Imaginary[0] + std::size_t(z) * Lanes;
    const double sz = line.SineZ[z], cz = line.CosineZ[z];
    for (int l = 0; l < Lanes; ++l)
    {
      const double x = line.SineX[l] * line.CosineY * cz;
      const double y = line.CosineX[l] * line.SineY * cz;
      const double w = line.CosineX[l] * line.CosineY * sz;
      const double square = k0 * (x * x + y * y + w * w);
      const double inverse = square > 0.0 ? 1.0 / square : 0.0;
      sums[l] += line.Weight[l] * inverse * (real[l] * real[l] + imaginary[l] * imaginary[l]);
      real[l] *= inverse;
      imaginary[l] *= inverse;
    }
  }
}

// The same of a displacement: (1 / (mu d^2)) (r - (lambda + mu) / (lambda + 2 mu) d (d . r) / d^2)
RUC_VECTOR_CLONES void DivideDisplacement(const Line& line, double lambda, double mu, double* sums)
{
  const double part = (lambda + mu) / (lambda + 2.0 * mu);
  for (int z = 0; z < line.Count; ++z)
  {
    const std::size_t at = std::size_t(z) * Lanes;
    const double sz = line.SineZ[z], cz = line.CosineZ[z];
    for (int l = 0; l < Lanes; ++l)
    {
      const double d[3] = { line.SineX[l] * line.CosineY * cz, line.CosineX[l] * line.SineY * cz,
        line.CosineX[l] * line.CosineY * sz };
      const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      const double inverse = square > 0.0 ? 1.0 / square : 0.0;
      double sum = 0.0;
      for (double* const* parts : { line.Real, line.Imaginary })
      {
        const double along =
          d[0] * parts[0][at + l] + d[1] * parts[1][at + l] + d[2] * parts[2][at + l];
        const double less = part * along * inverse;
        for (int c = 0; c < 3; ++c)
        {
          double& value = parts[c][at + l];
          const double divided = (value - less * d[c]) * (inverse / mu);
          sum += value * divided;
          value = divided;
        }
      }
      sums[l] += line.Weight[l] * sum;
    }
  }
}
}

FourierPreconditioner::FourierPreconditioner(const CellSlab& slab,
  const std::array<double, 2>& reference, int components, const Communicator& ranks)
  : Slab(slab)
  , Reference(reference)
  , Transform(slab.Dimensions(), slab.Dimensions(), ranks)
  , Spectra(components)
{
  for (int q = 0; q < 3; ++q)
  {
    const int n = slab.Dimensions()[q];
    for (int k = 0; k < n; ++k)
    {
      const double angle = Pi * k / n;
      this->Sine[q].push_back(2.0 / slab.Source.Spacing[q] * std::sin(angle));
      this->Cosine[q].push_back(2 * k == n ? 0.0 : std::cos(angle));
    }
  }
}

std::vector<double> FourierPreconditioner::Divide()
{
  const int nx = this->Slab.Dimensions()[0], nz = this->Slab.Dimensions()[2];
  std::vector<double> sums(this->Transform.NumberOfBlocks());
#pragma omp parallel for
  for (std::int64_t block = 0; block < static_cast<std::int64_t>(sums.size()); ++block)
  {
    const FourierTransform::Frequencies at = this->Transform.FrequenciesOf(block);
    Line line = {};
    for (int l = 0; l < Lanes && at.FirstX + l < this->Transform.HalfX(); ++l)
    {
      const int k = at.FirstX + l;
      line.SineX[l] = this->Sine[0][k];
      line.CosineX[l] = this->Cosine[0][k];
      line.Weight[l] = k == 0 || 2 * k == nx ? 1.0 : 2.0;
    }
    line.SineY = this->Sine[1][at.Y];
    line.CosineY = this->Cosine[1][at.Y];
    line.SineZ = this->Sine[2].data();
    line.CosineZ = this->Cosine[2].data();
    line.Count = nz;
    for (std::size_t c = 0; c < this->Spectra.size(); ++c)
    {
      line.Real[c] = this->Spectra[c].data() + block * 2 * Lanes * nz;
      line.Imaginary[c] = line.Real[c] + std::size_t(Lanes) * nz;
    }
    double lanes[Lanes] = {};
    if (this->Spectra.size() == 1)
    {
      DivideTemperature(line, this->Reference[0], lanes);
    }
    else
    {
      DivideDisplacement(line, this->Reference[0], this->Reference[1], lanes);
    }
    for (double lane : lanes)
    {
      sums[block] += lane;
    }
  }
  return sums;
}

double FourierPreconditioner::Step(
  const CornerField& r, double former, CornerField& p, Communicator& ranks)
{
  const int nx = this->Slab.Dimensions()[0], components = r.Components();
  for (int c = 0; c < components; ++c)
  {
    this->Transform.Forward([&](int y, int z, double* line)
      { std::copy_n(r.Plane(c, z - this->Slab.Begin + 1) + std::size_t(y) * nx, nx, line); },
      this->Spectra[c], ranks);
  }
  const double corners = static_cast<double>(this->Slab.PlaneSize()) * this->Slab.Planes.Count;
  const double product = SumInOrder(this->Divide(), ranks) / corners;
  const auto share = static_cast<float>(former > 0.0 ? product / former : 0.0);
  for (int c = 0; c < components; ++c)
  {
    this->Transform.Inverse(
      this->Spectra[c],
      [&](int z, const double* values)
      {
        float* plane = p.Plane(c, z - this->Slab.Begin + 1);
        for (std::size_t x = 0; x < this->Slab.PlaneSize(); ++x)
        {
          plane[x] = static_cast<float>(values[x]) + share * plane[x];
        }
      },
      ranks);
    this->Spectra[c].clear();
  }
  return product;
}
}
