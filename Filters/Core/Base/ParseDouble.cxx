// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/ParseDouble.h"

#include <cerrno>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace ruc
{
bool ParseDouble(std::string_view text, double& value)
{
#ifdef __cpp_lib_to_chars
  double read = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  if (error == std::errc::invalid_argument || end != text.data() + text.size())
  {
    return false;
  }
  value = error == std::errc::result_out_of_range ? std::numeric_limits<double>::infinity() : read;
  return true;
#else
  return ParseDoubleByStrtod(text, value);
#endif
}

bool ParseDoubleByStrtod(std::string_view text, double& value)
{
  // This refuses what strtod takes and from_chars does not: leading space and plus, and hexadecimal
  // numbers
  const std::string_view digits = text.substr(!text.empty() && text.front() == '-' ? 1 : 0);
  if (digits.empty() ||
    std::string_view(".0123456789inIN").find(digits.front()) == std::string_view::npos ||
    digits.find_first_of("xX") != std::string_view::npos)
  {
    return false;
  }
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string copy(text); // ends with a zero
  char* end = nullptr;
  errno = 0;
  const double read = strtod_l(copy.c_str(), &end, plain);
  if (end != copy.c_str() + copy.size())
  {
    return false;
  }
  value = errno == ERANGE &&
      (std::isinf(read) || std::abs(read) < std::numeric_limits<double>::denorm_min())
    ? std::numeric_limits<double>::infinity()
    : read;
  return true;
}
}
