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
 * Spheres with centre, radius and mode (the class of size, 1 to N_p). Every array has one entry for
 * each sphere. `Mode` and `Id`, a number of the sphere's own, may be empty where they play no part.
 * Lengths are in any one unit.
 */
struct SpherePack
{
  std::vector<double> X, Y, Z, Radius;
  std::vector<int> Mode;
  std::vector<std::int64_t> Id;

  std::size_t Size() const { return this->X.size(); }
  bool Empty() const { return this->X.empty(); }
  /** The highest mode, or 0 without modes. */
  int NumberOfModes() const;
  /** 0 for an empty pack. */
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
 * Sorts the spheres by (x, y, z, radius, mode), so that what is computed from a pack does not
 * depend on how it was stored or spread over ranks.
 */
void SortCanonically(SpherePack& pack);

/**
 * Checks what every estimator asks of its input. Throws std::invalid_argument that says which
 * sphere fails and how, unless there is at least one sphere, centres and radii are finite and in
 * the range of lengths of Window.h, radii are > 0, no two spheres have one centre (which is noticed
 * in a canonically sorted pack only) and, when `withModes`, the modes are 1…N_p without a gap.
 */
void ValidatePack(const SpherePack& pack, bool withModes);

/**
 * Checks what a window asks of the pack in it. Throws std::invalid_argument when a centre lies
 * outside, when an edge is not longer than the largest sphere's diameter, or when two centres
 * coincide across the border of a periodic box.
 */
void ValidateWindow(const SpherePack& pack, const Window& window);

// The single checks, for packs that are spread over ranks. Each returns a message, or an empty text
// where nothing is wrong.
extern const char* const NoSpheres;
/**
 * Finds numbers that are not finite or out of the range from LeastLength to GreatestLength and,
 * when `withModes`, modes that cannot be in a pack of `total` spheres, of which `pack` is a part.
 */
std::string FindFaultySphere(const SpherePack& pack, bool withModes, std::int64_t total);
/**
 * Finds two spheres with one centre in a pack that is in canonical order and wrapped into the
 * window.
 */
std::string FindCoincidence(const SpherePack& pack, const Window& window);
/**
 * Finds a mode below the highest that no sphere has. `counts` are the numbers of spheres of all
 * modes.
 */
std::string FindModeGap(const std::vector<std::int64_t>& counts);
/**
 * Finds an edge of the window, or the diameter or height of a cylinder, that is not longer than the
 * largest sphere's diameter: spheres would meet their own images across a periodic edge, and most
 * of their volume would lie outside another one.
 */
std::string FindNarrowEdge(double largestRadius, const Window& window);
/**
 * Names a sphere whose centre lies outside the window. `count` becomes the number of such spheres.
 */
std::string FindOutside(const SpherePack& pack, const Window& window, std::int64_t& count);
/** The message for `count` such spheres of `total`, of which `example` names one. */
std::string OutsideMessage(
  const Window& window, std::int64_t count, std::int64_t total, const std::string& example);

/** Returns the spheres whose centres lie in the window, in the same order. */
SpherePack CropToWindow(const SpherePack& pack, const Window& window);

/** Moves centres along periodic axes by whole edges into [origin, origin + edge). */
void WrapIntoBox(SpherePack& pack, const Window& box);

/**
 * Moves a centre that lies outside the box along a periodic axis, beyond what Window::Contains
 * tolerates, to where its image is inside, and returns whether it did. A centre more than a million
 * edges away is left where it is, since its place in the box would be rounding.
 */
bool MoveIntoBox(Vector3& centre, const Window& box);
/** The same for all centres; returns how many were moved. */
std::int64_t MoveIntoBox(SpherePack& pack, const Window& box);

/** Returns x, y, z of every sphere in one list. */
std::vector<double> CentresOf(const SpherePack& pack);
/** Sets the centres to x, y, z of every sphere, wrapped into the box. */
void SetCentres(SpherePack& pack, const Window& box, const double* centres);
}
