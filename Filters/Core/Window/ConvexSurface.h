// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <vector>

namespace ruc
{
/**
 * The closed surface of a convex polyhedron. A face is a list of places in `Points`,
 * counter-clockwise as seen from outside. Every edge belongs to two faces.
 */
struct ConvexSurface
{
  std::vector<Vector3> Points;
  std::vector<std::vector<int>> Faces;

  /**
   * Keeps the part of the polyhedron above (`side` 1) or below (`side` -1) the plane in which
   * coordinate `axis` is `level`, and closes it by one face in that plane, which comes last. Where
   * the whole polyhedron lies beyond the plane, nothing is left. Points closer to the plane than
   * `tolerance` are moved onto it, so that the two halves of a polyhedron have the same face there,
   * corner by corner.
   */
  void Cut(int axis, double level, int side, double tolerance);
};
}
