// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace ruc
{
/** Values at the points of a lattice, or at those of a part of it that is a lattice, too. */
struct LatticeValues
{
  const float* First;
  std::array<std::ptrdiff_t, 3> Stride;
  std::array<int, 3> Count;
  std::array<bool, 3> Periodic;

  std::size_t Size() const
  {
    return static_cast<std::size_t>(this->Count[0]) * this->Count[1] * this->Count[2];
  }
  float At(int i, int j, int k) const
  {
    return this->First[i * this->Stride[0] + j * this->Stride[1] + k * this->Stride[2]];
  }
  /** The box of `count` points from a point on, none of whose axes is periodic. */
  LatticeValues Box(const std::array<int, 3>& from, const std::array<int, 3>& count) const;
};

/**
 * Returns for each axis the greatest value v for which the points with values >= v connect the
 * first plane across the axis with the last, or, along a periodic axis, a point with its own image.
 * Points are connected to the next along each axis. It is 0 where those with values > 0 do not
 * connect.
 */
std::array<double, 3> FindCriticalValues(const LatticeValues& values);
}
