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
  Gaussian
};
constexpr int CountOf(SizeLaw)
{
  return 4;
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
   * with any number, and of each class the whole number that is nearest to its share. The mode is
   * the place in `Diameters`, and 1 for other laws. Throws std::invalid_argument for what cannot
   * be, and where a class gets no sphere.
   */
  Spheres Make(int number) const;
};
}
