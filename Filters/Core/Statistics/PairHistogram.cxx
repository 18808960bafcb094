// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/PairHistogram.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
PairHistogram::PairHistogram(std::vector<SphereType> types, const LagGrid& lags, double resolution)
  : Types(std::move(types))
{
  const int count = this->NumberOfTypes();
  double largest = 0.0;
  for (const SphereType& type : this->Types)
  {
    largest = std::max(largest, type.Radius);
  }
  this->Cutoff = lags.Maximum() + 2.0 * largest;
  this->Lookups.resize(count * count);
  this->ClassBegin.push_back(0);
  for (int p = 0; p < count; ++p)
  {
    for (int q = p; q < count; ++q)
    {
      this->Kernels.emplace_back(this->Types[p].Radius, this->Types[q].Radius, lags, resolution, this->Cutoff);
      const PairKernel& kernel = this->Kernels.back();
      for (int place : { p * count + q, q * count + p })
      {
        this->Lookups[place] = { 1.0 / kernel.Spacing, -kernel.First / kernel.Spacing,
          static_cast<std::int32_t>(this->ClassBegin.back()) };
      }
      this->ClassTypes.emplace_back(p, q);
      this->ClassBegin.push_back(this->ClassBegin.back() + kernel.Size());
    }
  }
}

double PairHistogram::EstimateBytes(const std::vector<SphereType>& types, const LagGrid& lags, double resolution)
{
  double numbers = 0.0;
  for (const SphereType& a : types)
  {
    for (const SphereType& b : types)
    {
      const double spacing = resolution * std::min(a.Radius, b.Radius);
      const double knots = (lags.Maximum() + a.Radius + b.Radius) / spacing + 3.0;
      // histogram, and the tables of a kernel: overlapping knots x lags, phases x lags
      numbers += 0.5 *
        (2.0 * knots + (a.Radius + b.Radius) / spacing * 2.0 * (2.0 * (a.Radius + b.Radius) / lags.Spacing + 1.0) +
          2.0 * std::max(lags.Spacing / spacing, 1.0) * (2.0 * (a.Radius + b.Radius) / lags.Spacing + 2.0));
    }
  }
  return 8.0 * numbers;
}

double PairHistogram::FixedPointScale(std::int64_t spheres, std::int64_t mostNeighbours, double heaviest)
{
  const double most = heaviest * static_cast<double>(spheres) * static_cast<double>(mostNeighbours);
  return std::ldexp(1.0, std::min(61 - std::ilogb(most), 49 - std::ilogb(heaviest)));
}
}
