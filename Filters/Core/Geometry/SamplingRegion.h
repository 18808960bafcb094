// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/VoxelMask.h"
#include "Geometry/Window.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ruc
{
/** The points Start + t Direction (of length 1) with t in one of the ascending intervals. */
struct SampleLine
{
  Vector3 Start, Direction;
  std::vector<LineInterval> Inside;
};

/**
 * The points that are sampled: those of a window or mask that are so far from its border that every
 * sphere that can hold them is known.
 *
 * Random points and lines depend on (seed, sample) alone, sample < 2^32, and are the same on every
 * rank and thread.
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

  /**
   * The largest lag: four times the shortest edge of a fully periodic box; else 0.999 of the
   * shortest edge of the region (of a cylinder the lesser of diameter and height, of a mask that of
   * its bounds), beyond which not every direction has pairs of points.
   */
  double LargestLag() const;

  /** A point uniform in the region. */
  Vector3 RandomPoint(std::uint32_t seed, std::uint32_t sample) const;

  /** An isotropic direction; shares no random number with points and lines. */
  static Vector3 RandomDirection(std::uint32_t seed, std::uint32_t sample);

  /** A number uniform in [0, 1) that goes with RandomDirection, to turn it about itself. */
  static double RandomTurn(std::uint32_t seed, std::uint32_t sample);

  /**
   * An isotropic uniform random (IUR) line: its direction isotropic, its place uniform on the disc
   * of the bounding sphere across it, drawn again until it hits the region, and clipped to it. A
   * partly periodic box is clipped at all its faces.
   * In a fully periodic box the line begins at a point uniform in it, leaves it, and has the length
   * `maximumLag` + the longest edge.
   */
  void RandomLine(
    std::uint32_t seed, std::uint32_t sample, double maximumLag, SampleLine& line) const;

  /** The same with a given direction (of length 1); sets of lines, number `set` < 2^24, share no
   * random numbers. */
  void RandomLineAlong(const Vector3& direction, std::uint32_t set, std::uint32_t seed,
    std::uint32_t sample, double maximumLag, SampleLine& line) const;

  /** No line is longer than this, gaps included. */
  double LongestLine(double maximumLag) const;

private:
  // Sets the bounding sphere to that of the bounds
  void EncloseBounds();
  void DrawLine(const Vector3* direction, std::uint32_t set, std::uint32_t seed,
    std::uint32_t sample, double maximumLag, SampleLine& line) const;
  // The parts of Start + t Direction, 0 <= t <= length, inside
  void Clip(SampleLine& line, double length) const;

  Window Shape; // after the margin; of a mask its bounds
  std::optional<VoxelMask> Mask;
  Window Bounds;
  Vector3 Centre{}; // of the bounding sphere
  double Radius = 0.0;
};
}
