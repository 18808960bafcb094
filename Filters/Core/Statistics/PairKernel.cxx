// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/PairKernel.h"

#include "Geometry/SphereOverlap.h"
#include "VectorClones.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
RUC_VECTOR_CLONES
void Accumulate(int count, double alpha, const double* moment, double beta, const double* slope, double* sums)
{
  for (int n = 0; n < count; ++n)
  {
    sums[n] += alpha * moment[n] + beta * slope[n];
  }
}

// Two scalar products at once, each in eight interleaved partial sums so that the order is the same on every machine
RUC_VECTOR_CLONES
void Project(int count, const double* lambda, const double* moment, const double* slope, double* products)
{
  constexpr int Lanes = 8;
  double m[Lanes] = {};
  double s[Lanes] = {};
  int n = 0;
  for (; n + Lanes <= count; n += Lanes)
  {
    for (int l = 0; l < Lanes; ++l)
    {
      m[l] += lambda[n + l] * moment[n + l];
      s[l] += lambda[n + l] * slope[n + l];
    }
  }
  for (int l = 0; n < count; ++n, ++l)
  {
    m[l] += lambda[n] * moment[n];
    s[l] += lambda[n] * slope[n];
  }
  products[0] = products[1] = 0.0;
  for (int l = 0; l < Lanes; ++l)
  {
    products[0] += m[l];
    products[1] += s[l];
  }
}
}

PairKernel::PairKernel(double a, double b, const LagGrid& lags, double resolution, double cutoff)
  : Lags(lags)
  , Contact(a + b)
{
  const double widest = resolution * std::min(a, b);
  if (widest >= lags.Spacing)
  {
    this->LagsPerKnot = static_cast<int>(std::min(widest / lags.Spacing, double(lags.Count) + 1.0));
    this->Spacing = this->LagsPerKnot * lags.Spacing;
  }
  else
  {
    this->KnotsPerLag = static_cast<int>(std::ceil(lags.Spacing / widest));
    this->Spacing = lags.Spacing / this->KnotsPerLag;
  }
  const int contactKnot = static_cast<int>(std::ceil(this->Contact / this->Spacing));
  this->First = this->Contact - contactKnot * this->Spacing;
  // one interval more than is needed, so that rounding cannot put a distance behind the last
  this->Intervals = static_cast<int>(std::ceil((cutoff - this->First) / this->Spacing)) + 1;

  for (int m = 0; m < contactKnot; ++m)
  {
    const double d = this->First + m * this->Spacing;
    const int last = std::min(lags.Count, static_cast<int>((std::abs(d) + this->Contact) / lags.Spacing));
    OverlappingKnot knot;
    for (int k = 0; k <= last; ++k)
    {
      const AveragedOverlap g = OrientationAveragedOverlap(a, b, k * lags.Spacing, d);
      knot.Value.push_back(g.Value);
      knot.Slope.push_back(this->Spacing * g.Slope);
    }
    this->OverlappingKnots.push_back(std::move(knot));
  }
  for (int p = 0; p < std::max(this->KnotsPerLag, 1); ++p)
  {
    const double offset = this->First + p * this->Spacing;
    Phase phase;
    phase.FirstDifference = static_cast<int>(std::ceil((offset - this->Contact) / lags.Spacing));
    for (int n = phase.FirstDifference; n * lags.Spacing <= offset + this->Contact; ++n)
    {
      const double t = offset - n * lags.Spacing;
      phase.Moment.push_back(OverlapMoment(a, b, t));
      phase.Slope.push_back(this->Spacing * OverlapMomentSlope(a, b, t));
    }
    this->Phases.push_back(std::move(phase));
  }
}

void PairKernel::AddOverlap(const double* weights, double* sums) const
{
  std::vector<double> moments(this->Lags.Count + 1, 0.0); // 2 r times what the knots from a + b on add
  const int contactKnot = static_cast<int>(this->OverlappingKnots.size());
  for (int m = 0; m <= this->Intervals; ++m)
  {
    const double value = weights[2 * m];
    const double slope = weights[2 * m + 1];
    if (value == 0.0 && slope == 0.0)
    {
      continue;
    }
    if (m < contactKnot)
    {
      const OverlappingKnot& knot = this->OverlappingKnots[m];
      Accumulate(static_cast<int>(knot.Value.size()), value, knot.Value.data(), slope, knot.Slope.data(), sums);
      continue;
    }
    const double d = this->First + m * this->Spacing;
    const Phase& phase = this->Phases[this->PhaseOf(m)];
    const int lag = this->BaseLag(m) + phase.FirstDifference; // of the phase's first entry
    const int from = std::max(1 - lag, 0);
    const int to = std::min(static_cast<int>(phase.Moment.size()), this->Lags.Count + 1 - lag);
    if (from < to)
    {
      Accumulate(to - from, value / d - slope * this->Spacing / (d * d), &phase.Moment[from], slope / d, &phase.Slope[from],
        &moments[lag + from]);
    }
  }
  for (int k = 1; k <= this->Lags.Count; ++k)
  {
    sums[k] += moments[k] / (2.0 * k * this->Lags.Spacing);
  }
}

void PairKernel::AddPotential(const double* lambda, double* potential) const
{
  std::vector<double> scaled(this->Lags.Count + 1, 0.0);
  for (int k = 1; k <= this->Lags.Count; ++k)
  {
    scaled[k] = lambda[k] / (2.0 * k * this->Lags.Spacing);
  }
  double products[2];
  const int contactKnot = static_cast<int>(this->OverlappingKnots.size());
  for (int m = 0; m <= this->Intervals; ++m)
  {
    if (m < contactKnot)
    {
      const OverlappingKnot& knot = this->OverlappingKnots[m];
      Project(static_cast<int>(knot.Value.size()), lambda, knot.Value.data(), knot.Slope.data(), products);
      potential[2 * m] += products[0];
      potential[2 * m + 1] += products[1];
      continue;
    }
    const double d = this->First + m * this->Spacing;
    const Phase& phase = this->Phases[this->PhaseOf(m)];
    const int lag = this->BaseLag(m) + phase.FirstDifference;
    const int from = std::max(1 - lag, 0);
    const int to = std::min(static_cast<int>(phase.Moment.size()), this->Lags.Count + 1 - lag);
    if (from < to)
    {
      Project(to - from, &scaled[lag + from], &phase.Moment[from], &phase.Slope[from], products);
      potential[2 * m] += products[0] / d;
      potential[2 * m + 1] += products[1] / d - products[0] * this->Spacing / (d * d);
    }
  }
}

void PairKernel::AddOverlapPenalty(double factor, double* potential) const
{
  for (std::size_t m = 0; m < this->OverlappingKnots.size(); ++m)
  {
    const double overlap = this->Contact - (this->First + m * this->Spacing);
    potential[2 * m] += factor * overlap * overlap;
    potential[2 * m + 1] -= 2.0 * factor * overlap * this->Spacing;
  }
}
}
