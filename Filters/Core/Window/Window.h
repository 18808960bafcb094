// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

#include <array>
#include <string>
#include <tuple>

namespace ruc
{
/**
 * The range of lengths that are taken: of radii, edges and the magnitude of coordinates. Within it
 * volumes, and the ratios and products of two volumes, neither overflow nor vanish.
 */
constexpr double LeastLength = 1e-50;
constexpr double GreatestLength = 1e50;

/**
 * The region in which the centres of a pack were observed. It is a box, each axis of which may be
 * periodic, or a circular cylinder whose axis has any direction. Lengths are in the unit of the
 * pack.
 */
class Window
{
public:
  enum class Shape
  {
    Box,
    Cylinder
  };
  friend constexpr int CountOf(Shape) { return 2; }

  /**
   * Makes a box from `origin` to `origin + size`.
   *
   * Throws std::invalid_argument unless every coordinate of the origin is finite and at most
   * GreatestLength in magnitude, and every edge is from LeastLength to GreatestLength.
   */
  static Window MakeBox(
    const Vector3& origin, const Vector3& size, const std::array<bool, 3>& periodic);

  /**
   * Makes a cylinder from `base`, the centre of its base, along `axis` (of any length but 0) over
   * `height`.
   *
   * Throws std::invalid_argument unless every number is finite, |axis| > 0, the base at most
   * GreatestLength in magnitude along each axis, and radius and height from LeastLength to
   * GreatestLength.
   */
  static Window MakeCylinder(
    const Vector3& base, const Vector3& axis, double radius, double height);

  Shape GetShape() const { return this->WindowShape; }
  bool IsPeriodic() const;
  bool IsFullyPeriodic() const;
  double Volume() const;

  /**
   * Returns whether a centre lies in the window, whose faces belong to it. Along a periodic axis a
   * centre that is outside by no more than a rounding error (1e-9 of the edge) still counts.
   */
  bool Contains(const Vector3& centre) const;

  /** The same for a box, along one of its axes. */
  bool ContainsAlong(int axis, double coordinate) const;

  /**
   * Set covariance: the volume of the window's intersection with itself displaced by (dx, dy, dz).
   * A displacement along a periodic axis loses no volume.
   */
  double SetCovariance(double dx, double dy, double dz) const;

  /**
   * Returns the window without a layer of thickness `margin` along its border. A periodic axis has
   * no border and keeps its edge. Throws std::invalid_argument unless the margin passes
   * RequireMargin and leaves a volume.
   */
  Window Shrunk(double margin) const;

  /**
   * Returns how far a point in the window is from the nearest face that is not periodic: infinity
   * where all are. It is below 0 for a point outside.
   */
  double DepthOf(const Vector3& point) const;

  /** Returns the window with all lengths and places times a factor > 0. */
  Window Scaled(double factor) const;

  /**
   * Returns the smallest box with edges along the axes that holds the window. A box is its own,
   * with its periodic axes.
   */
  Window GetBounds() const;

  /**
   * Returns a lower bound of the set covariance over all displacements of a length up to `reach`.
   */
  double LeastSetCovariance(double reach) const;

  /**
   * Returns the length below which every displacement has a set covariance > 0. It is infinite
   * where all axes are periodic.
   */
  double Reach() const;

  /** Returns the shortest edge of a box, or the lesser of diameter and height of a cylinder. */
  double ShortestEdge() const;

  /** The window in words for messages, such as "box window 1445 x 1288 x 789". */
  std::string Describe() const;

  // Of a box
  Vector3 Origin{};
  Vector3 Size{};
  std::array<bool, 3> Periodic{};
  // Of a cylinder, whose Axis has length 1
  Vector3 Base{};
  Vector3 Axis{};
  double Radius = 0.0;
  double Height = 0.0;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.WindowShape, self.Origin, self.Size, self.Periodic, self.Base, self.Axis,
      self.Radius, self.Height);
  }
  bool operator==(const Window& other) const { return Fields(*this) == Fields(other); }

private:
  Shape WindowShape = Shape::Box;
};

/** Throws std::invalid_argument unless the thickness of a margin is finite and >= 0. */
void RequireMargin(double margin);
}
