// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/PackFormats.h"
#include "ruc/Formats/SphereRows.h"

#include <string>
#include <vector>

namespace ruc
{
/** The meaning of the columns of a table. */
struct TableColumns
{
  RowColumns Columns;
  std::string LengthUnit;
  /** Whether the columns have no names. They are then x y z or x y z radius, by their number. */
  bool Nameless = false;
  /** Sentences that tell which of two columns was taken that may be the same. */
  std::vector<std::string> Warnings;
};

/**
 * Finds the columns by their names, in upper or lower case, after a unit in brackets or parentheses
 * is split off: x, "position x", pos_x, CenterX, Points:0, Points_0; radius, radii, rad, r, in
 * this order; diameter, diameters, diam, d; id; type, matId, species; mode. ReadSettings::Columns
 * and RadiusColumn come first; a radius column that is given by name or number, and is named as a
 * diameter, holds diameters. `units` may be empty, or hold a unit for each column.
 *
 * A radius of 0 is taken, for a point. Where several names stand for one role, the first is taken,
 * with a warning.
 *
 * Throws std::invalid_argument for a missing column, two of one name that stand for a role,
 * settings that do not fit, and lengths in different units.
 */
TableColumns FindNamedColumns(const std::vector<std::string>& names,
  const std::vector<std::string>& units, const ReadSettings& settings);

/**
 * Returns the columns of a table without names: three are x y z, four are x y z radius. More are
 * refused, as it cannot be known what they are.
 */
TableColumns FindNamelessColumns(std::size_t count, const ReadSettings& settings);

/**
 * Returns the place of the column whose name stands for a role, as FindNamedColumns tells, or -1 if
 * there is none.
 */
int FindColumn(const std::vector<std::string>& names, RowColumns::Role role);

/**
 * Returns a sentence that tells which of several columns whose names stand for a role is taken, and
 * what chooses another; an empty text where no two do.
 */
std::string TellTaken(
  const std::vector<std::string>& names, RowColumns::Role role, const std::string& chooser);

/** Returns whether names have columns x, y and z. */
bool NameCentres(const std::vector<std::string>& names);

/** Returns whether the text is a unit of length that is known here. */
bool IsLengthUnit(std::string_view text);
}
