// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SpectrumTerm.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Reconstruction/CellSurroundings.h"
#include "ruc/Statistics/PairSums/PairHistogram.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr int Degrees = HighestOfSpectrum - LowestOfSpectrum + 1;

// Spectra and forces of one centre, its radius being 1, are some hundreds at most where spheres
// overlap as little as in a search
constexpr double Most = 4096.0;
constexpr double SpectrumScale = 274877906944.0; // 2^38

MultipoleSettings FindSettings(const PackSpectrum& pack)
{
  MultipoleSettings settings;
  settings.CutOff = pack.CutOff;
  settings.Degree = HighestOfSpectrum;
  settings.WithFourth = false;
  return settings;
}

double MeanRadius(const CellFigures& cell)
{
  double cube = 0.0;
  for (std::size_t m = 0; m < cell.Share.size() && m < cell.Radius.size(); ++m)
  {
    cube += cell.Share[m] * std::pow(cell.Radius[m], 3);
  }
  return cube > 0.0 ? std::cbrt(cube) : cell.LargestRadius;
}

// Collects the spheres around the centre at a sorted place, and which they are
void Gather(const CellSurroundings& cell, std::size_t i, LocalMultipoles::Neighbours& around,
  std::vector<std::size_t>& spheres)
{
  around.Start(cell.RadiusOf(cell.SphereOf(i)));
  spheres.clear();
  cell.ForEachAround(i,
    [&](std::size_t j, double dx, double dy, double dz, double d2)
    {
      around.Add(dx, dy, dz, d2, cell.RadiusOf(j), 0);
      spheres.push_back(j);
    });
}
}

SpectrumTerm::SpectrumTerm(
  const CellContents& contents, const PackSpectrum& pack, Communicator& communicator)
  : Contents(contents)
  , Pack(pack)
  , Ranks(communicator)
  , Multipoles(FindSettings(pack))
  , Products(Multipoles)
{
  double cubes = 0.0;
  for (double radius : contents.Radii())
  {
    this->Share.push_back(radius * radius * radius);
    cubes += this->Share.back();
  }
  for (double& share : this->Share)
  {
    share /= cubes * 2.0 * (1.0 - contents.Fraction());
  }
}

double SpectrumTerm::Evaluate(const double* centres, double factor, double* gradient)
{
  const CellSurroundings cell(this->Contents, centres, this->Pack.CutOff);
  const std::vector<double> values = this->FindSpectrum(cell);
  double misfit = 0.0;
  std::vector<double> slopes;
  for (int l = 0; l < Degrees; ++l)
  {
    const double z = (values[l] - this->Pack.Value[l]) / this->Pack.Error[l];
    misfit += z * z / Degrees;
    slopes.push_back(2.0 * z / (this->Pack.Error[l] * Degrees));
  }
  if (gradient)
  {
    this->AddGradient(cell, slopes, factor, gradient);
  }
  return misfit;
}

std::vector<double> SpectrumTerm::FindSpectrum(const CellSurroundings& cell)
{
  const std::size_t size = this->Multipoles.Size();
  const double largest = *std::max_element(this->Share.begin(), this->Share.end());
  this->Sums.resize(size * cell.Size());
  const std::vector<std::int64_t> limbs = SumOverCentres(cell, 2 * Degrees, this->Ranks,
    [&](std::int64_t* own)
    {
      return [&, own, around = LocalMultipoles::Neighbours(this->Multipoles.GetSettings()),
               spheres = std::vector<std::size_t>()](std::size_t i) mutable
      {
        Gather(cell, i, around, spheres);
        double* const sums = &this->Sums[size * i];
        this->Multipoles.Sum(around, sums);
        double spectrum[Degrees];
        this->Products.Second(sums, 0, 0, spectrum);
        const double weight = this->Share[cell.SphereOf(i)] / largest;
        for (int l = 0; l < Degrees; ++l)
        {
          const double value = std::clamp(weight * spectrum[l], -Most, Most);
          AddWide(RoundToFixedPoint(value * SpectrumScale), own + 2 * l);
        }
      };
    });
  std::vector<double> values;
  for (int l = 0; l < Degrees; ++l)
  {
    values.push_back(WideValue(&limbs[2 * l]) / SpectrumScale * largest);
  }
  return values;
}

void SpectrumTerm::AddGradient(
  const CellSurroundings& cell, const std::vector<double>& slopes, double factor, double* gradient)
{
  double steepest = 0.0;
  for (double slope : slopes)
  {
    steepest = std::max(steepest, std::abs(slope));
  }
  if (steepest == 0.0)
  {
    return;
  }
  const std::size_t size = this->Multipoles.Size();
  const double largest = *std::max_element(this->Share.begin(), this->Share.end());
  const double unit = *std::max_element(this->Contents.Radius.begin(), this->Contents.Radius.end());
  // A sphere gets one force from each centre around it, and as its own the opposite of all others
  const double scale = PairHistogram::FixedPointScale(1, 2 * cell.MostNeighbours(), Most);
  const std::vector<std::int64_t> forces = SumOverCentres(cell, 3 * cell.Size(), this->Ranks,
    [&](std::int64_t* own)
    {
      return [&, own, around = LocalMultipoles::Neighbours(this->Multipoles.GetSettings()),
               spheres = std::vector<std::size_t>(), lambda = std::vector<double>(size),
               pushes = std::vector<double>()](std::size_t i) mutable
      {
        Gather(cell, i, around, spheres);
        const std::size_t sphere = cell.SphereOf(i);
        double mu[Degrees];
        for (int l = 0; l < Degrees; ++l)
        {
          mu[l] = slopes[l] / steepest * (this->Share[sphere] / largest) * unit;
        }
        std::fill(lambda.begin(), lambda.end(), 0.0);
        this->Products.AddGradient(&this->Sums[size * i], 0, 0, mu, lambda.data());
        pushes.resize(3 * spheres.size());
        this->Multipoles.FindForces(around, lambda.data(), pushes.data());
        AddPushes(sphere, spheres, pushes, Most, scale, own);
      };
    });
  const double back = factor * steepest * largest / unit / scale;
  for (std::size_t n = 0; n < forces.size(); ++n)
  {
    gradient[n] += back * static_cast<double>(forces[n]);
  }
}

Estimate EstimateSpectrumTerm(const CellFigures& cell)
{
  constexpr double secondsOfPair = 1e-7;
  const double radius = MeanRadius(cell);
  const double cutOff =
    SpectrumCutOff(2.0 * radius, 2.0 * cell.LargestRadius, cell.Density * SphereVolume(radius));
  const double pairs = cell.Spheres * cell.Density * SphereVolume(cutOff);
  constexpr double bytesOfSphere = 2.0 * HarmonicCount(HighestOfSpectrum) * sizeof(double);
  return { pairs * secondsOfPair, cell.Spheres * bytesOfSphere / BytesOfMegabyte, 0.0 };
}
}
