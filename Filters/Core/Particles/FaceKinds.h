// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackBounds.h"

#include <array>
#include <optional>

namespace ruc
{
/** How a pack ends at a face. */
enum class FaceKind
{
  /** The pack goes on beyond it, and the spheres were chosen by their centres. */
  Cut,
  /** The spheres touch a flat wall, along which they lie in layers. */
  Wall,
  /**
   * The pack thins out: a free surface, or a cut that keeps only whole spheres, or all spheres that
   * it touches.
   */
  Loose,
  /** There are too few spheres to tell. */
  Unknown,
  /** The pack repeats itself. */
  Periodic
};
constexpr int CountOf(FaceKind)
{
  return 5;
}
const char* NameOf(FaceKind kind);

/** The faces of a box are counted x-, x+, y-, y+, z-, z+. */
constexpr int NumberOfFaces = 6;
/** Returns such a name. */
const char* NameOfFace(int face);

/** A cylinder along an axis that all spheres lie in. */
struct Mantle
{
  int Axis = 2;
  /** A point of its axis of symmetry; the coordinate along it is 0. */
  Vector3 Centre{};
  double Radius = 0.0;
  /** The area of the spheres that touch it, seen from inside, over its own. */
  double Covered = 0.0;
};

/**
 * Returns the cylinder along an axis that fits the spheres best: the spheres furthest out in each
 * of 64 directions lie on it. None is returned if a direction has no spheres. Collective.
 */
std::optional<Mantle> FitMantle(
  const SpherePack& piece, const PackBounds& bounds, int axis, Communicator& ranks);

/**
 * Returns the cylinder that contains the pack: the one of FitMantle along an axis, across which the
 * pack is not periodic, that the spheres cover by more than a quarter. There mostly is none. A
 * cylinder that holds a dense pack is covered by 0.6, a cylinder around a box by 0.05. Collective.
 */
std::optional<Mantle> FindMantle(
  const SpherePack& piece, const PackBounds& bounds, Communicator& ranks);

/** The faces of a pack. Within a mantle only the two that close it count; the others are Unknown.
 */
struct PackFaces
{
  std::array<FaceKind, NumberOfFaces> Kinds{};
  /** The area of the spheres that touch a face, seen from inside, over that of the face. */
  std::array<double, NumberOfFaces> Covered{};
};

/**
 * Tells the faces of a pack apart. Each is judged by the spheres one largest diameter D away from
 * the other faces that are not periodic. In the thinnest layer of depths, measured from the
 * surfaces of the spheres, that could hold a layer of touching spheres:
 *
 * - Wall: 15 spheres or more cover more than a quarter of the face, and four times as much as in
 * the middle of the pack.
 * - Unknown: the volume of the spheres in a layer of D/2 has a standard error of more than a fifth.
 * - Loose: the outer D/2 of the centres holds less volume than the middle by more than a tenth and
 * by 3 standard errors; or the spheres end where their surfaces do rather than where their
 * centres do. If the centres end at height a, the outer surfaces (centre + radius) at b, and the
 * inner ones at c, then of the three planes a, b - r and c + r, with the mean radius r, the lowest
 * is the most likely end: centres spread evenly up to it would be the fewest. It is taken if it is
 * more likely than a by a factor of e^4.
 * - Cut: all others.
 *
 * Collective; the result is the same on any number of ranks.
 */
PackFaces FindFaces(const SpherePack& piece, const PackBounds& bounds,
  const std::optional<Mantle>& mantle, Communicator& ranks);
}
