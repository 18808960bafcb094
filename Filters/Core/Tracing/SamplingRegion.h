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
 * Random points and sets of lines depend on (seed, sample) alone, with sample < 2^32, and are the
 * same on every rank and thread.
 */
class SamplingRegion
{
public:
  /**
   * The region is the window without a layer of thickness `margin` along its border; a periodic
   * axis has no border and keeps its edge. Throws std::invalid_argument unless the margin is finite
   * and >= 0 and leaves a volume.
   */
  SamplingRegion(const Window& window, double margin);

  /**
   * The region is the eroded mask (VoxelMask::Eroded), which throws std::invalid_argument for the
   * same reasons.
   */
  SamplingRegion(const VoxelMask& mask, double margin);

  bool Contains(const Vector3& point) const;
  double Volume() const;
  bool IsFullyPeriodic() const { return this->Bounds.IsFullyPeriodic(); }

  /** The smallest axis-aligned box that holds the region, with the periodic axes of its window. */
  const Window& GetBounds() const { return this->Bounds; }

  /**
   * The region itself where it came from a window, with the margin taken off; the bounds where it
   * came from a mask.
   */
  const Window& GetShape() const { return this->Shape; }

  /** Returns a point uniform in the region. */
  Vector3 RandomPoint(std::uint32_t seed, std::uint32_t sample) const;

  /** Returns an isotropic direction, which shares no random number with points and lines. */
  static Vector3 RandomDirection(std::uint32_t seed, std::uint32_t sample);

  /**
   * Returns a number uniform in [0, 1) that goes with RandomDirection, to turn something about it.
   */
  static double RandomTurn(std::uint32_t seed, std::uint32_t sample);

  /**
   * Returns parallel lines in a square grid that the random numbers of `sample` shift and turn.
   * This is a systematic sample of all lines of its direction, in which every place of the region
   * is as likely as any other. The lines are clipped to the region, a partly periodic box at all
   * its faces.
   *
   * `number` > 0 is the number of lines in the mean over directions; of a mask, those that meet its
   * bounds. In a fully periodic box the lines begin in a plane parallel to a face, and pass through
   * the box once and then over a further `maximumLag`.
   *
   * The direction is isotropic, or the one that is given (of length 1). Sets of lines, `set` <
   * 2^24, share no random numbers.
   */
  LineBundle ParallelLines(
    std::uint32_t seed, std::uint32_t sample, double number, double maximumLag) const;
  LineBundle ParallelLinesAlong(const Vector3& direction, std::uint32_t set, std::uint32_t seed,
    std::uint32_t sample, double number, double maximumLag) const;

  /**
   * Replaces `inside` by the ascending parts of start + t direction, 0 <= t <= length, that lie in
   * the region. `direction` has length 1. A periodic box is clipped at its faces, too.
   */
  void Clip(const Vector3& start, const Vector3& direction, double length,
    std::vector<LineInterval>& inside) const;

  /** An upper bound of the length of a line, gaps included. */
  double LongestLine(double maximumLag) const;

  /** The number of parallel lines at which they are `spacing` apart. */
  double LinesOfSpacing(double spacing) const;

  /** An upper bound of the number of parallel lines where `number` are asked for. */
  double MostLines(double number) const;

private:
  // The point that belongs to three uniform numbers: of the bounds, or, where the region fills
  // little of its bounds, of the region itself but for rounding
  Vector3 PointAt(const Vector3& uniform) const;
  Vector3 PointOfVoxels(const Vector3& uniform) const;
  Vector3 PointOfCylinder(const Vector3& uniform) const;
  // Sets the bounding sphere to that of the bounds
  void EncloseBounds();
  // The projected area of a convex region in the mean over directions; for a mask, that of its
  // bounds
  double ProjectedArea() const;
  // The distance between parallel lines
  double GridSpacing(double number) const;
  LineBundle PeriodicLines(const Vector3& direction, const std::array<double, 3>& shift,
    double number, double maximumLag) const;

  Window Shape; // with the margin taken off; the bounds of a mask
  std::optional<VoxelMask> Mask;
  Window Bounds;
  bool Sparse = false;             // whether the region fills little of its bounds
  std::vector<std::size_t> Voxels; // the inside voxels of a sparse mask
  Vector3 Centre{};                // of the bounding sphere, like Radius
  double Radius = 0.0;
};
}
