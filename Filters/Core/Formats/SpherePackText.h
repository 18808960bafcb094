// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/** How a text is read. */
struct SpherePackTextSettings
{
  /** The number of lines at the start of the text that are passed over unread. */
  int SkipLines = 0;
  /**
   * The name, or the number counted from 1, of the column with the radius. Where it is empty, the
   * column is found by name, and is the fourth in a text without header.
   */
  std::string RadiusColumn;
  /**
   * Whether that column holds diameters. A column that is found by the name of a diameter always
   * does.
   */
  bool RadiusIsDiameter = false;
  /** A factor for every coordinate and radius; finite and > 0. */
  double Scale = 1.0;
};

/**
 * A pack as it stands in a text. `Mode` and `Id` are empty if the text has no such column of whole
 * numbers. Spheres of radius 0 are points, which no filter takes for spheres.
 */
struct SpherePackText
{
  SpherePack Pack;
  std::vector<std::size_t> Line;    // the line of every sphere, counted from 1
  std::vector<std::string> LeftOut; // a sentence on each column that could not be read

  /** Appends the i-th sphere of another text. */
  void Append(const SpherePackText& other, std::size_t i);
};

/**
 * Reads a table of spheres, one in each line. Columns are separated by semicolons, tabs, commas or
 * blanks, whichever of these the first line holds, in this order; the decimal mark is a point.
 * Blank lines and lines that begin with # are passed over. Fields may be in double quotes, without
 * separators inside.
 *
 * The first line is a header if any of its fields is not a number. Then the columns are found by
 * name, in upper or lower case: x, y, z (or Points:0, Points_0, …), the radius as "radius", "r" or
 * "rad", or the diameter as "diameter", "d" or "diam"; "mode" and "id" are read where they exist,
 * and left out where any of their fields is no whole number. Without a header the columns are x, y,
 * z and radius.
 *
 * Throws std::invalid_argument that names the line, and the column where there is one, for: no
 * spheres, a missing column, a row with more or fewer fields than the first, text in place of a
 * number, numbers that are not finite, a radius below 0, a line over 64 KiB, and bytes that are not
 * UTF-8; also for a scale that is not finite and > 0, and for coordinates and radii that are then
 * beyond the range of lengths that Window.h tells.
 */
SpherePackText ParseSpherePack(std::string_view text, const SpherePackTextSettings& settings);
}
