// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ruc
{
enum class SizeLaw
{
  Equal,
  Classes,
  LogNormal,
  Gaussian,
  Measured // the diameters of other spheres, or their sieve curve
};
constexpr int CountOf(SizeLaw)
{
  return 5;
}

/** What shares of the classes count. */
enum class ShareKind
{
  Number,
  Volume
};
constexpr int CountOf(ShareKind)
{
  return 2;
}

/** A distribution of the diameters of spheres. */
struct SphereSizes
{
  SizeLaw Law = SizeLaw::Equal;
  /** For SizeLaw::Classes the diameter of each class, and its share, in any unit. */
  std::vector<double> Diameters, Shares;
  ShareKind SharesAre = ShareKind::Volume;
  /**
   * For SizeLaw::Measured: empty where `Diameters` are those of measured spheres; else `Diameters`
   * are the openings of sieves, which rise, and for each of them this is the per cent of the volume
   * that passes it, which rises from 0 to 100. Between two sieves the volume is evenly spread over
   * the diameters.
   */
  std::vector<double> Passing;
  /** Of the diameter; for Equal all have the mean. */
  double MeanDiameter = 1.0, StandardDeviation = 0.0;
  /**
   * The diameters (for LogNormal their logarithms) lie within this many standard deviations of the
   * mean; the rest of the distribution is left out.
   */
  double Cut = 2.5;

  /** The radius and the class, from 1, of every sphere. */
  struct Spheres
  {
    std::vector<double> Radius;
    std::vector<int> Mode;
  };

  /**
   * Returns so many spheres, the largest first: quantiles of the distribution, so that it is met
   * with any number, and of each class, or between two sieves, the whole number that is nearest to
   * its share. Between two sieves each sphere has the mean volume of those for which it stands. The
   * mode is the place in `Diameters` for classes, and 1 for other laws. Throws
   * std::invalid_argument for what cannot be, and where a class, or what lies between two sieves,
   * gets no sphere.
   */
  Spheres Make(int number) const;
};
}
