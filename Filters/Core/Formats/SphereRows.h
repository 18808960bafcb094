// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/Fields.h"
#include "ruc/Formats/LineSource.h"
#include "ruc/Formats/PackFrame.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace ruc
{
/** The meaning of the fields of a row. */
struct RowColumns
{
  enum Role
  {
    X,
    Y,
    Z,
    Radius,
    Diameter,
    Id,
    Type,
    Mode,
    NumberOfRoles
  };

  /** The field of each role, counted from 0; -1 means none. */
  std::array<int, NumberOfRoles> Field = { -1, -1, -1, -1, -1, -1, -1, -1 };
  /**
   * A row with fewer fields than `Count` is refused, and one with more is refused unless `More`.
   */
  std::size_t Count = 0;
  bool More = false;
  /** Whether a radius of 0 is taken, which stands for a point; else radii are > 0. */
  bool Points = false;
  /** The names of the fields, for messages; may be empty. */
  std::vector<std::string> Names;

  /**
   * Finds the fields by their names, letter for letter ("x", "y", "z", "radius", "diameter", "id",
   * "type", "mode"). Other names are left out.
   */
  static RowColumns Named(const std::vector<std::string>& names);
  bool Has(Role role) const { return this->Field[role] >= 0; }
  /** Returns a text such as "column 3 ('x')". */
  std::string Describe(int field) const;
};

/**
 * Reads rows of spheres into a frame; the numbers of every text format are checked here. If a row
 * tells both radius and diameter, they must agree. Ids or modes that are not whole numbers are left
 * out with a warning, as not every program means the same by such a name; types may be names.
 *
 * Every refusal is std::invalid_argument that names the line.
 */
class SphereRows
{
public:
  /** The line source and the frame must outlive this object. */
  SphereRows(LineSource& lines, const RowColumns& columns, PackFrame& frame);

  /**
   * Reads the next `count` lines. Refuses a number for which the rest of the file has no room,
   * before memory is taken.
   */
  void Read(std::int64_t count);
  /** Reads all lines up to the end, or to one that begins with `end`; leaves blank lines out. */
  void ReadAll(std::string_view end = {});
  /** Appends a row that is already split. */
  void Append(const Fields& fields);
  /**
   * Is called after the last row and numbers types that are names. Read and ReadAll do so
   * themselves.
   */
  void Finish();

private:
  double Number(const Fields& fields, int field) const;
  double RadiusOf(const Fields& fields) const;
  // Appends to an array of whole numbers, which is given up if a field is no whole number
  template <class T>
  void AppendWhole(const Fields& fields, int field, std::vector<T>& values, bool& has);
  void AppendType(std::string_view field);

  LineSource& Lines;
  RowColumns Columns;
  PackFrame& Frame;
  bool HasIds, HasModes;
  std::map<std::string, int, std::less<>> Names; // the names of types, numbered as they come
  Fields Row;
};

/**
 * Refuses a stated number of rows that is below 0, or for which the rest of the file has no room if
 * each row has at least `leastBytes`.
 */
void CheckStatedRows(const LineSource& lines, std::int64_t count, std::uint64_t leastBytes);
}
