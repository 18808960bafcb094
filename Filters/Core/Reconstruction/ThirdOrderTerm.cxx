// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/ThirdOrderTerm.h"

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
// T of one centre, and a force in the unit of AddGradient, are some ten at most where spheres
// overlap as little as in a search
constexpr double Most = 1024.0;

// Scatter below this share of the largest is rounding
constexpr double LeastError = 1e-9;
}

ThirdOrderTerm::ThirdOrderTerm(const CellContents& contents, const NeighbourhoodMultipoles& pack,
  Communicator& communicator, std::size_t mostKept)
  : Contents(contents)
  , Pack(pack)
  , Ranks(communicator)
  , Shells(pack.Shells)
  , Centres(pack.Shells.Classes, 0.0)
  , KeptAtMost(mostKept)
{
  for (std::size_t type = 0; type < contents.Count.size(); ++type)
  {
    const int mode = contents.ModeOf(static_cast<int>(type));
    this->Centres[pack.ClassOfMode[mode - 1]] += contents.Count[type];
  }
}

double ThirdOrderTerm::Evaluate(const double* centres, double factor, double* gradient)
{
  const double largest =
    *std::max_element(this->Contents.Radius.begin(), this->Contents.Radius.end());
  const CellSurroundings cell(
    this->Contents, centres, this->Pack.Shells.Distances.back() + 2.0 * largest);
  const std::vector<double> values = this->FindValues(cell, gradient != nullptr);
  const std::vector<double>& errors = this->Pack.Error;
  const double least = LeastError * *std::max_element(errors.begin(), errors.end());
  double misfit = 0.0, count = 0.0;
  std::vector<double> slopes(values.size(), 0.0);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    if (errors[n] > least)
    {
      const double z = (values[n] - this->Pack.Value[n]) / errors[n];
      misfit += z * z;
      slopes[n] = 2.0 * z / errors[n];
      count += 1.0;
    }
  }
  if (gradient && count > 0.0)
  {
    this->AddGradient(cell, slopes, factor / count, gradient);
  }
  return misfit / std::max(count, 1.0);
}

int ThirdOrderTerm::ClassOf(const CellSurroundings& cell, std::size_t sphere) const
{
  return this->Pack.ClassOfMode[cell.ModeOf(sphere) - 1];
}

void ThirdOrderTerm::Gather(const CellSurroundings& cell, std::size_t i,
  std::vector<ShellMultipoles::Neighbour>& around, std::vector<std::size_t>& spheres) const
{
  around.clear();
  spheres.clear();
  const double reach = cell.RadiusOf(cell.SphereOf(i)) + this->Pack.Shells.Distances.back();
  cell.ForEachAround(i,
    [&](std::size_t j, double dx, double dy, double dz, double d2)
    {
      const double d = std::sqrt(d2), radius = cell.RadiusOf(j);
      if (d - radius < reach)
      {
        around.push_back({ { dx / d, dy / d, dz / d }, d, radius, this->ClassOf(cell, j) });
        spheres.push_back(j);
      }
    });
}

// Where the multipoles of a centre are kept, or null
double* ThirdOrderTerm::KeptOf(std::size_t i)
{
  return this->Kept.empty() ? nullptr : &this->Kept[i / this->Ranks.Size() * this->Shells.Size()];
}

std::vector<double> ThirdOrderTerm::FindValues(const CellSurroundings& cell, bool keeps)
{
  const std::size_t needed = (cell.Size() / this->Ranks.Size() + 1) * this->Shells.Size();
  this->Kept.resize(keeps && needed <= this->KeptAtMost ? needed : 0);
  const std::size_t products = this->Pack.Shells.NumberOfProducts();
  const double scale = PairHistogram::FixedPointScale(1, cell.Size(), Most);
  const std::vector<std::int64_t> sums = SumOverCentres(cell, this->Pack.Value.size(), this->Ranks,
    [&](std::int64_t* own)
    {
      return [&, own, around = std::vector<ShellMultipoles::Neighbour>(),
               spheres = std::vector<std::size_t>(), single = AlignedNumbers(this->Shells.Size()),
               values = std::vector<double>(products)](std::size_t i) mutable
      {
        const std::size_t sphere = cell.SphereOf(i);
        double* const kept = this->KeptOf(i);
        double* const multipoles = kept ? kept : single.data();
        this->Gather(cell, i, around, spheres);
        this->Shells.Sum(cell.RadiusOf(sphere), around, multipoles);
        this->Shells.FindProducts(multipoles, values.data());
        AddFixedPoint(
          values.data(), products, Most, scale, own + this->ClassOf(cell, sphere) * products);
      };
    });
  std::vector<double> values;
  for (std::size_t n = 0; n < sums.size(); ++n)
  {
    values.push_back(static_cast<double>(sums[n]) / scale / this->Centres[n / products]);
  }
  return values;
}

void ThirdOrderTerm::AddGradient(
  const CellSurroundings& cell, const std::vector<double>& slopes, double factor, double* gradient)
{
  const std::size_t products = this->Pack.Shells.NumberOfProducts();
  double squares = 0.0;
  for (double slope : slopes)
  {
    squares += slope * slope;
  }
  if (squares == 0.0)
  {
    return;
  }
  // The slopes are those of means over the centres of a class. Scaled to a sum of squares of 1, and
  // with the first distance as the unit of length, they give forces of about 1.
  const double length = this->Pack.Shells.Distances.front(), steep = std::sqrt(squares);
  const double fewest = *std::min_element(this->Centres.begin(), this->Centres.end());
  std::vector<AlignedNumbers> factors; // of every class of the centre
  for (int r = 0; r < this->Pack.Shells.Classes; ++r)
  {
    std::vector<double> mu(slopes.begin() + r * products, slopes.begin() + (r + 1) * products);
    for (double& slope : mu)
    {
      slope *= length / steep * fewest / this->Centres[r];
    }
    factors.push_back(this->Shells.MakeFactors(mu.data()));
  }
  const double scale = PairHistogram::FixedPointScale(1, 2 * cell.MostNeighbours(), Most);
  const std::vector<std::int64_t> forces = SumOverCentres(cell, 3 * cell.Size(), this->Ranks,
    [&](std::int64_t* own)
    {
      return [&, own, around = std::vector<ShellMultipoles::Neighbour>(),
               spheres = std::vector<std::size_t>(), single = AlignedNumbers(this->Shells.Size()),
               lambda = AlignedNumbers(this->Shells.Size()),
               pushes = std::vector<double>()](std::size_t i) mutable
      {
        const std::size_t sphere = cell.SphereOf(i);
        const int r = this->ClassOf(cell, sphere);
        this->Gather(cell, i, around, spheres);
        const double* const kept = this->KeptOf(i);
        if (!kept)
        {
          this->Shells.Sum(cell.RadiusOf(sphere), around, single.data());
        }
        this->Shells.FindGradient(kept ? kept : single.data(), factors[r].data(), lambda.data());
        pushes.resize(3 * around.size());
        this->Shells.FindForces(cell.RadiusOf(sphere), around, lambda.data(), pushes.data());
        AddPushes(sphere, spheres, pushes, Most, scale, own);
      };
    });
  const double back = factor * steep / length / fewest / scale;
  for (std::size_t n = 0; n < forces.size(); ++n)
  {
    gradient[n] += back * static_cast<double>(forces[n]);
  }
}

Estimate EstimateThirdOrderTerm(const CellFigures& cell, const NeighbourhoodSettings& settings)
{
  constexpr double secondsOfPair = 2.5e-7, secondsOfProduct = 3e-9;
  const std::vector<double> distances =
    settings.Distances.empty() ? AutomaticShells(2.0 * cell.LargestRadius) : settings.Distances;
  const ShellSettings shells = { distances, settings.Degree, settings.Classes };
  const double reach = distances.back() + 2.0 * cell.LargestRadius;
  const double pairs = cell.Spheres * cell.Density * SphereVolume(reach);
  const double products = static_cast<double>(shells.NumberOfProducts());
  const double kept =
    std::min(cell.Spheres * ShellMultipoles(shells).Size(), double(ThirdOrderTerm::MostKept));
  return { pairs * secondsOfPair + cell.Spheres * products * secondsOfProduct,
    8.0 * (4.0 * settings.Classes * products + kept) / BytesOfMegabyte, 0.0 };
}
}
