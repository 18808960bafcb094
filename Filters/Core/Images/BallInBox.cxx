// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/BallInBox.h"

#include <cmath>

namespace ruc
{
double BallWedge(double a, double b, double radius)
{
  const double square = radius * radius, height2 = square - a * a - b * b;
  if (!(height2 > 0.0))
  {
    return 0.0;
  }
  const double height = std::sqrt(height2);
  return (square * radius * std::atan2(radius * height, a * b) + a * b * height) / 3.0 -
    0.5 * a * (square - a * a / 3.0) * std::atan2(height, b) -
    0.5 * b * (square - b * b / 3.0) * std::atan2(height, a);
}

double BallInOctant(double a, double b, double c, double radius)
{
  const double x = std::abs(a), y = std::abs(b), z = std::abs(c);
  if (x * x + y * y + z * z <= radius * radius)
  {
    return a * b * c;
  }
  const auto wedge = [&](double p, double q) { return BallWedge(p, q, radius); };
  const double volume = wedge(0.0, 0.0) - wedge(x, 0.0) - wedge(y, 0.0) - wedge(z, 0.0) +
    wedge(x, y) + wedge(y, z) + wedge(z, x);
  const bool negative = (a < 0.0) != ((b < 0.0) != (c < 0.0));
  return negative ? -volume : volume;
}

double BallInBox(const Vector3& lower, const Vector3& upper, double radius)
{
  double volume = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto along = [&](int q) { return (corner >> q & 1) ? upper[q] : lower[q]; };
    const double sign = (__builtin_popcount(corner) & 1) ? 1.0 : -1.0;
    volume += sign * BallInOctant(along(0), along(1), along(2), radius);
  }
  return volume;
}
}
