// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace ruc
{
/**
 * Reads a text that is one number as std::from_chars takes it: in decimal or with an exponent, with
 * a point whatever the locale, also "inf" and "nan"; no white space, "+" or hexadecimal digits.
 *
 * Returns false where it is anything else, and leaves `value` as it is. A number beyond the range
 * of double, too large or too small, is infinity.
 */
bool ParseDouble(std::string_view text, double& value);

/**
 * The same by strtod in the C locale, for standard libraries whose from_chars knows integers only
 * (GCC before 11); slower.
 */
bool ParseDoubleByStrtod(std::string_view text, double& value);
}
