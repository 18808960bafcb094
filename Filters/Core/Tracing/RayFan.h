// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/CellList.h"
#include "ruc/Tracing/LineBundle.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * A throw of the paper's template (Fig. 4): a point and rays from it, spaced evenly around a great
 * circle. Ray i of M runs along cos(2 pi i / M) U + sin(2 pi i / M) V.
 */
struct RayFan
{
  Vector3 Centre;
  Vector3 U, V, Normal; // orthonormal

  /**
   * Draws a centre uniform in the region and an isotropic orientation, which depend on (seed,
   * sample) alone.
   */
  static RayFan Random(const SamplingRegion& region, std::uint32_t seed, std::uint32_t sample);
};

/** The directions of all rays of a fan, as factors of U and V. */
struct RayDirections
{
  /** `number` rays around the circle. */
  explicit RayDirections(int number);

  int Size() const { return static_cast<int>(this->Cosine.size()); }
  Vector3 Of(const RayFan& fan, int ray) const;

  std::vector<double> Cosine, Sine;
};

/** A sphere that one of the rays of a fan passes through. */
struct RayHit
{
  int Ray;
  SphereHit Sphere;
};

/** Finds what the rays of fans meet among the spheres of a pack. */
class FanTracer
{
public:
  /**
   * `pack`, with modes, may be empty. Along the periodic axes of `box` it must be wrapped
   * (WrapIntoBox), and images are spheres of their own. Rays have the given length > 0, which may
   * exceed the box. `pack` and `rays` are kept as references.
   */
  FanTracer(const SpherePack& pack, const Window& box, const RayDirections& rays, double length);

  /**
   * Appends every sphere that shares a stretch with a ray, in no particular order. In and Out are
   * those of the whole sphere, and depend on sphere and ray alone, bit by bit. May run
   * concurrently.
   */
  void FindHits(const RayFan& fan, std::vector<RayHit>& hits) const;

private:
  void FindHitsOfImage(const RayFan& fan, const Vector3& shift, std::vector<RayHit>& hits) const;

  const SpherePack& Pack;
  Window Box;
  const RayDirections& Rays;
  double Length;
  double LargestRadius;
  CellList Cells; // without periodic axes
};
}
