// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

#include <array>

namespace ruc
{
/**
 * Walks the outline of a box, or of its repetition by `tile` whole edges along each axis: calls
 * corner(point) for its eight corners, then edge(a, b) for its twelve edges, where a and b are the
 * numbers of two corners in that order.
 */
template <class Corner, class Edge>
void ForEachOfOutline(const Vector3& origin, const Vector3& size, const std::array<int, 3>& tile,
  Corner&& corner, Edge&& edge)
{
  for (int n = 0; n < 8; ++n)
  {
    corner(Vector3{ origin[0] + (tile[0] + (n & 1)) * size[0],
      origin[1] + (tile[1] + (n >> 1 & 1)) * size[1], origin[2] + (tile[2] + (n >> 2)) * size[2] });
  }
  for (int n = 0; n < 8; ++n)
  {
    for (int bit : { 1, 2, 4 })
    {
      if (!(n & bit))
      {
        edge(n, n | bit);
      }
    }
  }
}
}
