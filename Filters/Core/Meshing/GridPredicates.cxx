// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Meshing/GridPredicates.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace ruc
{
namespace
{
__extension__ using Wide = __int128;
__extension__ using UnsignedWide = unsigned __int128;

constexpr double CellsOfGrid = 2199023255552.0; // 2^41
constexpr double HalfUlp = 0.5 * std::numeric_limits<double>::epsilon();
constexpr double ErrorOfOrientation = (7.0 + 56.0 * HalfUlp) * HalfUlp;
constexpr double ErrorOfInSphere = (16.0 + 224.0 * HalfUlp) * HalfUlp;

int SignOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

Vector3 Difference(const GridPoint& a, const GridPoint& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

// The determinant of three differences, below (sqrt(3) 2^41)^3 < 2^126 by Hadamard's bound; its
// parts are below 2^125
Wide Determinant(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto minor = [](double p, double q, double r, double s)
  {
    return static_cast<Wide>(static_cast<std::int64_t>(p)) * static_cast<std::int64_t>(q) -
      static_cast<Wide>(static_cast<std::int64_t>(r)) * static_cast<std::int64_t>(s);
  };
  return static_cast<std::int64_t>(a[0]) * minor(b[1], c[2], b[2], c[1]) +
    static_cast<std::int64_t>(a[1]) * minor(b[2], c[0], b[0], c[2]) +
    static_cast<std::int64_t>(a[2]) * minor(b[0], c[1], b[1], c[0]);
}

// The square of a difference's length, below 3 x 2^82
Wide Square(const Vector3& a)
{
  Wide sum = 0;
  for (const double coordinate : a)
  {
    const auto whole = static_cast<std::int64_t>(coordinate);
    sum += static_cast<Wide>(whole) * whole;
  }
  return sum;
}

// A sum of products in limbs of 64 bits, which are carried at the end
class WideSum
{
public:
  void AddProduct(Wide determinant, Wide square)
  {
    const Wide high = determinant >> 64, square1 = square >> 64;
    const auto low = static_cast<std::uint64_t>(determinant);
    const auto square0 = static_cast<std::uint64_t>(square);
    const UnsignedWide lowest = static_cast<UnsignedWide>(low) * square0;
    this->Limbs[0] += static_cast<std::uint64_t>(lowest);
    this->Limbs[1] += static_cast<std::uint64_t>(lowest >> 64);
    this->Add(1, high * square0);
    this->Add(1, square1 * low);
    this->Add(2, high * square1);
  }

  int Sign() const
  {
    Wide carry = 0;
    std::uint64_t rest = 0;
    for (const Wide limb : this->Limbs)
    {
      rest |= static_cast<std::uint64_t>(carry);
      carry = limb + (carry >> 64);
    }
    return carry < 0 ? -1 : carry > 0 || rest != 0 ? 1 : 0;
  }

private:
  void Add(std::size_t limb, Wide value)
  {
    this->Limbs[limb] += static_cast<std::uint64_t>(value);
    this->Limbs[limb + 1] += value >> 64;
  }

  std::array<Wide, 4> Limbs{};
};

int ExactInSphere(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  WideSum sum;
  sum.AddProduct(Determinant(b, c, d), Square(a));
  sum.AddProduct(-Determinant(a, c, d), Square(b));
  sum.AddProduct(Determinant(a, b, d), Square(c));
  sum.AddProduct(-Determinant(a, b, c), Square(d));
  return sum.Sign();
}
}

std::vector<GridPoint> RoundToGrid(
  const std::vector<Vector3>& points, const Vector3& low, const Vector3& high)
{
  const double edge = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  const double scale = CellsOfGrid / edge;
  std::vector<GridPoint> rounded;
  rounded.reserve(points.size());
  for (const Vector3& point : points)
  {
    rounded.push_back({ std::round((point[0] - low[0]) * scale),
      std::round((point[1] - low[1]) * scale), std::round((point[2] - low[2]) * scale) });
  }
  return rounded;
}

int Orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  const Vector3 p = Difference(b, a), q = Difference(c, a), r = Difference(d, a);
  const double q1r2 = q[1] * r[2], q2r1 = q[2] * r[1], q2r0 = q[2] * r[0], q0r2 = q[0] * r[2],
               q0r1 = q[0] * r[1], q1r0 = q[1] * r[0];
  const double volume = p[0] * (q1r2 - q2r1) + p[1] * (q2r0 - q0r2) + p[2] * (q0r1 - q1r0);
  const double bound = ErrorOfOrientation *
    (std::abs(p[0]) * (std::abs(q1r2) + std::abs(q2r1)) +
      std::abs(p[1]) * (std::abs(q2r0) + std::abs(q0r2)) +
      std::abs(p[2]) * (std::abs(q0r1) + std::abs(q1r0)));
  if (std::abs(volume) > bound)
  {
    return SignOf(volume);
  }
  if (bound == 0.0)
  {
    return 0;
  }
  const Wide exact = Determinant(p, q, r);
  return (exact > 0) - (exact < 0);
}

int InSphere(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d,
  const GridPoint& e)
{
  const Vector3 p = Difference(a, e), q = Difference(b, e), r = Difference(c, e),
                s = Difference(d, e);
  // The 2 x 2 minors of the first two columns, and the bounds of their magnitudes
  const auto minor = [](const Vector3& u, const Vector3& v) { return u[0] * v[1] - u[1] * v[0]; };
  const auto bound = [](const Vector3& u, const Vector3& v)
  { return std::abs(u[0] * v[1]) + std::abs(u[1] * v[0]); };
  const double pq = minor(p, q), qr = minor(q, r), rs = minor(r, s), sp = minor(s, p),
               pr = minor(p, r), qs = minor(q, s);
  const double pqr = p[2] * qr - q[2] * pr + r[2] * pq, qrs = q[2] * rs - r[2] * qs + s[2] * qr,
               rsp = r[2] * sp + s[2] * pr + p[2] * rs, spq = s[2] * pq + p[2] * qs + q[2] * sp;
  const double p2 = Dot(p, p), q2 = Dot(q, q), r2 = Dot(r, r), s2 = Dot(s, s);
  const double outside = (s2 * pqr - r2 * spq) + (q2 * rsp - p2 * qrs);
  const double Bpq = bound(p, q), Bqr = bound(q, r), Brs = bound(r, s), Bsp = bound(s, p),
               Bpr = bound(p, r), Bqs = bound(q, s);
  const double pz = std::abs(p[2]), qz = std::abs(q[2]), rz = std::abs(r[2]), sz = std::abs(s[2]);
  const double most = (Brs * qz + Bqs * rz + Bqr * sz) * p2 +
    (Bsp * rz + Bpr * sz + Brs * pz) * q2 + (Bpq * sz + Bqs * pz + Bsp * qz) * r2 +
    (Bqr * pz + Bpr * qz + Bpq * rz) * s2;
  if (std::abs(outside) > ErrorOfInSphere * most)
  {
    return SignOf(-outside);
  }
  return ExactInSphere(p, q, r, s);
}
}
