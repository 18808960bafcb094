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
 * Lengths that are taken, radii, edges and the magnitude of coordinates: with them volumes, and the
 * ratios and products of two volumes, neither overflow nor vanish.
 */
constexpr double LeastLength = 1e-50;
constexpr double GreatestLength = 1e50;

/**
 * The region in which the centres of a pack were observed: a box, each axis of which may be
 * periodic, or a circular cylinder of any axis direction. Lengths are in the unit of the pack.
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
   * A box from `origin` to `origin + size`.
   * Throws std::invalid_argument unless every number is finite and every edge is > 0.
   */
  static Window MakeBox(
    const Vector3& origin, const Vector3& size, const std::array<bool, 3>& periodic);

  /**
   * A cylinder from `base`, the centre of its base, along `axis` (any length but 0) over `height`.
   * Throws std::invalid_argument unless every number is finite and radius, height and |axis| are >
   * 0.
   */
  static Window MakeCylinder(
    const Vector3& base, const Vector3& axis, double radius, double height);

  Shape GetShape() const { return this->WindowShape; }
  bool IsPeriodic() const;
  bool IsFullyPeriodic() const;
  double Volume() const;

  /**
   * Whether a centre lies in the window, on any of its faces included. Along a periodic axis a
   * centre a rounding error outside (1e-9 of the edge) still counts.
   */
  bool Contains(const Vector3& centre) const;

  /**
   * Set covariance: the volume of the window's intersection with itself displaced by (dx, dy, dz).
   * A periodic axis does not lose volume.
   */
  double SetCovariance(double dx, double dy, double dz) const;

  /**
   * The window without a layer of thickness `margin` along its border; a periodic axis has no
   * border and keeps its edge. Throws std::invalid_argument unless the margin passes RequireMargin
   * and leaves a volume.
   */
  Window Shrunk(double margin) const;

  /** The smallest box with edges along the axes that holds the window. */
  Window GetBounds() const;

  /** A lower bound of the set covariance over all displacements of a length up to `reach`. */
  double LeastSetCovariance(double reach) const;

  /** Every displacement shorter than this has a set covariance > 0; infinity where all axes are
   * periodic. */
  double Reach() const;

  /** The shortest edge; of a cylinder the lesser of diameter and height. */
  double ShortestEdge() const;

  /** "box window 1445 x 1288 x 789" and the like, for messages. */
  std::string Describe() const;

  // Box
  Vector3 Origin{};
  Vector3 Size{};
  std::array<bool, 3> Periodic{};
  // Cylinder; Axis has length 1
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
