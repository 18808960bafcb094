// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Window/Window.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace ruc
{
/**
 * Spheres: centre, radius and mode (class of size, 1 to N_p), one entry a sphere in every array.
 * `Mode` and `Id`, a name of the sphere's own, may be empty where they play no part.
 */
struct SpherePack
{
  std::vector<double> X, Y, Z, Radius;
  std::vector<int> Mode;
  std::vector<std::int64_t> Id;

  std::size_t Size() const { return this->X.size(); }
  bool Empty() const { return this->X.empty(); }
  int NumberOfModes() const;
  double LargestRadius() const;
  /** Appends the i-th sphere of another pack. */
  void Append(const SpherePack& other, std::size_t i);
  /** Appends all spheres of another pack. */
  void Append(const SpherePack& other);
  Vector3 Centre(std::size_t i) const { return { this->X[i], this->Y[i], this->Z[i] }; }

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.X, self.Y, self.Z, self.Radius, self.Mode, self.Id);
  }
};

/**
 * Puts the spheres in the order of (x, y, z, radius, mode), so that what is computed from a pack
 * does not depend on how it was stored or spread over ranks.
 */
void SortCanonically(SpherePack& pack);

/**
 * What every estimator asks of its input. Throws std::invalid_argument that says which sphere fails
 * and how: at least one sphere, finite centres, finite radii > 0, both of the range of lengths that
 * Window.h tells, no two spheres with one centre (a
 * canonically sorted pack is needed to notice), modes 1…N_p without a gap when `withModes`.
 */
void ValidatePack(const SpherePack& pack, bool withModes);

/**
 * What a window asks of the pack in it. Throws std::invalid_argument when a centre lies outside,
 * when an edge is not longer than the largest sphere's diameter, or when two centres coincide
 * across the border of a periodic box.
 */
void ValidateWindow(const SpherePack& pack, const Window& window);

// The single checks, for packs that are spread over ranks. Each returns a message, or an empty text
// where nothing is wrong.
extern const char* const NoSpheres;
/** Numbers that are not finite or not of the range LeastLength to GreatestLength and, when
 * `withModes`, modes out of range in a pack that is part of one of `total` spheres. */
std::string FindFaultySphere(const SpherePack& pack, bool withModes, std::int64_t total);
/** Two spheres with one centre in a pack in canonical order, wrapped into the window. */
std::string FindCoincidence(const SpherePack& pack, const Window& window);
/** A mode below the highest that no sphere has; `counts` of all modes. */
std::string FindModeGap(const std::vector<std::int64_t>& counts);
/** An edge of the window, the diameter and height of a cylinder, that is not longer than the
 * largest sphere's diameter: spheres would meet their own images across a periodic one, and most of
 * their volume lies outside the others. */
std::string FindNarrowEdge(double largestRadius, const Window& window);
/** Names a sphere with its centre outside the window; `count` becomes the number of such spheres.
 */
std::string FindOutside(const SpherePack& pack, const Window& window, std::int64_t& count);
/** The message for `count` such spheres of `total`. */
std::string OutsideMessage(
  const Window& window, std::int64_t count, std::int64_t total, const std::string& example);

/** The spheres whose centres lie in the window, in the same order. */
SpherePack CropToWindow(const SpherePack& pack, const Window& window);

/** Moves centres that lie on or beyond the upper border of a periodic axis by whole edges into
 * [origin, origin + edge). */
void WrapIntoBox(SpherePack& pack, const Window& box);

/** x, y, z of every sphere. */
std::vector<double> CentresOf(const SpherePack& pack);
/** Sets the centres to such numbers, wrapped into the box. */
void SetCentres(SpherePack& pack, const Window& box, const double* centres);
}
