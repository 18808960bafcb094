// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/Fields.h"

#include "ruc/Base/ParseDouble.h"
#include "ruc/Base/Text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ruc
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}
}

void SplitBlanks(std::string_view line, Fields& fields)
{
  fields.clear();
  const char* at = line.data();
  const char* const end = at + line.size();
  while (true)
  {
    while (at != end && IsBlank(*at))
    {
      ++at;
    }
    if (at == end)
    {
      return;
    }
    const char* const begin = at;
    while (at != end && !IsBlank(*at))
    {
      ++at;
    }
    fields.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
}

std::string_view TrimBlanks(std::string_view text)
{
  while (!text.empty() && IsBlank(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsBlank(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

std::size_t FindBadByte(std::string_view text)
{
  for (std::size_t i = 0; i < text.size();)
  {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c != 0 && c < 0x80)
    {
      ++i;
      continue;
    }
    const std::size_t length = c >= 0xC2 && c < 0xE0 ? 2
      : c >= 0xE0 && c < 0xF0                        ? 3
      : c >= 0xF0 && c < 0xF5                        ? 4
                                                     : 0;
    bool good = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; good && k < length; ++k)
    {
      good = (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    }
    if (!good)
    {
      return i;
    }
    i += length;
  }
  return std::string_view::npos;
}

std::vector<std::string_view> FirstLines(std::string_view begin, std::size_t most)
{
  std::vector<std::string_view> lines;
  while (lines.size() < most && !begin.empty())
  {
    const std::size_t end = std::min(begin.find_first_of("\r\n"), begin.size());
    lines.push_back(begin.substr(0, end));
    begin.remove_prefix(std::min(begin.size(), begin.substr(end, 2) == "\r\n" ? end + 2 : end + 1));
  }
  return lines;
}

std::string Lower(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::string Quote(std::string_view field)
{
  constexpr std::size_t most = 40;
  return "'" + std::string(field.substr(0, most)) + (field.size() > most ? "…'" : "'");
}

bool ParseNumber(std::string_view field, double& value)
{
  if (ParseDouble(field, value))
  {
    return true;
  }
  if (field.size() > 1 && field.front() == '+' && field[1] != '-')
  {
    return ParseNumber(field.substr(1), value);
  }
  const std::size_t exponent = field.find_first_of("dD");
  if (exponent == std::string_view::npos || field.find_first_of("eE") != std::string_view::npos)
  {
    return false;
  }
  std::string plain(field);
  plain[exponent] = 'e';
  return ParseDouble(plain, value);
}

bool ParseWhole(std::string_view field, std::int64_t& value)
{
  const char* const end = field.data() + field.size();
  const auto [read, error] = std::from_chars(field.data(), end, value);
  if (error == std::errc() && read == end)
  {
    return true;
  }
  double number;
  if (!ParseNumber(field, number) || number != std::floor(number) ||
    std::abs(number) > 9007199254740992.0)
  {
    return false;
  }
  value = static_cast<std::int64_t>(number);
  return true;
}

bool ParseNumbers(std::string_view line, std::vector<double>& numbers)
{
  Fields fields;
  SplitBlanks(line, fields);
  numbers.assign(fields.size(), 0.0);
  for (std::size_t n = 0; n < fields.size(); ++n)
  {
    if (!ParseNumber(fields[n], numbers[n]) || !std::isfinite(numbers[n]))
    {
      return false;
    }
  }
  return true;
}

std::string NumberFault(std::string_view field)
{
  double value;
  const char* required = "a number";
  if (ParseNumber(field, value))
  {
    required = field.find_first_of("0123456789") == std::string_view::npos
      ? "a finite number"
      : "a number from 4.9e-324 to 1.8e308";
  }
  else
  {
    std::string point(field);
    const std::size_t comma = point.find(',');
    if (comma != std::string::npos)
    {
      point[comma] = '.';
      const bool decimal = ParseNumber(point, value);
      point.erase(std::remove(point.begin(), point.end(), ','), point.end());
      point.erase(comma, 1);
      required = decimal            ? "a decimal point"
        : ParseNumber(point, value) ? "a number without marks between thousands"
                                    : required;
    }
  }
  return Text(required, ", got ", Quote(field), ".");
}
}
