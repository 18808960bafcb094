// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/MultipoleProducts.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// The factors of A^2, A q and q^2 in X_l
struct FourthFactors
{
  explicit FourthFactors(double l)
  {
    const double four = 3.0 * l * (l - 1) * (l - 2) * (l - 3) * (2 * l - 1) * (2 * l - 3);
    const double three = 48.0 / 7.0 * (l + 1) * l * (l - 1) * (l - 2);
    this->AA = four;
    this->AQ = 2.0 * four / (2 * l - 3);
    this->QQ = four / ((2 * l - 5) * (2 * l - 1)) + three / ((2 * l - 5) * (2 * l + 3));
  }
  double AA, AQ, QQ;
};

double Power(double base, int exponent)
{
  double power = 1.0;
  for (; exponent > 0; exponent /= 2)
  {
    power *= exponent % 2 > 0 ? base : 1.0;
    base *= base;
  }
  return power;
}
}

MultipoleProducts::MultipoleProducts(const LocalMultipoles& multipoles)
  : Multipoles(multipoles)
{
  for (int l = 0; l <= multipoles.GetSettings().Degree; ++l)
  {
    for (int m = 0; m <= l; ++m)
    {
      this->Weights.push_back(HarmonicWeight(l, m));
    }
  }
}

double MultipoleProducts::Product(const double* a, const double* b, int l) const
{
  double sum = 0.0;
  for (int n = HarmonicPlace(l, 0); n <= HarmonicPlace(l, l); ++n)
  {
    sum += this->Weights[n] * (a[2 * n] * b[2 * n] + a[2 * n + 1] * b[2 * n + 1]);
  }
  return sum;
}

void MultipoleProducts::Second(const double* sums, int s, int t, double* ofDegrees) const
{
  const std::size_t size = this->Multipoles.SizeOfSource();
  for (int l = 2; l <= this->Multipoles.GetSettings().Degree; ++l)
  {
    ofDegrees[l - 2] = l * (l - 1.0) * this->Product(sums + s * size, sums + t * size, l);
  }
}

void MultipoleProducts::AddGradient(
  const double* sums, int s, int t, const double* mu, double* gradient) const
{
  const std::size_t ofS = s * this->Multipoles.SizeOfSource();
  const std::size_t ofT = t * this->Multipoles.SizeOfSource();
  for (int l = 2; l <= this->Multipoles.GetSettings().Degree; ++l)
  {
    for (int n = 2 * HarmonicPlace(l, 0); n < 2 * HarmonicPlace(l + 1, 0); ++n)
    {
      const double factor = mu[l - 2] * l * (l - 1.0) * this->Weights[n / 2];
      gradient[ofS + n] += factor * sums[ofT + n];
      gradient[ofT + n] += factor * sums[ofS + n];
    }
  }
}

double MultipoleProducts::Fourth(const double* sums, int s, int t) const
{
  if (!this->Multipoles.GetSettings().WithFourth)
  {
    return 0.0;
  }
  const double *q = sums + s * this->Multipoles.SizeOfSource(),
               *p = sums + t * this->Multipoles.SizeOfSource();
  const double *a = q + this->Multipoles.Count(), *b = p + this->Multipoles.Count();
  double sum = 0.0;
  for (int l = 3; l <= this->Multipoles.GetSettings().Degree; ++l)
  {
    const FourthFactors factors(l);
    sum += factors.AA * this->Product(a, b, l) +
      0.5 * factors.AQ * (this->Product(a, p, l) + this->Product(q, b, l)) +
      factors.QQ * this->Product(q, p, l);
  }
  return sum;
}

MultipoleRest FindMultipoleRest(double t, double ratio, int degree, bool withFourth)
{
  constexpr double least = 1e-9;
  const double cube = ratio * ratio * ratio, touching = 1.0 / ((1.0 + ratio) * (1.0 + ratio));
  t = std::min(t, touching);
  const double first = degree + 1.0;
  double power = cube * cube * Power(t, degree + 2); // a_j^6 r^(-2l-2)
  if (power * Power(first, 6) < least)
  {
    return {};
  }
  // sum over l >= n of l (l - 1) t^l = t^n [n (n - 1)(1 - t)^2 + 2 n t (1 - t) + 2 t^2] / (1 - t)^3
  const double left = 1.0 - t;
  MultipoleRest rest;
  rest.Second = power *
    (first * (first - 1.0) * left * left + 2.0 * first * t * left + 2.0 * t * t) /
    (left * left * left);
  for (double l = first; withFourth && power * Power(l, 6) >= least; ++l)
  {
    const FourthFactors factors(l);
    const double a = ratio * ratio / 5.0 - 1.0 / (t * (2.0 * l - 1.0));
    rest.Fourth += power * (factors.AA * a * a + factors.AQ * a + factors.QQ);
    power *= t;
  }
  return rest;
}
}
