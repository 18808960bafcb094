// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/EffectiveBounds.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
using Matrix = std::vector<std::vector<double>>;

// Turns a symmetric matrix by Jacobi's rotations until it is diagonal; columns of `vectors` are
// then its eigenvectors
void Diagonalise(Matrix& a, Matrix& vectors)
{
  const std::size_t n = a.size();
  vectors.assign(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i)
  {
    vectors[i][i] = 1.0;
  }
  constexpr int sweeps = 50;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (std::size_t p = 0; p < n; ++p)
    {
      for (std::size_t q = p + 1; q < n; ++q)
      {
        if (a[p][q] == 0.0)
        {
          continue;
        }
        const double angle = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t k = 0; k < n; ++k)
        {
          const double kp = a[k][p], kq = a[k][q];
          a[k][p] = c * kp - s * kq;
          a[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < n; ++k)
        {
          const double pk = a[p][k], qk = a[q][k], vp = vectors[k][p], vq = vectors[k][q];
          a[p][k] = c * pk - s * qk;
          a[q][k] = s * pk + c * qk;
          vectors[k][p] = c * vp - s * vq;
          vectors[k][q] = s * vp + c * vq;
        }
        a[p][q] = a[q][p] = 0.0;
      }
    }
  }
}

// v . M^+ v. The amplitudes of all phases together do nothing, so that M is singular
double PseudoInverse(Matrix m, const std::vector<double>& v)
{
  Matrix vectors;
  Diagonalise(m, vectors);
  double largest = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i)
  {
    largest = std::max(largest, std::abs(m[i][i]));
  }
  constexpr double rounding = 1e-10;
  double sum = 0.0;
  for (std::size_t i = 0; i < m.size(); ++i)
  {
    double along = 0.0;
    for (std::size_t k = 0; k < m.size(); ++k)
    {
      along += vectors[k][i] * v[k];
    }
    sum += m[i][i] > rounding * largest ? along * along / m[i][i] : 0.0;
  }
  return sum;
}

// The quadratic form of the trial fields: <a> - v M^+ v with v_r = V sum_q a_q Q_qr and M_rs =
// sum_q (T a_q T_qrs + I b_q I_qrs)
struct TrialFields
{
  const std::vector<double>& Fractions;
  std::vector<double> A, B;
  double OfV, OfT, OfI;

  double Bound(const std::vector<double>& integrals) const
  {
    const std::size_t n = this->Fractions.size();
    const std::vector<double>& c = this->Fractions;
    Matrix m(n, std::vector<double>(n, 0.0));
    std::vector<double> v(n, 0.0);
    double mean = 0.0;
    for (std::size_t q = 0; q < n; ++q)
    {
      mean += c[q] * this->A[q];
      for (std::size_t r = 0; r < n; ++r)
      {
        v[r] += this->OfV * this->A[q] * ((q == r ? c[q] : 0.0) - c[q] * c[r]);
        for (std::size_t s = 0; s < n; ++s)
        {
          const double t = (q == r && q == s ? c[q] : 0.0) - (q == r ? c[q] * c[s] : 0.0) -
            (q == s ? c[q] * c[r] : 0.0) + c[q] * c[r] * c[s];
          m[r][s] +=
            this->OfT * this->A[q] * t + this->OfI * this->B[q] * integrals[(q * n + r) * n + s];
        }
      }
    }
    return mean - PseudoInverse(std::move(m), v);
  }

  // The sum of the slopes times the errors of the integrals, which is not less than the error
  double Error(const ManyPhaseIntegrals& integrals, bool inverse) const
  {
    const std::size_t n = this->Fractions.size();
    const auto at = [&](const std::vector<double>& values)
    { return inverse ? 1.0 / this->Bound(values) : this->Bound(values); };
    const double here = at(integrals.Value);
    constexpr double step = 1e-6;
    double error = 0.0;
    for (std::size_t q = 0; q < n; ++q)
    {
      for (std::size_t r = 0; r < n; ++r)
      {
        for (std::size_t s = r; s < n; ++s)
        {
          const std::size_t one = (q * n + r) * n + s, other = (q * n + s) * n + r;
          std::vector<double> moved = integrals.Value;
          moved[one] += step;
          moved[other] += one == other ? 0.0 : step;
          error += std::abs((at(moved) - here) / step) * integrals.Error[one];
        }
      }
    }
    return error;
  }
};

void SetBounds(const TrialFields& upper, const TrialFields& lower,
  const ManyPhaseIntegrals& integrals, PropertyBounds& bounds)
{
  bounds.ThirdOrderUpper = upper.Bound(integrals.Value);
  bounds.ThirdOrderUpperError = upper.Error(integrals, false);
  bounds.ThirdOrderLower = 1.0 / lower.Bound(integrals.Value);
  bounds.ThirdOrderLowerError = lower.Error(integrals, true);
}

std::vector<double> Inverse(std::vector<double> values)
{
  for (double& value : values)
  {
    value = 1.0 / value;
  }
  return values;
}
}

void AddThirdOrderConductivity(const std::vector<double>& fractions,
  const std::vector<double>& conductivities, const ManyPhaseIntegrals& integrals,
  PropertyBounds& bounds)
{
  const std::vector<double> resistivities = Inverse(conductivities);
  SetBounds({ fractions, conductivities, conductivities, 1.0 / 3.0, 1.0 / 9.0, 1.0 },
    { fractions, resistivities, resistivities, 2.0 / 3.0, 4.0 / 9.0, 1.0 }, integrals, bounds);
}

void AddThirdOrderBulk(const std::vector<double>& fractions,
  const std::vector<ElasticModuli>& moduli, const ManyPhaseIntegrals& integrals,
  PropertyBounds& bounds)
{
  std::vector<double> bulk, shear;
  for (const ElasticModuli& of : moduli)
  {
    bulk.push_back(of.Bulk);
    shear.push_back(of.Shear);
  }
  SetBounds({ fractions, bulk, shear, 1.0, 1.0, 6.0 },
    { fractions, Inverse(bulk), Inverse(shear), 2.0 / 3.0, 4.0 / 9.0, 1.5 }, integrals, bounds);
}
}
