// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ruc
{
/** The fields of a line; they stay in the line's memory. */
using Fields = std::vector<std::string_view>;

/** Splits at runs of blanks and tabs. */
void SplitBlanks(std::string_view line, Fields& fields);

/** Without blanks, tabs and carriage returns around it. */
std::string_view TrimBlanks(std::string_view text);

/** The first lines of the beginning of a file, at most so many, without their ends. */
std::vector<std::string_view> FirstLines(std::string_view begin, std::size_t most);

/** In lower case, letters of ASCII only. */
std::string Lower(std::string_view text);

/** In single quotes, cut after 40 bytes, for messages. */
std::string Quote(std::string_view field);

/** A number as ParseDouble takes it, also with a "+" in front and with the exponent D of Fortran.
 */
bool ParseNumber(std::string_view field, double& value);

/** A whole number, also one that is written as 3.0 or 3e2, that a double holds exactly. */
bool ParseWhole(std::string_view field, std::int64_t& value);

/** All fields of the line as numbers; false where one is none, or is not finite. */
bool ParseNumbers(std::string_view line, std::vector<double>& numbers);

/** What is wrong with a field that is to be a finite number: "a finite number, got 'nan'." and the
 * like. */
std::string NumberFault(std::string_view field);
}
