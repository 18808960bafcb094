// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/VoxelMask.h"
#include "ruc/Tracing/LineBundle.h"
#include "ruc/Window/Window.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace ruc
{
/**
 * The points that are sampled: those of a window or mask that are so far from its border that every
 * sphere that can hold them is known.
 *
 * Random points and sets of lines depend on (seed, sample) alone, sample < 2^32, and are the same
 * on every rank and thread.
 */
class SamplingRegion
{
public:
  /**
   * The window without a layer of thickness `margin` along its border; a periodic axis has no
   * border and keeps its edge.
   * Throws std::invalid_argument unless margin is finite and >= 0 and leaves a volume.
   */
  SamplingRegion(const Window& window, double margin);

  /** The eroded mask, VoxelMask::Eroded; throws std::invalid_argument likewise. */
  SamplingRegion(const VoxelMask& mask, double margin);

  bool Contains(const Vector3& point) const;
  double Volume() const;
  bool IsFullyPeriodic() const { return this->Bounds.IsFullyPeriodic(); }

  /** The smallest axis-aligned box that holds the region, with the periodic axes of its window. */
  const Window& GetBounds() const { return this->Bounds; }

  /** The region itself where it came from a window, without the margin; of a mask its bounds. */
  const Window& GetShape() const { return this->Shape; }

  /** A point uniform in the region. */
  Vector3 RandomPoint(std::uint32_t seed, std::uint32_t sample) const;

  /** An isotropic direction; shares no random number with points and lines. */
  static Vector3 RandomDirection(std::uint32_t seed, std::uint32_t sample);

  /** A number uniform in [0, 1) that goes with RandomDirection, to turn it about itself. */
  static double RandomTurn(std::uint32_t seed, std::uint32_t sample);

  /**
   * Parallel lines in a square grid, which the random numbers of `sample` shift and turn: a
   * systematic sample of the lines of its direction, in which every place of the region is as
   * likely as any other. They are clipped to the region, a partly periodic box at all its faces.
   * `number` > 0 is how many lines there are in the mean over directions (of a mask: that meet its
   * bounds). In a fully periodic box they begin in a plane parallel to a face, and pass through the
   * box once and then over a further `maximumLag`. The direction is isotropic, or the one given (of
   * length 1); sets of lines, number `set` < 2^24, share no random numbers.
   */
  LineBundle ParallelLines(
    std::uint32_t seed, std::uint32_t sample, double number, double maximumLag) const;
  LineBundle ParallelLinesAlong(const Vector3& direction, std::uint32_t set, std::uint32_t seed,
    std::uint32_t sample, double number, double maximumLag) const;

  /** Replaces `inside` by the parts of start + t direction, 0 <= t <= length, that are inside,
   * ascending; `direction` has length 1. A periodic box is clipped at its faces, too. */
  void Clip(const Vector3& start, const Vector3& direction, double length,
    std::vector<LineInterval>& inside) const;

  /** No line is longer than this, gaps included. */
  double LongestLine(double maximumLag) const;

  /** The number of parallel lines that makes their distance this. */
  double LinesOfSpacing(double spacing) const;

  /** There are never more parallel lines than this where `number` are asked for. */
  double MostLines(double number) const;

private:
  // A point of the bounds for three uniform numbers; of the region itself, but for rounding, where
  // that fills little of its bounds
  Vector3 PointAt(const Vector3& uniform) const;
  Vector3 PointOfVoxels(const Vector3& uniform) const;
  Vector3 PointOfCylinder(const Vector3& uniform) const;
  // Sets the bounding sphere to that of the bounds
  void EncloseBounds();
  // Projected, in the mean over directions, of a convex region; of a mask that of its bounds
  double ProjectedArea() const;
  // The distance of parallel lines
  double GridSpacing(double number) const;
  LineBundle PeriodicLines(const Vector3& direction, const std::array<double, 3>& shift,
    double number, double maximumLag) const;

  Window Shape; // after the margin; of a mask its bounds
  std::optional<VoxelMask> Mask;
  Window Bounds;
  bool Sparse = false;             // fills little of its bounds
  std::vector<std::size_t> Voxels; // inside a sparse mask
  Vector3 Centre{};                // of the bounding sphere
  double Radius = 0.0;
};
}
