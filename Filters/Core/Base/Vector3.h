// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

namespace ruc
{
constexpr double Pi = 3.14159265358979323846;

/** A point or a direction in space. */
using Vector3 = std::array<double, 3>;

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/** The length of a vector. */
inline double Length(const Vector3& v)
{
  return std::sqrt(Dot(v, v));
}
}
