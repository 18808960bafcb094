// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Voxels/ImageLags.h"

#include "ruc/Base/Require.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ruc
{
namespace
{
constexpr double Rounding = 1.0 + 1e-9;
}

double ImageLags::VoxelEdge() const
{
  return *std::min_element(this->Spacing.begin(), this->Spacing.end());
}

int ImageLags::ShellOf(int x, int y, int z) const
{
  const double edge = this->VoxelEdge();
  const double a = x * (this->Spacing[0] / edge), b = y * (this->Spacing[1] / edge),
               c = z * (this->Spacing[2] / edge);
  const double square = a * a + b * b + c * c, last = this->Lags.Maximum() / edge * Rounding;
  return square <= last * last ? static_cast<int>(std::lround(square)) : -1;
}

int ImageLags::Shells() const
{
  const double last = this->Lags.Maximum() / this->VoxelEdge() * Rounding;
  return static_cast<int>(std::lround(last * last)) + 1;
}

std::vector<double> ImageLags::ShellLengths() const
{
  const int shells = this->Shells();
  std::vector<double> sum(shells, 0.0), count(shells, 0.0);
  for (int z = 0; z <= this->Last[2]; ++z)
  {
    for (int y = 0; y <= this->Last[1]; ++y)
    {
      for (int x = 0; x <= this->Last[0]; ++x)
      {
        const int shell = this->ShellOf(x, y, z);
        if (shell >= 0)
        {
          const double copies = (x > 0 ? 2.0 : 1.0) * (y > 0 ? 2.0 : 1.0) * (z > 0 ? 2.0 : 1.0);
          sum[shell] += copies *
            std::sqrt(std::pow(x * this->Spacing[0], 2) + std::pow(y * this->Spacing[1], 2) +
              std::pow(z * this->Spacing[2], 2));
          count[shell] += copies;
        }
      }
    }
  }
  for (int shell = 0; shell < shells; ++shell)
  {
    sum[shell] =
      count[shell] > 0.0 ? sum[shell] / count[shell] : std::numeric_limits<double>::quiet_NaN();
  }
  return sum;
}

ImageLags FindImageLags(
  const std::array<int, 3>& dimensions, const Vector3& spacing, double maximum, int count)
{
  ImageLags lags = { {}, spacing, {} };
  const double edge = lags.VoxelEdge();
  double shortest = std::numeric_limits<double>::infinity();
  for (int q = 0; q < 3; ++q)
  {
    if (dimensions[q] > 1)
    {
      shortest = std::min(shortest, dimensions[q] * spacing[q]);
    }
  }
  Require(std::isfinite(shortest), "The image", "more than one voxel", "one");
  const double largest = 0.5 * shortest;
  Require(std::isfinite(maximum) && maximum >= 0.0 && maximum <= largest * Rounding, "MaximumLag",
    Text("0 (automatic) or a number up to half the shortest edge of the image that has several "
         "voxels, ",
      largest),
    maximum);
  if (maximum == 0.0)
  {
    maximum = std::max(1.0, std::floor(0.25 * shortest / edge * Rounding)) * edge;
  }
  const double most = std::floor(maximum / edge * Rounding);
  Require(most >= 1.0, "MaximumLag", Text("at least the edge of a voxel, ", edge), maximum);
  Require(count >= 0 && count <= most, "NumberOfLags",
    Text("0 (automatic) or a number up to one lag a voxel, ", most), count);
  lags.Lags.Count = count > 0 ? count : static_cast<int>(most);
  lags.Lags.Spacing = maximum / lags.Lags.Count;
  for (int q = 0; q < 3; ++q)
  {
    lags.Last[q] = dimensions[q] > 1 ? static_cast<int>(maximum / spacing[q] * Rounding) : 0;
  }
  return lags;
}
}
