// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/PackBounds.h"

#include "ruc/Base/FixedPoint.h"

#include <algorithm>
#include <limits>

namespace ruc
{
std::int64_t FixedShare(double share)
{
  return RoundToFixedPoint(share * (1 << 30));
}

PackBounds::PackBounds(
  const SpherePack& piece, const std::optional<Window>& box, Communicator& ranks)
{
  double least[13]; // for each axis the least and minus the greatest of centres and surfaces
  std::fill_n(least, 13, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    const Vector3 centre = piece.Centre(i);
    const double radius = piece.Radius[i];
    for (int q = 0; q < 3; ++q)
    {
      least[4 * q] = std::min(least[4 * q], centre[q]);
      least[4 * q + 1] = std::min(least[4 * q + 1], -centre[q]);
      least[4 * q + 2] = std::min(least[4 * q + 2], centre[q] - radius);
      least[4 * q + 3] = std::min(least[4 * q + 3], -(centre[q] + radius));
    }
    least[12] = std::min(least[12], -radius);
  }
  ranks.Minimum(least, 13);
  for (int q = 0; q < 3; ++q)
  {
    this->Periodic[q] = box && box->Periodic[q];
    this->LeastCentre[q] = least[4 * q];
    this->GreatestCentre[q] = -least[4 * q + 1];
    this->Least[q] = this->Periodic[q] ? box->Origin[q] : least[4 * q + 2];
    this->Greatest[q] = this->Periodic[q] ? box->Origin[q] + box->Size[q] : -least[4 * q + 3];
  }
  this->LargestRadius = -least[12];

  std::int64_t sums[3] = { static_cast<std::int64_t>(piece.Size()), 0, 0 };
  for (double radius : piece.Radius)
  {
    const double share = radius / this->LargestRadius;
    const double volume = share * share * share;
    sums[1] += FixedShare(volume);
    sums[2] += FixedShare(volume * share);
  }
  ranks.Sum(sums, 3);
  this->Spheres = sums[0];
  this->VolumeMean = static_cast<double>(sums[2]) / static_cast<double>(sums[1]);
}
}
