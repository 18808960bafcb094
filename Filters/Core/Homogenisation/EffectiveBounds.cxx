// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

double Mean(const std::vector<double>& fractions, const std::vector<double>& values)
{
  return std::inner_product(fractions.begin(), fractions.end(), values.begin(), 0.0);
}

// [sum c / (a + y)]^-1 - y; a phase of which there is nothing does not count
double Shifted(
  const std::vector<double>& fractions, const std::vector<double>& values, double shift)
{
  double sum = 0.0;
  for (std::size_t r = 0; r < values.size(); ++r)
  {
    sum += fractions[r] > 0.0 ? fractions[r] / (values[r] + shift) : 0.0;
  }
  return 1.0 / sum - shift;
}

PropertyBounds MakeBounds(const std::vector<double>& fractions, const std::vector<double>& values,
  double leastShift, double greatestShift)
{
  return { Mean(fractions, values), Shifted(fractions, values, 0.0),
    Shifted(fractions, values, leastShift), Shifted(fractions, values, greatestShift), Unknown,
    Unknown, Unknown, Unknown, Unknown };
}

double ShearShift(double bulk, double shear)
{
  return shear * (9.0 * bulk + 8.0 * shear) / (6.0 * (bulk + 2.0 * shear));
}

struct Columns
{
  explicit Columns(const std::vector<ElasticModuli>& moduli)
  {
    for (const ElasticModuli& of : moduli)
    {
      this->Bulk.push_back(of.Bulk);
      this->Shear.push_back(of.Shear);
    }
  }
  std::vector<double> Bulk, Shear;
};
double Least(const std::vector<double>& values)
{
  return *std::min_element(values.begin(), values.end());
}
double Greatest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

// <a> - c1 c2 (a2 - a1)^2 / (c1 a2 + c2 a1 + y) for the fraction c of phase 2
double ThirdOrder(double c, double a1, double a2, double shift)
{
  const double apart = a2 - a1;
  const double below = (1.0 - c) * a2 + c * a1 + shift;
  return (1.0 - c) * a1 + c * a2 - (below > 0.0 ? (1.0 - c) * c * apart * apart / below : 0.0);
}

// Sets the bounds by shifts(zeta, eta), which returns the lower and the upper one
template <class Shifts>
void SetThirdOrder(double c, double a1, double a2, const TwoPhaseParameters& of, Shifts&& shifts,
  PropertyBounds& bounds)
{
  const auto at = [&](double zeta, double eta)
  {
    const std::pair<double, double> shift = shifts(zeta, eta);
    return std::pair(ThirdOrder(c, a1, a2, shift.first), ThirdOrder(c, a1, a2, shift.second));
  };
  std::tie(bounds.ThirdOrderLower, bounds.ThirdOrderUpper) = at(of.Zeta, of.Eta);
  // Differences over a millionth: the bounds are smooth functions
  constexpr double step = 1e-6;
  const auto inZeta = at(of.Zeta + step, of.Eta), inEta = at(of.Zeta, of.Eta + step);
  const auto error = [&](double here, double alongZeta, double alongEta)
  {
    return std::hypot((alongZeta - here) / step * of.ZetaError,
      alongEta == here ? 0.0 : (alongEta - here) / step * of.EtaError);
  };
  bounds.ThirdOrderLowerError = error(bounds.ThirdOrderLower, inZeta.first, inEta.first);
  bounds.ThirdOrderUpperError = error(bounds.ThirdOrderUpper, inZeta.second, inEta.second);
}
}

ElasticModuli ModuliOf(double young, double poisson)
{
  return { young / (3.0 * (1.0 - 2.0 * poisson)), young / (2.0 * (1.0 + poisson)) };
}

PropertyBounds BoundConductivity(
  const std::vector<double>& fractions, const std::vector<double>& conductivities)
{
  return MakeBounds(
    fractions, conductivities, 2.0 * Least(conductivities), 2.0 * Greatest(conductivities));
}

PropertyBounds BoundBulk(
  const std::vector<double>& fractions, const std::vector<ElasticModuli>& moduli)
{
  const Columns of(moduli);
  return MakeBounds(
    fractions, of.Bulk, 4.0 / 3.0 * Least(of.Shear), 4.0 / 3.0 * Greatest(of.Shear));
}

PropertyBounds BoundShear(
  const std::vector<double>& fractions, const std::vector<ElasticModuli>& moduli)
{
  const Columns of(moduli);
  return MakeBounds(fractions, of.Shear, ShearShift(Least(of.Bulk), Least(of.Shear)),
    ShearShift(Greatest(of.Bulk), Greatest(of.Shear)));
}

void AddThirdOrderConductivity(
  double c, double matrix, double spheres, const TwoPhaseParameters& of, PropertyBounds& bounds)
{
  SetThirdOrder(
    c, matrix, spheres, of,
    [&](double zeta, double)
    {
      const double harmonic = 1.0 / ((1.0 - zeta) / matrix + zeta / spheres);
      return std::pair(2.0 * harmonic, 2.0 * ((1.0 - zeta) * matrix + zeta * spheres));
    },
    bounds);
  const double b = (spheres - matrix) / (spheres + 2.0 * matrix);
  const double w = 2.0 * (1.0 - c) * of.Zeta * b * b;
  bounds.Estimate = matrix * (1.0 + 2.0 * c * b - w) / (1.0 - c * b - w);
}

void AddThirdOrderBulk(double c, const ElasticModuli& matrix, const ElasticModuli& spheres,
  const TwoPhaseParameters& of, PropertyBounds& bounds)
{
  const double g1 = matrix.Shear, g2 = spheres.Shear, k1 = matrix.Bulk, k2 = spheres.Bulk;
  SetThirdOrder(
    c, k1, k2, of,
    [&](double zeta, double)
    {
      return std::pair(
        4.0 / 3.0 / ((1.0 - zeta) / g1 + zeta / g2), 4.0 / 3.0 * ((1.0 - zeta) * g1 + zeta * g2));
    },
    bounds);
  const double kappa = (k2 - k1) / (k2 + 4.0 / 3.0 * g1);
  const double mu = (g2 - g1) / (g2 + ShearShift(k1, g1));
  const double e =
    c * kappa / (1.0 - 10.0 * g1 * kappa * mu * (1.0 - c) * of.Zeta / (3.0 * (k1 + 2.0 * g1)));
  bounds.Estimate = (k1 + 4.0 / 3.0 * g1 * e) / (1.0 - e);
}

void AddThirdOrderShear(double c, const ElasticModuli& matrix, const ElasticModuli& spheres,
  const TwoPhaseParameters& of, PropertyBounds& bounds)
{
  const double g1 = matrix.Shear, g2 = spheres.Shear, k1 = matrix.Bulk, k2 = spheres.Bulk;
  SetThirdOrder(
    c, g1, g2, of,
    [&](double z, double e)
    {
      const auto zeta = [&](double one, double two) { return (1.0 - z) * one + z * two; };
      const auto eta = [&](double one, double two) { return (1.0 - e) * one + e * two; };
      const double theta = (3.0 * eta(g1, g2) * zeta(6.0 * k1 + 7.0 * g1, 6.0 * k2 + 7.0 * g2) -
                             5.0 * zeta(g1, g2) * zeta(g1, g2)) /
        (zeta(2.0 * k1 - g1, 2.0 * k2 - g2) + 5.0 * eta(g1, g2));
      const double i1 = 1.0 / g1, i2 = 1.0 / g2, j1 = 1.0 / k1, j2 = 1.0 / k2;
      const double xi = (5.0 * zeta(i1, i2) * zeta(6.0 * j1 - i1, 6.0 * j2 - i2) +
                          eta(i1, i2) * zeta(2.0 * j1 + 21.0 * i1, 2.0 * j2 + 21.0 * i2)) /
        (zeta(128.0 * j1 + 99.0 * i1, 128.0 * j2 + 99.0 * i2) + 45.0 * eta(i1, i2));
      return std::pair(1.0 / (6.0 * xi), theta / 6.0);
    },
    bounds);
  const double h = ShearShift(k1, g1), q = k1 + 2.0 * g1;
  const double kappa = (k2 - k1) / (k2 + 4.0 / 3.0 * g1), mu = (g2 - g1) / (g2 + h);
  const double zeta = (1.0 - c) * of.Zeta, eta = (1.0 - c) * of.Eta, s = 3.0 * k1 + g1;
  const double e = c * mu /
    (1.0 - 2.0 * g1 * kappa * mu * zeta / (3.0 * q) -
      5.0 * g1 * (2.0 * k1 + 3.0 * g1) * mu * mu * zeta / (6.0 * q * q) -
      s * s * mu * mu * eta / (6.0 * q * q));
  bounds.Estimate = (g1 + h * e) / (1.0 - e);
}
}
