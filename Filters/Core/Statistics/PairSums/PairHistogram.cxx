// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairHistogram.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr double MostNumbers = 1 << 30; // half of what 31 bits hold, as the numbers are estimated
}

PairHistogram::PairHistogram(
  std::vector<SphereType> types, const LagGrid& lags, const KnotResolution& resolution)
  : Types(std::move(types))
{
  const double size = EstimateSize(this->Types, lags, resolution);
  if (!(size < MostNumbers))
  {
    throw std::invalid_argument(
      Text("The radii of the modes require tables of at most ", MostNumbers, " numbers, got ", size,
        ": the smallest spheres are too small beside the largest and the last lag. Leave them out, "
        "or "
        "take a smaller MaximumLag."));
  }
  const int count = this->NumberOfTypes();
  this->Lookups.resize(count * count);
  this->ClassBegin.push_back(0);
  for (int p = 0; p < count; ++p)
  {
    for (int q = p; q < count; ++q)
    {
      // The last interval lies where g is 0. It takes the pairs that are too far apart to matter.
      const double a = this->Types[p].Radius, b = this->Types[q].Radius;
      const double spacing = PairKernel::KnotSpacing(std::min(a, b), lags, resolution);
      this->Kernels.emplace_back(a, b, lags, lags.Maximum() + a + b + spacing, resolution);
      const PairKernel& kernel = this->Kernels.back();
      for (int place : { p * count + q, q * count + p })
      {
        this->Lookups[place] = { 1.0 / kernel.Spacing, -kernel.First / kernel.Spacing,
          kernel.Intervals - 0.5, static_cast<std::int32_t>(this->ClassBegin.back()) };
      }
      this->ClassTypes.emplace_back(p, q);
      this->ClassBegin.push_back(this->ClassBegin.back() + kernel.Size());
    }
  }
}

double PairHistogram::EstimateSize(
  const std::vector<SphereType>& types, const LagGrid& lags, const KnotResolution& resolution)
{
  double numbers = 0.0;
  for (const SphereType& a : types)
  {
    for (const SphereType& b : types)
    {
      const double spacing =
        PairKernel::KnotSpacing(std::min(a.Radius, b.Radius), lags, resolution);
      // Two numbers for each knot, but classes are unordered and met twice here
      numbers += (lags.Maximum() + a.Radius + b.Radius) / spacing;
    }
  }
  return numbers;
}

double PairHistogram::EstimateTables(
  const std::vector<SphereType>& types, const LagGrid& lags, const KnotResolution& resolution)
{
  double bytes = 0.0;
  for (std::size_t p = 0; p < types.size(); ++p)
  {
    for (std::size_t q = p; q < types.size(); ++q)
    {
      bytes += PairKernel::TableBytes(types[p].Radius, types[q].Radius, lags, resolution);
    }
  }
  return bytes;
}

double PairHistogram::FixedPointScale(
  std::int64_t spheres, std::int64_t mostNeighbours, double heaviest)
{
  const double most = heaviest * static_cast<double>(spheres) * static_cast<double>(mostNeighbours);
  return std::ldexp(1.0, std::min(61 - std::ilogb(most), 49 - std::ilogb(heaviest)));
}
}
