// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// The forces of LocalMultipoles
#include "ruc/Statistics/ThirdOrder/LaneFactors.h"
#include "ruc/Statistics/ThirdOrder/LocalMultipoles.h"

#include "ruc/Base/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
using Knot = std::array<double, 4>;

// Degrees that end alike: 2; to HighestOfFar; and above
constexpr int Bands = 3;

// The coefficients of one source: lambda of q_lm, and of the harmonics of one degree more that its
// gradients along x, y and z are made of
struct Coefficients
{
  const double* Lambda;
  std::array<std::vector<double>, 3> Turned;
};

// d/dz I_lm = -I_(l+1)m, d/dx I_lm = (I_(l+1)(m-1) - I_(l+1)(m+1)) / 2, d/dy I_lm = i (I_(l+1)(m-1)
// + I_(l+1)(m+1)) / 2, and I_(l+1)(-1) = -conj I_(l+1)1
Coefficients Turn(const double* lambda, int degree)
{
  Coefficients of{ lambda, {} };
  for (std::vector<double>& turned : of.Turned)
  {
    turned.assign(2 * HarmonicCount(degree + 1), 0.0);
  }
  auto& [x, y, z] = of.Turned;
  for (int l = LowestDegree; l <= degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      const int n = 2 * HarmonicPlace(l, m), same = 2 * HarmonicPlace(l + 1, m);
      const double real = lambda[n], imaginary = lambda[n + 1];
      z[same] -= real;
      z[same + 1] -= imaginary;
      const int up = same + 2, down = same - 2;
      if (m == 0)
      {
        x[up] -= real;
        y[up + 1] -= real;
        continue;
      }
      x[up] -= 0.5 * real;
      x[up + 1] -= 0.5 * imaginary;
      x[down] += 0.5 * real;
      x[down + 1] += 0.5 * imaginary;
      y[up + 1] -= 0.5 * real;
      y[up] += 0.5 * imaginary;
      y[down + 1] -= 0.5 * real;
      y[down] += 0.5 * imaginary;
    }
  }
  return of;
}

struct ForceKernel
{
  int Degree;
  double CutOff, NearCutOff; // in radii of the centre
  const Knot* Factors;       // null without Ewald's sum
  int Steps;
  const Coefficients& Of;

  void Add(
    const LocalMultipoles::Neighbours::List& list, int degree, double scale, double* forces) const;
  [[gnu::always_inline]] inline void FindEnds(const Lanes& r, Lanes* values, Lanes* slopes) const;
};

// Of every band the share of a term that is left, and its slope by r over r
inline void ForceKernel::FindEnds(const Lanes& r, Lanes* values, Lanes* slopes) const
{
  const double ends[Bands] = { this->CutOff, this->CutOff, this->NearCutOff };
  for (int band = 0; band < Bands; ++band)
  {
    const Lanes ratio = r * (1.0 / ends[band]);
    FindSmoothEnd(ratio, values[band]);
    FindSmoothSlope(ratio, slopes[band]);
    slopes[band] = slopes[band] / (ends[band] * r);
  }
  if (this->Factors)
  {
    const double toRatio = 1.0 / this->CutOff, perPlace = 2.0 * this->Steps * toRatio * toRatio;
    for (int k = 0; k < NumberOfLanes; ++k)
    {
      const double place = r[k] * toRatio * (r[k] * toRatio) * this->Steps;
      const int step = std::min(static_cast<int>(place), this->Steps - 1);
      const double t = place - step;
      const Knot &low = this->Factors[step], &high = this->Factors[step + 1];
      const double up = t * t * (3.0 - 2.0 * t);
      values[0][k] = (1.0 - up) * low[0] + up * high[0] + t * (1.0 - t) * (1.0 - t) * low[1] -
        t * t * (1.0 - t) * high[1];
      slopes[0][k] = perPlace *
        (6.0 * t * (1.0 - t) * (high[0] - low[0]) + (1.0 - t) * (1.0 - 3.0 * t) * low[1] +
          t * (3.0 * t - 2.0) * high[1]);
    }
  }
}

RUC_VECTOR_CLONES
void ForceKernel::Add(
  const LocalMultipoles::Neighbours::List& list, int degree, double scale, double* forces) const
{
  const int lowest[Bands + 1] = { LowestDegree, LowestDegree + 1, HighestOfFar + 1, degree + 1 };
  const double *gx = this->Of.Turned[0].data(), *gy = this->Of.Turned[1].data(),
               *gz = this->Of.Turned[2].data();
  for (std::size_t from = 0; from < list.X.size(); from += NumberOfLanes)
  {
    Lanes x, y, z, radius, r;
    LoadLanes(list, from, x, y, z, radius);
    const Lanes square = x * x + y * y + z * z;
    for (int k = 0; k < NumberOfLanes; ++k)
    {
      r[k] = std::sqrt(square[k]);
    }
    Lanes real[HarmonicCount(GreatestDegree + 1)], imaginary[HarmonicCount(GreatestDegree + 1)];
    FindHarmonics<Lanes>(degree + 1, x, y, z, 1.0 / r, real, imaginary);
    Lanes values[Bands], slopes[Bands], force[3] = {};
    this->FindEnds(r, values, slopes);
    for (int band = 0; band < Bands; ++band)
    {
      Lanes along[3] = {}, whole = {};
      const int end = std::min(lowest[band + 1], degree + 1);
      for (int n = HarmonicPlace(lowest[band] + 1, 0); n < HarmonicPlace(end + 1, 0); ++n)
      {
        along[0] += gx[2 * n] * real[n] + gx[2 * n + 1] * imaginary[n];
        along[1] += gy[2 * n] * real[n] + gy[2 * n + 1] * imaginary[n];
        along[2] += gz[2 * n] * real[n] + gz[2 * n + 1] * imaginary[n];
      }
      for (int n = HarmonicPlace(lowest[band], 0); n < HarmonicPlace(end, 0); ++n)
      {
        whole += this->Of.Lambda[2 * n] * real[n] + this->Of.Lambda[2 * n + 1] * imaginary[n];
      }
      whole *= slopes[band];
      force[0] += values[band] * along[0] + whole * x;
      force[1] += values[band] * along[1] + whole * y;
      force[2] += values[band] * along[2] + whole * z;
    }
    const Lanes cube = radius * radius * radius * scale;
    const std::size_t size = std::min<std::size_t>(NumberOfLanes, list.X.size() - from);
    for (std::size_t k = 0; k < size; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        forces[3 * list.Order[from + k] + axis] = cube[k] * force[axis][k];
      }
    }
  }
}
}

void LocalMultipoles::FindForces(
  const Neighbours& around, const double* lambda, double* forces) const
{
  const int degree = this->Settings.Degree, steps = static_cast<int>(this->Factors.size()) - 1;
  for (int source = 0; source < this->Settings.Sources; ++source)
  {
    const Coefficients of = Turn(lambda + source * this->SizeOfSource(), degree);
    const ForceKernel kernel = { degree, this->Settings.CutOff * around.Inverse,
      this->Settings.NearCutOff() * around.Inverse,
      this->Factors.empty() ? nullptr : this->Factors.data(), steps, of };
    kernel.Add(around.Near[source], degree, around.Inverse, forces);
    kernel.Add(around.Far[source], std::min(HighestOfFar, degree), around.Inverse, forces);
  }
}
}
