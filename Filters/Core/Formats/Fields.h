// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/** The fields of a line, which stay in the line's memory. */
using Fields = std::vector<std::string_view>;

/** Splits a line at runs of blanks and tabs. */
void SplitBlanks(std::string_view line, Fields& fields);

/** Returns a text without the blanks, tabs and carriage returns around it. */
std::string_view TrimBlanks(std::string_view text);

/** Returns the place of the first byte that is null or not UTF-8, or npos. */
std::size_t FindBadByte(std::string_view text);

/**
 * Returns the first lines of the beginning of a file, without their ends; at most `most` of them.
 */
std::vector<std::string_view> FirstLines(std::string_view begin, std::size_t most);

/** Returns a text in lower case. Only letters of ASCII change. */
std::string Lower(std::string_view text);

/** Returns a field in single quotes, cut after 40 bytes, for messages. */
std::string Quote(std::string_view field);

/**
 * Reads a number as ParseDouble does, also with a "+" in front and with the exponent D of Fortran.
 */
bool ParseNumber(std::string_view field, double& value);

/** Reads a whole number that a double holds exactly, also one that is written as 3.0 or 3e2. */
bool ParseWhole(std::string_view field, std::int64_t& value);

/** Reads all fields of the line as numbers. Returns false if one is no number or not finite. */
bool ParseNumbers(std::string_view line, std::vector<double>& numbers);

/**
 * Returns what is wrong with a field that should be a finite number, such as "a finite number, got
 * 'nan'."
 */
std::string NumberFault(std::string_view field);
}
