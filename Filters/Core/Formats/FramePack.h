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
/** What a file may leave open, or have wrong. */
struct PackSettings
{
  /** Radius of every sphere where the file tells none, and RadiusByType does not; 0: none. */
  double UniformRadius = 0.0;
  /** Radii by type where the file tells none, such as "1=0.3; 2=0.42"; names where types are. */
  std::string RadiusByType;
  /** Which axes of the box are periodic, whatever the file tells. */
  std::optional<std::array<bool, 3>> Periodic;
};

/** A frame as a pack of this project: in the order of its ids, wrapped into its box along the
 * periodic axes. */
struct FramePack
{
  /** Ids are the file's, or count its rows from 0; modes only where a table tells them. */
  SpherePack Pack;
  std::vector<int> Type; // may be empty
  std::vector<std::string> TypeNames;
  /** The box of the file; of a tilted one the brick of BrickOf. */
  std::optional<Window> Box;
  /** All axes of the file's box are periodic, so it is the window of the pack. Otherwise it is the
   * box of a simulation, which may be much larger than the pack. */
  bool BoxIsWindow = false;
  std::string LengthUnit;
  std::optional<double> Time; // or the step
  std::string Format;
  /** Centres that were moved into the box along periodic axes, and copies of spheres that were left
   * out. */
  std::size_t Wrapped = 0, Ghosts = 0;
  std::vector<std::string> Warnings;
};

/**
 * Makes a pack of a frame. Rows that only repeat a sphere in a neighbouring image of a box that is
 * not tilted are left out (FindPeriodicCopies).
 *
 * Throws std::invalid_argument for: no radius in file and settings; settings of radii that are not
 * positive numbers, or lack a type; an id, or a centre, that two spheres have; a sphere with the
 * centres of more than nine in ten others in it, which is a container that some programs write
 * along.
 */
FramePack MakePack(PackFrame frame, const PackSettings& settings);
}
