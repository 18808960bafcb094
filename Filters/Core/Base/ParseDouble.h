// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace ruc
{
/**
 * Reads a text that is one number, as std::from_chars takes it: in decimal form or with an
 * exponent, with a point whatever the locale, or "inf" or "nan"; without white space, "+" or
 * hexadecimal digits.
 *
 * Returns false, and leaves `value` as it is, if the text is anything else. A number beyond the
 * range of double, too large or too small, becomes infinity.
 */
bool ParseDouble(std::string_view text, double& value);

/**
 * The same by strtod in the C locale, which is slower. It is for standard libraries whose
 * from_chars knows only integers (GCC before 11).
 */
bool ParseDoubleByStrtod(std::string_view text, double& value);
}
