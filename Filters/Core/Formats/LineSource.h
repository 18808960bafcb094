// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/ByteStream.h"

#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/**
 * Reads the lines of a stream of bytes from some place on, one at a time, without their ends (LF,
 * CR LF, or CR alone). The last line need not have an end.
 */
class LineSource
{
public:
  static constexpr std::size_t LongestLine = 65536;

  /**
   * Begins at a byte that has `linesBefore` lines in front of it. The stream must outlive this
   * object.
   */
  explicit LineSource(ByteStream& bytes, std::uint64_t offset = 0, std::size_t linesBefore = 0);

  /**
   * Sets `line`, which is valid until the next call, or returns false at the end of the text.
   * Throws std::invalid_argument for a line of more than LongestLine bytes.
   */
  bool Next(std::string_view& line) { return this->Take(line, true); }
  /** Sets the same line as Next, which then gives it again. */
  bool Peek(std::string_view& line) { return this->Take(line, false); }
  /** Returns the next line, or refuses the text and says what the line should have been. */
  std::string_view Require(const char* what);
  /** Passes over `count` lines and returns how many there were. */
  std::size_t Skip(std::size_t count);

  /** Returns the place of the first byte of the next line. */
  std::uint64_t Offset() const { return this->BufferOffset + this->At; }
  /** Returns the number of the last line that Next gave, counted from 1. */
  std::size_t Line() const { return this->LinesBefore; }
  /** Returns a number of bytes that what is left does not exceed. */
  std::uint64_t MostBytesLeft() const;

  /** Throws std::invalid_argument "Line 12: …" about the last line. */
  [[noreturn]] void Fail(const std::string& what) const;

private:
  bool Take(std::string_view& line, bool goOn);
  bool FindEnd(std::size_t& end); // finds the end of the next line in the buffer
  void Refill();

  ByteStream& Bytes;
  std::vector<char> Buffer = std::vector<char>(2 * LongestLine);
  std::uint64_t BufferOffset;
  std::size_t LinesBefore;
  std::size_t At = 0, End = 0; // what is left in the buffer is between these
  bool AtEnd = false;
  char LineEnd = '\n';
};
}
