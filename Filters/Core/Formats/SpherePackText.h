// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
struct SpherePackTextSettings
{
  /** Lines at the start of the text that are passed over unread. */
  int SkipLines = 0;
  /** Name or 1-based number of the column with the radius; empty: found by name, the fourth column
   * without a header. */
  std::string RadiusColumn;
  /** The column holds diameters. */
  bool RadiusIsDiameter = false;
  /** Multiplies every coordinate and radius. */
  double Scale = 1.0;
};

/** A pack as it stands in a text; `Mode` and `Id` are empty where the text has no such column. */
struct SpherePackText
{
  SpherePack Pack;
  std::vector<std::size_t> Line; // of every sphere, counted from 1

  /** Appends the i-th sphere of another table. */
  void Append(const SpherePackText& other, std::size_t i);
};

/**
 * Reads a table of spheres: one a line, columns separated by commas, semicolons, tabs or blanks,
 * decimal point. Blank lines and lines that begin with # are passed over; fields may be in double
 * quotes, without separators inside.
 *
 * The first line is a header if any of its fields is not a number. Then the columns are found by
 * name, in any case: x, y, z (also Points:0, Points_0, …), the radius as "radius", "r" or "rad", or
 * its double as "diameter", "d" or "diam"; "mode" and "id" are read where they exist. Without a
 * header the columns are x, y, z, radius.
 *
 * Throws std::invalid_argument that names the line and the column for: no spheres, a missing
 * column, a row with more or fewer fields than the first, text in a number, numbers that are not
 * finite, a radius <= 0, a mode or id that is no whole number, a line over 64 KiB, bytes that are
 * not UTF-8.
 */
SpherePackText ParseSpherePack(std::string_view text, const SpherePackTextSettings& settings);
}
