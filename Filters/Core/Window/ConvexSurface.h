// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <vector>

namespace ruc
{
/**
 * The closed surface of a convex polyhedron: faces as points in order, counter-clockwise from
 * outside, every edge shared by two of them.
 */
struct ConvexSurface
{
  std::vector<Vector3> Points;
  std::vector<std::vector<int>> Faces;

  /**
   * Keep what is above (`side` 1) or below (-1) the plane where coordinate `axis` is `level`, and
   * close it with one face in that plane, the last. Nothing is left of a polyhedron beyond the
   * plane. Points closer to it than `tolerance` are moved onto it, so that the two halves of a
   * polyhedron have the same face there, corner by corner.
   */
  void Cut(int axis, double level, int side, double tolerance);
};
}
