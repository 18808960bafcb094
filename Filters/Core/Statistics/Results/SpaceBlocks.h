// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"
#include "ruc/Window/Window.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ruc
{
/** A box in about so many blocks, which are as near to cubes as can be, for standard errors. */
class SpaceBlocks
{
public:
  /** `box` must be a box, and `about` at least 1. */
  SpaceBlocks(const Window& box, int about)
    : Box(box)
  {
    const double width = std::cbrt(box.Volume() / about);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double number = std::min(std::round(box.Size[axis] / width), double(about));
      this->Divisions[axis] = std::max(static_cast<int>(number), 1);
    }
  }

  int Count() const { return this->Divisions[0] * this->Divisions[1] * this->Divisions[2]; }

  /** The block of a point, from 0 on. A point outside belongs to the nearest block. */
  int Of(const Vector3& point) const
  {
    int block = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int count = this->Divisions[axis];
      const double share = (point[axis] - this->Box.Origin[axis]) / this->Box.Size[axis];
      block = block * count + std::clamp(static_cast<int>(share * count), 0, count - 1);
    }
    return block;
  }

private:
  Window Box;
  std::array<int, 3> Divisions{};
};
}
