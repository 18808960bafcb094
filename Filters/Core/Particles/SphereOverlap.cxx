// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/SphereOverlap.h"

#include "ruc/Base/Vector3.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// dV_ab/dt
double LensVolumeSlope(double a, double b, double t)
{
  const double s = a + b;
  const double q = std::abs(a - b);
  if (t <= q || t >= s)
  {
    return 0.0;
  }
  // Minus the area of the disc that the two surfaces share
  return -Pi * (s - t) * (t - q) * (t + q) * (s + t) / (4.0 * t * t);
}
}

double SphereVolume(double radius)
{
  return 4.0 / 3.0 * Pi * radius * radius * radius;
}

double LensVolume(double a, double b, double t)
{
  const double s = a + b;
  const double q = std::abs(a - b);
  if (t >= s)
  {
    return 0.0;
  }
  if (t <= q)
  {
    return SphereVolume(std::min(a, b));
  }
  return Pi * (s - t) * (s - t) * (t * t + 2.0 * t * s - 3.0 * q * q) / (12.0 * t);
}

double OverlapMoment(double a, double b, double t)
{
  return Pi / 12.0 * MomentFormula(a, b)(std::abs(t));
}

double OverlapMomentSlope(double a, double b, double t)
{
  return -t * LensVolume(a, b, std::abs(t));
}

AveragedOverlap OrientationAveragedOverlap(double a, double b, double r, double d)
{
  // Closer than this to a removable singularity the quotients lose more digits than the error of
  // the limits
  const double tiny = 1e-5 * std::min(a, b);
  if (std::abs(d) < tiny)
  {
    return { LensVolume(a, b, r), 0.0 };
  }
  if (r < tiny)
  {
    return { LensVolume(a, b, std::abs(d)),
      (d < 0.0 ? -1.0 : 1.0) * LensVolumeSlope(a, b, std::abs(d)) };
  }
  const double value = (OverlapMoment(a, b, d - r) - OverlapMoment(a, b, d + r)) / (2.0 * d * r);
  const double slope =
    (OverlapMomentSlope(a, b, d - r) - OverlapMomentSlope(a, b, d + r)) / (2.0 * d * r) - value / d;
  return { value, slope };
}
}
