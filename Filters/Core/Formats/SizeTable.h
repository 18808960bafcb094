// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/ByteStream.h"

#include <vector>

namespace ruc
{
/** The sizes of spheres, as a file tells them: a list of diameters, or a sieve curve. */
struct SizeTable
{
  /** The diameters in the order of the file, or the openings of the sieves, which rise. */
  std::vector<double> Diameters;
  /**
   * For each sieve the per cent of the volume that passes it. It begins with 0, never falls, and
   * ends with 100. Empty for a list of diameters.
   */
  std::vector<double> Passing;
};

/**
 * Reads a table (TableRows) of one column, with a diameter a line, or of two, with the opening of a
 * sieve and what passes it a line. A first line without numbers holds names; a column that is named
 * as a radius holds radii.
 *
 * Throws std::invalid_argument, which names the line, for other tables, for what is no number, such
 * as one with a decimal comma, for lengths that are not above 0, and for a curve that does not rise
 * from 0 to 100.
 */
SizeTable ReadSizeTable(ByteStream& bytes);
}
