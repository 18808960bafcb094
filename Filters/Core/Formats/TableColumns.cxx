// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/TableColumns.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <stdexcept>

namespace ruc
{
namespace
{
[[noreturn]] void Fail(const std::string& what)
{
  throw std::invalid_argument(what);
}

// "Position X [mm]" is "position x" in "mm"
struct ColumnName
{
  std::string Name, Unit;
};

std::string Canonical(const std::string& unit)
{
  for (const char* micro : { "um", "μm", "micron", "microns", "µm" })
  {
    if (unit == micro)
    {
      return "µm";
    }
  }
  return unit;
}

ColumnName SplitUnit(const std::string& given)
{
  const std::string text(TrimBlanks(given));
  const char close = text.empty() ? ' ' : text.back();
  const std::size_t open = close == ']' ? text.rfind('[')
    : close == ')'                      ? text.rfind('(')
                                        : std::string::npos;
  if (open == std::string::npos || open == 0)
  {
    return { Lower(text), {} };
  }
  return { Lower(TrimBlanks(std::string_view(text).substr(0, open))),
    std::string(TrimBlanks(std::string_view(text).substr(open + 1, text.size() - open - 2))) };
}

std::vector<ColumnName> SplitUnits(const std::vector<std::string>& given)
{
  std::vector<ColumnName> names;
  std::transform(given.begin(), given.end(), std::back_inserter(names), SplitUnit);
  return names;
}

bool IsOneOf(const std::string& name, std::initializer_list<const char*> names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Whether a name stands for the axis: "x", or a word for a place and "x" or "0" behind it
bool IsAxis(const std::string& name, int axis)
{
  const char letter = "xyz"[axis], digit = "012"[axis];
  if (name == std::string(1, letter))
  {
    return true;
  }
  for (const char* word :
    { "position", "pos", "center", "centre", "centroid", "points", "coordinates", "coords" })
  {
    std::string_view rest = name;
    const std::string_view begin = word;
    if (rest.substr(0, begin.size()) != begin)
    {
      continue;
    }
    rest.remove_prefix(begin.size());
    if (!rest.empty() && std::string_view(" _:.-").find(rest.front()) != std::string_view::npos)
    {
      rest.remove_prefix(1);
    }
    if (rest.size() == 1 && (rest[0] == letter || rest[0] == digit))
    {
      return true;
    }
  }
  return false;
}

// The names that stand for a role other than an axis; the first is the surest
const std::vector<std::string>& NamesOf(int role)
{
  static const std::vector<std::string> names[RowColumns::NumberOfRoles] = { {}, {}, {},
    { "radius", "radii", "rad", "r" }, { "diameter", "diameters", "diam", "d" }, { "id" },
    { "type", "matid", "species" }, { "mode" } };
  return names[role];
}

int FindRole(const std::vector<ColumnName>& names, int role)
{
  const auto find = [&](const auto& isIt)
  {
    const auto found = std::find_if(
      names.begin(), names.end(), [&](const ColumnName& name) { return isIt(name.Name); });
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  };
  if (role <= RowColumns::Z)
  {
    return find([role](const std::string& name) { return IsAxis(name, role); });
  }
  int place = -1;
  for (const std::string& known : NamesOf(role))
  {
    place = place < 0 ? find([&known](const std::string& name) { return name == known; }) : place;
  }
  return place;
}

bool StandsFor(const ColumnName& name, int role)
{
  return FindRole({ name }, role) == 0;
}

std::vector<std::size_t> OthersOf(const std::vector<ColumnName>& names, int role, int taken)
{
  std::vector<std::size_t> others;
  for (std::size_t n = 0; taken >= 0 && n < names.size(); ++n)
  {
    if (static_cast<int>(n) != taken && StandsFor(names[n], role))
    {
      others.push_back(n);
    }
  }
  return others;
}

// Other columns than the one that was taken for a role, which may be it as well
void CheckOthers(
  TableColumns& table, const std::vector<ColumnName>& names, int role, const std::string& chooser)
{
  const int place = table.Columns.Field[static_cast<std::size_t>(role)];
  for (const std::size_t other : OthersOf(names, role, place))
  {
    const ColumnName& taken = names[static_cast<std::size_t>(place)];
    if (names[other].Name == taken.Name)
    {
      Fail(Text("one column '", taken.Name, "' is required, got columns ", place + 1, " and ",
        other + 1, ": set Columns, in which - skips one."));
    }
    table.Warnings.push_back(
      Text("Column ", place + 1, ", '", taken.Name, "', is taken and column ", other + 1, ", '",
        names[other].Name, "', is not: ", chooser, " chooses."));
  }
}

std::string ListOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return list;
}

std::vector<std::string> SplitSetting(const std::string& columns)
{
  std::vector<std::string> names(1);
  for (char c : columns)
  {
    if (c == ',' || c == ';')
    {
      names.emplace_back();
    }
    else
    {
      names.back() += c;
    }
  }
  return names;
}

// The column that RadiusColumn names, or counts from 1
int FindGivenRadius(
  const std::vector<ColumnName>& names, std::size_t count, const ReadSettings& settings)
{
  const std::string& given = settings.RadiusColumn;
  std::int64_t number;
  if (ParseWhole(given, number))
  {
    if (number < 1 || number > static_cast<std::int64_t>(count))
    {
      Fail(Text("RadiusColumn requires a column from 1 to ", count, ", got ", number, "."));
    }
    return static_cast<int>(number) - 1;
  }
  const std::string wanted = SplitUnit(given).Name;
  for (std::size_t c = 0; c < names.size(); ++c)
  {
    if (names[c].Name == wanted)
    {
      return static_cast<int>(c);
    }
  }
  std::vector<std::string> found(names.size());
  std::transform(
    names.begin(), names.end(), found.begin(), [](const ColumnName& name) { return name.Name; });
  Fail(Text("RadiusColumn requires a column ", Quote(given), ", got ",
    found.empty() ? "a table without names" : "the columns " + ListOf(found), "."));
}

void SetRadius(
  RowColumns& columns, const std::vector<ColumnName>& names, const ReadSettings& settings)
{
  int& radius = columns.Field[RowColumns::Radius];
  int& diameter = columns.Field[RowColumns::Diameter];
  if (!settings.RadiusColumn.empty())
  {
    const int given = FindGivenRadius(names, columns.Count, settings);
    const bool named = static_cast<std::size_t>(given) < names.size() &&
      StandsFor(names[static_cast<std::size_t>(given)], RowColumns::Diameter);
    radius = named ? -1 : given;
    diameter = named ? given : -1;
  }
  if (settings.RadiusIsDiameter && radius >= 0)
  {
    diameter = radius;
    radius = -1;
  }
}

// One unit for all lengths, or none
std::string UnitOf(const RowColumns& columns, const std::vector<ColumnName>& names,
  const std::vector<std::string>& units)
{
  std::string unit, where;
  for (int role = RowColumns::X; role <= RowColumns::Diameter; ++role)
  {
    if (!columns.Has(static_cast<RowColumns::Role>(role)))
    {
      continue;
    }
    const auto place = static_cast<std::size_t>(columns.Field[static_cast<std::size_t>(role)]);
    const std::string own = !names[place].Unit.empty() ? names[place].Unit
      : place < units.size()                           ? units[place]
                                                       : "";
    if (own.empty())
    {
      continue;
    }
    const std::string& name = columns.Names[place];
    const std::string plain(TrimBlanks(std::string_view(name).substr(0, name.find_first_of("[("))));
    if (!unit.empty() && Canonical(own) != Canonical(unit))
    {
      Fail(Text(where, " is in ", unit, ", ", plain, " in ", own, ": one unit is required."));
    }
    if (unit.empty())
    {
      unit = own;
      where = plain;
    }
  }
  return Canonical(unit);
}
}

TableColumns FindNamedColumns(const std::vector<std::string>& found,
  const std::vector<std::string>& units, const ReadSettings& settings)
{
  const std::vector<std::string> given =
    settings.Columns.empty() ? found : SplitSetting(settings.Columns);
  if (given.size() != found.size())
  {
    Fail(Text("Columns requires a name for each of ", found.size(), " columns, got ", given.size(),
      ": ", settings.Columns, "."));
  }
  const std::vector<ColumnName> names = SplitUnits(given);
  TableColumns table;
  RowColumns& columns = table.Columns;
  columns.Points = true;
  columns.Count = given.size();
  columns.Names = given;
  for (int role = 0; role < RowColumns::NumberOfRoles; ++role)
  {
    columns.Field[static_cast<std::size_t>(role)] = FindRole(names, role);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (columns.Field[static_cast<std::size_t>(axis)] < 0)
    {
      Fail(Text("a column '", "xyz"[axis], "' is required, got the columns ", ListOf(given),
        settings.Columns.empty()
          ? ": set Columns to name them, or SkipLines where they begin later."
          : "."));
    }
  }
  for (int role = 0; role < RowColumns::NumberOfRoles; ++role)
  {
    const bool radius = role == RowColumns::Radius || role == RowColumns::Diameter;
    if (!radius || settings.RadiusColumn.empty())
    {
      CheckOthers(table, names, role, radius ? "RadiusColumn" : "Columns");
    }
  }
  SetRadius(columns, names, settings);
  table.LengthUnit = UnitOf(columns, names, units);
  return table;
}

TableColumns FindNamelessColumns(std::size_t count, const ReadSettings& settings)
{
  if (!settings.Columns.empty())
  {
    return FindNamedColumns(std::vector<std::string>(count), {}, settings);
  }
  if (count < 3)
  {
    Fail(Text("the columns x, y, z and radius are required, got ", count, " column(s)."));
  }
  if (count > 4)
  {
    Fail(Text(count, " columns without names: set Columns, such as id,x,y,z,r."));
  }
  TableColumns table;
  table.Nameless = true;
  table.Columns.Points = true;
  table.Columns.Count = count;
  table.Columns.Field = { 0, 1, 2, count == 4 ? 3 : -1, -1, -1, -1, -1 };
  SetRadius(table.Columns, {}, settings);
  return table;
}

int FindColumn(const std::vector<std::string>& names, RowColumns::Role role)
{
  return FindRole(SplitUnits(names), role);
}

std::string TellTaken(
  const std::vector<std::string>& names, RowColumns::Role role, const std::string& chooser)
{
  const std::vector<ColumnName> split = SplitUnits(names);
  const int taken = FindRole(split, role);
  std::vector<std::string> others;
  for (const std::size_t other : OthersOf(split, role, taken))
  {
    others.push_back(names[other]);
  }
  return others.empty()
    ? std::string()
    : Text("'", names[static_cast<std::size_t>(taken)], "' is taken and ", ListOf(others),
        others.size() == 1 ? " is" : " are", " not: ", chooser, " chooses.");
}

bool NameCentres(const std::vector<std::string>& names)
{
  const std::vector<ColumnName> split = SplitUnits(names);
  return FindRole(split, RowColumns::X) >= 0 && FindRole(split, RowColumns::Y) >= 0 &&
    FindRole(split, RowColumns::Z) >= 0;
}

bool IsLengthUnit(std::string_view text)
{
  return IsOneOf(Lower(TrimBlanks(text)),
    { "m", "cm", "mm", "um", "µm", "μm", "micron", "microns", "nm", "in", "km", "å" });
}
}
