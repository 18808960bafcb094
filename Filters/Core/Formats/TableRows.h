// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/Fields.h"
#include "ruc/Formats/LineSource.h"

#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/**
 * The rows of a table as spreadsheets, numpy, pandas, R and Fortran write them. Columns are
 * separated by semicolons, tabs, commas or blanks, as the first row tells; fields may be in double
 * quotes. Comments (#, %, //), blank rows and rows of separators are passed over.
 */
class TableRows
{
public:
  static constexpr char Whitespace = ' '; // as a separator: any run of blanks and tabs

  /** `skipLines` lines at the start are passed over unread. */
  explicit TableRows(ByteStream& bytes, int skipLines = 0)
    : Lines(bytes)
    , SkipLines(skipLines)
  {
  }

  /**
   * Sets the fields of the next row, which are valid until the next call, or returns false at the
   * end. Throws std::invalid_argument for bytes that are not UTF-8.
   */
  bool Next(Fields& fields);

  /** From now on, a separator behind so many fields ends the row and begins no other field. */
  void SetCount(std::size_t count) { this->Count = count; }
  LineSource& GetLines() { return this->Lines; }
  /** The separator, or 0 before the first row. */
  char GetSeparator() const { return this->Separator; }
  /** The comments before the first row, without their marks; at most 1000. */
  const std::vector<std::string>& GetComments() const { return this->Comments; }

  /** Splits a line at a separator outside quotes. A field loses the quotes around it. */
  static void Split(std::string_view line, char separator, Fields& fields);

private:
  void RequireText(std::string_view line) const;

  LineSource Lines;
  int SkipLines;
  char Separator = 0;
  std::size_t Count = 0;
  std::vector<std::string> Comments;
};

/** Returns whether a field is a number, which may be infinite or none. */
bool IsNumber(std::string_view field);
}
