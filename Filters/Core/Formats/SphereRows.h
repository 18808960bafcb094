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
/** Which field of a row means what. */
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

  /** The field of each role, from 0; -1: none. */
  std::array<int, NumberOfRoles> Field = { -1, -1, -1, -1, -1, -1, -1, -1 };
  /** Fewer fields than these in a row are refused, and more unless `More`. */
  std::size_t Count = 0;
  bool More = false;
  /** Names of the fields, for messages; may be empty. */
  std::vector<std::string> Names;

  /** Fields by their names, letter for letter ("x", "y", "z", "radius", "diameter", "id", "type",
   * "mode"); others are left out. */
  static RowColumns Named(const std::vector<std::string>& names);
  bool Has(Role role) const { return this->Field[role] >= 0; }
  /** "column 3 ('x')" */
  std::string Describe(int field) const;
};

/**
 * Reads rows of spheres into a frame: the numbers of every text format are checked here. Where a
 * row tells both radius and diameter they must agree. Ids that are not whole numbers are left out
 * with a warning; types may be names.
 *
 * All refusals are std::invalid_argument with the line.
 */
class SphereRows
{
public:
  /** Line source and frame must outlive this. */
  SphereRows(LineSource& lines, const RowColumns& columns, PackFrame& frame);

  /** The next `count` lines; refuses a number that the rest of the file has no room for before
   * memory is taken. */
  void Read(std::int64_t count);
  /** All lines up to the end or to one that begins with `end`, blank ones left out. */
  void ReadAll(std::string_view end = {});
  /** One row that is split already. */
  void Append(const Fields& fields);
  /** After the last row: numbers types that are names. Read and ReadAll do so themselves. */
  void Finish();

private:
  double Number(const Fields& fields, int field) const;
  double RadiusOf(const Fields& fields) const;
  // One of an array of whole numbers that is given up where a field is none
  template <class T>
  void AppendWhole(const char* what, std::string_view field, std::vector<T>& values, bool& has);
  void AppendType(std::string_view field);

  LineSource& Lines;
  RowColumns Columns;
  PackFrame& Frame;
  bool HasIds, HasModes;
  std::map<std::string, int, std::less<>> Names; // of types, numbered as they come
  Fields Row;
};

/** Refuses a stated number of rows, each of at least so many bytes, that is below 0 or more than
 * the rest of the file has room for. */
void CheckStatedRows(const LineSource& lines, std::int64_t count, std::uint64_t leastBytes);
}
