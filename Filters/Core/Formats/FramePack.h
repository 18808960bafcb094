// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/PackFrame.h"
#include "ruc/Particles/SpherePack.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ruc
{
/** What a file may leave open or have wrong. */
struct PackSettings
{
  /** A factor for all lengths of the file; finite and > 0. The other settings are not scaled. */
  double Scale = 1.0;
  /** The radius of every sphere if neither the file nor RadiusByType tells it; 0 means none. */
  double UniformRadius = 0.0;
  /**
   * The radii by type if the file tells none, such as "1=0.3; 2=0.42"; with names if types are
   * names.
   */
  std::string RadiusByType;
  /** Which axes of the box are periodic, whatever the file tells. None means as the file tells. */
  std::optional<std::array<bool, 3>> Periodic;
  /** The window of the centres, in place of the box of the file. */
  std::optional<Window> Observed;
};

/**
 * A frame as a pack of this project: in the order of its ids, and wrapped into its box along the
 * periodic axes.
 */
struct FramePack
{
  /**
   * The ids are the file's, or count its rows from 0. There are modes only if a table tells them.
   */
  SpherePack Pack;
  std::vector<int> Type; // may be empty
  std::vector<std::string> TypeNames;
  /** The box of the file, for a tilted one the brick of BrickOf; or PackSettings::Observed. */
  std::optional<Window> Box;
  /**
   * Whether the box is the window of the pack: it was given, or all axes of the file's box are
   * periodic. Otherwise it is the box of a simulation, which may be much larger than the pack.
   */
  bool BoxIsWindow = false;
  std::string LengthUnit;
  std::optional<double> Time; // or the step
  std::string Format;
  /**
   * The numbers of centres that were moved into the box along periodic axes, and of copies of
   * spheres that were left out.
   */
  std::size_t Wrapped = 0, Ghosts = 0;
  std::vector<std::string> Warnings;
};

/**
 * Returns a radius for each of `count` spheres of which only the types are known. `types` is empty
 * or has one for each sphere, and `names` are those of PackFrame::TypeNames. A type that
 * RadiusByType does not have gets UniformRadius.
 *
 * Throws std::invalid_argument for settings that are not positive numbers, even if there are no
 * spheres, and for a sphere that gets no radius.
 */
std::vector<double> MakeRadii(std::size_t count, const std::vector<int>& types,
  const std::vector<std::string>& names, const PackSettings& settings);

/**
 * Makes a pack of a frame. Rows that only repeat a sphere in a neighbouring image are left out if
 * the box is not tilted (FindPeriodicCopies).
 *
 * Throws std::invalid_argument if neither file nor settings give a radius; for settings of radii
 * that are not positive numbers or lack a type; for coordinates and radii beyond the range of
 * lengths that Window.h tells, but for radii of 0; if two spheres have the same id or centre; for a
 * sphere outside the given window; and for a sphere that holds the centres of more than nine in ten
 * others, which is a container that some programs write along.
 */
FramePack MakePack(PackFrame frame, const PackSettings& settings);
}
