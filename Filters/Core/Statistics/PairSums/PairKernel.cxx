// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairKernel.h"

#include "ruc/Base/VectorClones.h"
#include "ruc/Particles/SphereOverlap.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
RUC_VECTOR_CLONES
void Accumulate(int count, double alpha, const double* moment, double beta, const double* slope,
  int step, double* sums)
{
  if (step > 0)
  {
    for (int n = 0; n < count; ++n)
    {
      sums[n] += alpha * moment[n] + beta * slope[n];
    }
  }
  else
  {
    for (int n = 0; n < count; ++n)
    {
      sums[n] -= alpha * moment[-n] + beta * slope[-n];
    }
  }
}

// Adds two scalar products, each in eight interleaved partial sums, so that the order is the same
// on every machine
RUC_VECTOR_CLONES
void Project(int count, const double* lambda, const double* moment, const double* slope, int step,
  double* products)
{
  constexpr int Lanes = 8;
  double m[Lanes] = {};
  double s[Lanes] = {};
  int n = 0;
  if (step > 0)
  {
    for (; n + Lanes <= count; n += Lanes)
    {
      for (int l = 0; l < Lanes; ++l)
      {
        m[l] += lambda[n + l] * moment[n + l];
        s[l] += lambda[n + l] * slope[n + l];
      }
    }
  }
  for (; n < count; ++n)
  {
    m[n % Lanes] += lambda[n] * moment[step * n];
    s[n % Lanes] += lambda[n] * slope[step * n];
  }
  for (int l = 0; l < Lanes; ++l)
  {
    products[0] += step * m[l];
    products[1] += step * s[l];
  }
}
}

double PairKernel::KnotSpacing(
  double smallerRadius, const LagGrid& lags, const KnotResolution& resolution)
{
  const double finest = resolution.Finest * smallerRadius;
  return lags.Spacing < finest
    ? lags.Spacing * std::floor(finest / lags.Spacing)
    : lags.Spacing / std::ceil(lags.Spacing / (resolution.Coarsest * smallerRadius));
}

double PairKernel::TableBytes(
  double a, double b, const LagGrid& lags, const KnotResolution& resolution)
{
  const double step = std::min(lags.Spacing, KnotSpacing(std::min(a, b), lags, resolution));
  return 2.0 * sizeof(double) * 2.0 * (a + b) / step;
}

PairKernel::PairKernel(
  double a, double b, const LagGrid& lags, double cutoff, const KnotResolution& resolution)
  : Spacing(KnotSpacing(std::min(a, b), lags, resolution))
  , Lags(lags)
  , RadiusA(a)
  , RadiusB(b)
{
  if (this->Spacing > 1.5 * lags.Spacing)
  {
    this->LagsPerKnot = static_cast<int>(std::lround(this->Spacing / lags.Spacing));
  }
  else
  {
    this->KnotsPerLag = static_cast<int>(std::lround(lags.Spacing / this->Spacing));
  }
  const double contact = a + b;
  this->ContactKnot = static_cast<int>(std::ceil(contact / this->Spacing));
  this->First = contact - this->ContactKnot * this->Spacing;
  // One interval more than is needed, so that rounding cannot put a distance behind the last
  this->Intervals = static_cast<int>(std::ceil((cutoff - this->First) / this->Spacing)) + 1;

  for (int p = 0; p < std::max(this->KnotsPerLag, 1); ++p)
  {
    const double offset = this->First + p * this->Spacing;
    Phase phase;
    phase.First = static_cast<int>(std::ceil((offset - contact) / lags.Spacing));
    for (int n = phase.First; n * lags.Spacing <= offset + contact; ++n)
    {
      const double t = offset - n * lags.Spacing;
      phase.Moment.push_back(OverlapMoment(a, b, t));
      phase.Slope.push_back(this->Spacing * OverlapMomentSlope(a, b, t));
    }
    this->Phases.push_back(std::move(phase));
  }
}

PairKernel::Factors PairKernel::FactorsOf(double d) const
{
  // Closer to 0 the quotients below lose more digits than the error of the limit, 2 r g -> 2 r
  // V_ab(r) = 2 dh/dt at t = -r
  if (std::abs(d) < 1e-5 * std::min(this->RadiusA, this->RadiusB))
  {
    return { 0.0, 2.0 / this->Spacing, 0.0, 0.0, false };
  }
  return { 1.0 / d, 0.0, -this->Spacing / (d * d), 1.0 / d, d < this->RadiusA + this->RadiusB };
}

template <class Visit>
void PairKernel::ForEachStretch(int knot, bool sum, Visit&& visit) const
{
  const int base = this->LagsPerKnot > 0 ? knot * this->LagsPerKnot : knot / this->KnotsPerLag;
  const Phase& phase = this->Phases[this->LagsPerKnot > 0 ? 0 : knot % this->KnotsPerLag];
  const int entries = static_cast<int>(phase.Moment.size());
  // d - r_k: n = k - base
  const int from = std::max(1, base + phase.First);
  const int to = std::min(this->Lags.Count + 1, base + phase.First + entries);
  if (from < to)
  {
    const int entry = from - base - phase.First;
    visit(from, &phase.Moment[entry], &phase.Slope[entry], to - from, 1);
  }
  // d + r_k: n = -k - base
  const int last = std::min(this->Lags.Count, -base - phase.First);
  if (sum && last >= 1)
  {
    const int entry = -1 - base - phase.First;
    visit(1, &phase.Moment[entry], &phase.Slope[entry], last, -1);
  }
}

void PairKernel::AddOverlap(const double* weights, double* sums) const
{
  std::vector<double> moments(this->Lags.Count + 1, 0.0); // sums of 2 r g
  for (int m = 0; m <= this->Intervals; ++m)
  {
    const double value = weights[2 * m];
    const double slope = weights[2 * m + 1];
    if (value == 0.0 && slope == 0.0)
    {
      continue;
    }
    const double d = this->First + m * this->Spacing;
    const Factors f = this->FactorsOf(d);
    const double alpha = value * f.ValueOfMoment + slope * f.SlopeOfMoment;
    const double beta = value * f.ValueOfSlope + slope * f.SlopeOfSlope;
    this->ForEachStretch(m, f.Sum,
      [&](int lag, const double* moment, const double* momentSlope, int count, int step)
      { Accumulate(count, alpha, moment, beta, momentSlope, step, &moments[lag]); });
    if (m < this->ContactKnot)
    {
      const AveragedOverlap g = OrientationAveragedOverlap(this->RadiusA, this->RadiusB, 0.0, d);
      sums[0] += value * g.Value + slope * this->Spacing * g.Slope;
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
  for (int m = 0; m <= this->Intervals; ++m)
  {
    const double d = this->First + m * this->Spacing;
    const Factors f = this->FactorsOf(d);
    double products[2] = { 0.0, 0.0 };
    this->ForEachStretch(m, f.Sum,
      [&](int lag, const double* moment, const double* momentSlope, int count, int step)
      { Project(count, &scaled[lag], moment, momentSlope, step, products); });
    potential[2 * m] += f.ValueOfMoment * products[0] + f.ValueOfSlope * products[1];
    potential[2 * m + 1] += f.SlopeOfMoment * products[0] + f.SlopeOfSlope * products[1];
    if (m < this->ContactKnot && lambda[0] != 0.0)
    {
      const AveragedOverlap g = OrientationAveragedOverlap(this->RadiusA, this->RadiusB, 0.0, d);
      potential[2 * m] += lambda[0] * g.Value;
      potential[2 * m + 1] += lambda[0] * this->Spacing * g.Slope;
    }
  }
}

void PairKernel::AddOverlapPenalty(double factor, double contact, double* potential) const
{
  for (int m = 0; m <= this->Intervals; ++m)
  {
    const double overlap = contact - (this->First + m * this->Spacing);
    if (!(overlap > 1e-12 * contact)) // a contact that is a knot is one but for rounding
    {
      return;
    }
    potential[2 * m] += factor * overlap * overlap;
    potential[2 * m + 1] -= 2.0 * factor * overlap * this->Spacing;
  }
}
}
