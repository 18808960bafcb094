// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/SpherePackText.h"

#include "ruc/Base/ParseDouble.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/Fields.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::size_t LongestLine = 65536;

[[noreturn]] void Fail(std::size_t line, const std::string& what)
{
  throw std::invalid_argument(Text("Line ", line, ": ", what));
}

std::string_view TrimField(std::string_view field)
{
  field = TrimBlanks(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
  {
    field = field.substr(1, field.size() - 2);
  }
  return field;
}

// Returns the separator, where ' ' stands for any run of blanks
char FindSeparator(std::string_view line)
{
  for (char separator : { ';', '\t', ',' })
  {
    if (line.find(separator) != std::string_view::npos)
    {
      return separator;
    }
  }
  return ' ';
}

void Split(std::string_view line, char separator, std::vector<std::string_view>& fields)
{
  fields.clear();
  if (separator == ' ')
  {
    for (std::size_t at = line.find_first_not_of(' '); at != std::string_view::npos;)
    {
      const std::size_t end = std::min(line.find(' ', at), line.size());
      fields.push_back(TrimField(line.substr(at, end - at)));
      at = line.find_first_not_of(' ', end);
    }
    return;
  }
  for (std::size_t at = 0; at <= line.size();)
  {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    fields.push_back(TrimField(line.substr(at, end - at)));
    at = end + 1;
  }
  if (fields.size() > 1 && fields.back().empty()) // a separator at the end of the line
  {
    fields.pop_back();
  }
}

// Unlike ParseNumber it takes no exponent D
bool ReadNumber(std::string_view field, double& value)
{
  if (field.size() > 1 && field.front() == '+')
  {
    field.remove_prefix(1);
  }
  return ParseDouble(field, value); // infinity, also for what is beyond its range, is refused later
}

struct Columns
{
  int X = 0, Y = 1, Z = 2, Radius = 3, Mode = -1, Id = -1;
  bool Diameter = false;
  std::size_t Count = 0; // the number of fields in a row
  std::vector<std::string> Names;

  std::string Name(int column) const
  {
    return this->Names.empty() ? Text("column ", column + 1)
                               : Text("column ", column + 1, " ('", this->Names[column], "')");
  }
};

int FindColumn(const std::vector<std::string>& names, std::initializer_list<const char*> wanted)
{
  for (const char* name : wanted)
  {
    for (std::size_t c = 0; c < names.size(); ++c)
    {
      if (Lower(names[c]) == name)
      {
        return static_cast<int>(c);
      }
    }
  }
  return -1;
}

// The columns' names as messages list them
std::string ListOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return list;
}

void FindNamedColumns(std::size_t line, Columns& columns)
{
  const struct
  {
    int& Column;
    const char* Name;
    std::initializer_list<const char*> Names;
  } axes[] = { { columns.X, "x", { "x", "points:0", "points_0" } },
    { columns.Y, "y", { "y", "points:1", "points_1" } },
    { columns.Z, "z", { "z", "points:2", "points_2" } } };
  for (const auto& axis : axes)
  {
    axis.Column = FindColumn(columns.Names, axis.Names);
    if (axis.Column < 0)
    {
      Fail(line,
        Text(
          "a column '", axis.Name, "' is required, got the columns ", ListOf(columns.Names), "."));
    }
  }
  columns.Mode = FindColumn(columns.Names, { "mode" });
  columns.Id = FindColumn(columns.Names, { "id" });
}

// The column that the settings name, or count from 1
void FindGivenRadius(std::size_t line, const std::string& given, Columns& columns)
{
  double number = 0.0;
  if (ReadNumber(given, number) && number == std::floor(number))
  {
    if (!(number >= 1.0 && number <= columns.Count))
    {
      Fail(line,
        Text("RadiusColumn requires a column from 1 to ", columns.Count, ", got ", number, "."));
    }
    columns.Radius = static_cast<int>(number) - 1;
    return;
  }
  columns.Radius = FindColumn(columns.Names, { Lower(given).c_str() });
  if (columns.Radius < 0)
  {
    Fail(line,
      Text("RadiusColumn requires a column '", given, "', got ",
        columns.Names.empty() ? "a text without header" : "the columns " + ListOf(columns.Names),
        "."));
  }
}

void FindNamedRadius(std::size_t line, Columns& columns)
{
  columns.Radius = FindColumn(columns.Names, { "radius", "r", "rad" });
  if (columns.Radius < 0)
  {
    columns.Radius = FindColumn(columns.Names, { "diameter", "d", "diam" });
    columns.Diameter = true;
  }
  if (columns.Radius < 0)
  {
    Fail(line,
      Text("a column 'radius' or 'diameter' is required (or RadiusColumn set), got the columns ",
        ListOf(columns.Names), "."));
  }
}

Columns FindColumns(std::size_t line, const std::vector<std::string_view>& fields, bool header,
  const SpherePackTextSettings& settings)
{
  Columns columns;
  columns.Count = fields.size();
  columns.Diameter = settings.RadiusIsDiameter;
  const bool given = !settings.RadiusColumn.empty();
  if (header)
  {
    columns.Names.assign(fields.begin(), fields.end());
    FindNamedColumns(line, columns);
  }
  else if (columns.Count < (given ? 3u : 4u))
  {
    Fail(line,
      Text("the columns x, y, z and radius are required, got ", columns.Count, " column(s)."));
  }
  if (given)
  {
    FindGivenRadius(line, settings.RadiusColumn, columns);
  }
  else if (header)
  {
    FindNamedRadius(line, columns);
  }
  return columns;
}

double Number(
  std::size_t line, const std::vector<std::string_view>& fields, const Columns& columns, int column)
{
  double value = 0.0;
  if (!ReadNumber(fields[column], value))
  {
    Fail(line, Text(columns.Name(column), " requires a number, got ", Quote(fields[column]), "."));
  }
  if (!std::isfinite(value))
  {
    Fail(line,
      Text(columns.Name(column), " requires a finite number, got ", Quote(fields[column]), "."));
  }
  return value;
}

// Reads the whole number of a field, which a double holds exactly. If the field is no whole number,
// the column is left out, with what was read of it: not every program means the same by such a name
template <class Value>
void AppendWhole(std::size_t line, const std::vector<std::string_view>& fields, int& column,
  double most, const Columns& columns, std::vector<Value>& values,
  std::vector<std::string>& leftOut)
{
  double value = 0.0;
  if (ReadNumber(fields[column], value) && value == std::floor(value) && std::abs(value) <= most)
  {
    values.push_back(static_cast<Value>(value));
    return;
  }
  leftOut.push_back(Text(columns.Name(column), " is left out: whole numbers are required, got ",
    Quote(fields[column]), " in line ", line, "."));
  values.clear();
  column = -1;
}

// Returns a line without the blanks around it, or an empty text where it is to be passed over
std::string_view CheckLine(std::size_t number, std::string_view line)
{
  if (line.size() > LongestLine)
  {
    Fail(number,
      Text("a line of at most ", LongestLine, " bytes is required, got ", line.size(), "."));
  }
  const std::size_t bad = FindBadByte(line);
  if (bad != std::string_view::npos)
  {
    Fail(number,
      Text("UTF-8 text is required, got the byte ",
        static_cast<unsigned>(static_cast<unsigned char>(line[bad])), " at place ", bad + 1, "."));
  }
  line = TrimBlanks(line);
  return line.empty() || line.front() == '#' ? std::string_view() : line;
}

bool IsHeader(const std::vector<std::string_view>& fields)
{
  double ignored;
  return std::any_of(
    fields.begin(), fields.end(), [&](auto field) { return !ReadNumber(field, ignored); });
}

// Appends the sphere of a row
void AppendRow(std::size_t number, const std::vector<std::string_view>& fields, Columns& columns,
  double scale, SpherePackText& result)
{
  SpherePack& pack = result.Pack;
  if (fields.size() != columns.Count)
  {
    Fail(number,
      Text(columns.Count, " fields are required as in the first line, got ", fields.size(), "."));
  }
  const double radius =
    Number(number, fields, columns, columns.Radius) * (columns.Diameter ? 0.5 : 1.0);
  if (!(radius >= 0.0))
  {
    Fail(number,
      Text(columns.Name(columns.Radius), " requires a number >= 0, got ",
        Quote(fields[columns.Radius]), "."));
  }
  const double numbers[4] = { Number(number, fields, columns, columns.X),
    Number(number, fields, columns, columns.Y), Number(number, fields, columns, columns.Z),
    radius };
  for (double value : numbers)
  {
    if (!(std::abs(scale * value) <= GreatestLength) ||
      (radius > 0.0 && scale * radius < LeastLength))
    {
      Fail(number,
        Text("coordinates of at most ", GreatestLength, " and radii of 0 or from ", LeastLength,
          " are required, got ", value, " and radius ", radius, " times Scale, ", scale, "."));
    }
  }
  pack.X.push_back(scale * numbers[0]);
  pack.Y.push_back(scale * numbers[1]);
  pack.Z.push_back(scale * numbers[2]);
  pack.Radius.push_back(scale * radius);
  if (columns.Mode >= 0)
  {
    AppendWhole(number, fields, columns.Mode, std::numeric_limits<int>::max(), columns, pack.Mode,
      result.LeftOut);
  }
  if (columns.Id >= 0)
  {
    AppendWhole(number, fields, columns.Id, 9007199254740992.0, columns, pack.Id, result.LeftOut);
  }
}
}

void SpherePackText::Append(const SpherePackText& other, std::size_t i)
{
  this->Pack.Append(other.Pack, i);
  this->Line.push_back(other.Line[i]);
}

SpherePackText ParseSpherePack(std::string_view text, const SpherePackTextSettings& settings)
{
  Require(std::isfinite(settings.Scale) && settings.Scale > 0.0, "Scale", "a finite number > 0",
    settings.Scale);
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, byteOrderMark.size()) == byteOrderMark)
  {
    text.remove_prefix(byteOrderMark.size());
  }
  const auto skipped = static_cast<std::size_t>(std::max(settings.SkipLines, 0));
  SpherePackText result;
  Columns columns;
  char separator = ' ';
  bool first = true;
  std::vector<std::string_view> fields;
  for (std::size_t at = 0, number = 1; at < text.size(); ++number)
  {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view whole = text.substr(at, end - at);
    at = end + 1;
    const std::string_view line = number <= skipped ? "" : CheckLine(number, whole);
    if (line.empty())
    {
      continue;
    }
    separator = first ? FindSeparator(line) : separator;
    Split(line, separator, fields);
    const bool header = first && IsHeader(fields);
    if (first)
    {
      columns = FindColumns(number, fields, header, settings);
      first = false;
    }
    if (!header)
    {
      AppendRow(number, fields, columns, settings.Scale, result);
      result.Line.push_back(number);
    }
  }
  if (result.Pack.Empty())
  {
    throw std::invalid_argument("At least one line with a sphere is required, got none.");
  }
  return result;
}
}
