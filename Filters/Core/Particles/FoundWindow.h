// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/FaceKinds.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ruc
{
/** What a window that FindWindow found must hold if it was moved away from faces. */
constexpr std::int64_t LeastSpheresOfWindow = 500;
constexpr double LeastEdgeOfWindow = 4.0; // largest diameters

/** What is known of a window before it is looked for. */
struct WindowChoices
{
  /**
   * How far to stay away from walls and loose faces, in largest diameters. A negative number is
   * automatic: max(1, 2 V), where V is the mean diameter, weighted by volume, over the largest one;
   * and 3.5 for V > 0.9, since layers of equal spheres reach further.
   */
  double Erosion = -1.0;
  /**
   * What faces are, such as "z-=wall; z+=cut". A face is cut, wall or loose; "all" are all faces
   * that are not named themselves. "mantle=z" tells of a cylinder along z, of which only z- and z+
   * may be named; "mantle=none" tells that there is none, and so does any other face that is named.
   * What is not told is found.
   */
  std::string Faces;

  /** Whether nothing is chosen. */
  bool AreAutomatic() const { return this->Erosion < 0.0 && this->Faces.empty(); }
};

/** Throws std::invalid_argument for choices of another form. */
void CheckChoices(const WindowChoices& choices);

/**
 * Returns the sentence that tells a user who made choices that they have no effect, as no window is
 * looked for: one is known, or it was not wanted. Empty where nothing is chosen.
 */
std::string TellUnused(const WindowChoices& choices, bool known);

/** Returns whether a FoundWindow::Source, or another text, is of a window that was looked for. */
bool IsFoundSource(const std::string& source);

/** A window that was found. */
struct FoundWindow
{
  /** None if no window can be told. A reason stands in the warnings, except for few spheres. */
  std::optional<Window> Observed;
  /** How it was found: "File", "Cut faces" or "Eroded". */
  std::string Source;
  /** The faces in the form of WindowChoices::Faces. Empty if they were not looked at. */
  std::string Faces;
  /** How far the window stays away from walls and loose faces, in largest diameters; 0 if none. */
  double Erosion = 0.0;
  /** The number of spheres whose centres lie outside. */
  std::int64_t Outside = 0;
  /** Sentences that say what was supposed. */
  std::vector<std::string> Warnings;
};

/**
 * Finds the window of a pack that is known by its spheres, and perhaps by the box that its file
 * names.
 *
 * - A box that is periodic along all axes is the window. Of any other box only its periodic axes
 *   count, as it may be larger than the pack.
 * - Faces that cut the pack bound the window where the bounds of the centres are. Of N spheres
 * these are closer together than the faces by a share of 2/N.
 * - From walls and loose faces, and from the mantle of a cylinder, the window stays away by
 *   WindowChoices::Erosion, measured from the bounds of the spheres, since spheres lie in layers
 *   along a wall, and a rough surface belongs to no window.
 * - Faces that cannot be told apart are taken as cut, with a warning.
 *
 * Without choices, fewer than LeastSpheresOfWindow spheres tell no window, except along the
 * periodic axes of a box; and no window is taken, with a warning, if one that was moved away from
 * faces has less than LeastSpheresOfWindow spheres or an edge of less than LeastEdgeOfWindow, or if
 * the spheres leave a part of it empty (FindFilledShare), as those of a container do that is
 * neither a box nor a cylinder along an axis.
 *
 * Throws std::invalid_argument, the same on every rank, for choices of another form, for a face of
 * a periodic axis or a mantle across one, and if an erosion that was chosen leaves less than that.
 * Collective; the result is the same on any number of ranks.
 */
FoundWindow FindWindow(const SpherePack& piece, const std::optional<Window>& box,
  const WindowChoices& choices, Communicator& ranks);
}
