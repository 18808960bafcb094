// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/SphereRows.h"

#include "ruc/Base/Text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ruc
{
RowColumns RowColumns::Named(const std::vector<std::string>& names)
{
  static const char* const roles[NumberOfRoles] = { "x", "y", "z", "radius", "diameter", "id",
    "type", "mode" };
  RowColumns columns;
  columns.Names = names;
  columns.Count = names.size();
  for (int role = 0; role < NumberOfRoles; ++role)
  {
    const auto found = std::find(names.begin(), names.end(), roles[role]);
    columns.Field[role] = found == names.end() ? -1 : static_cast<int>(found - names.begin());
  }
  return columns;
}

std::string RowColumns::Describe(int field) const
{
  const auto place = static_cast<std::size_t>(field);
  return place < this->Names.size() ? Text("column ", field + 1, " ('", this->Names[place], "')")
                                    : Text("column ", field + 1);
}

SphereRows::SphereRows(LineSource& lines, const RowColumns& columns, PackFrame& frame)
  : Lines(lines)
  , Columns(columns)
  , Frame(frame)
  , HasIds(columns.Has(RowColumns::Id))
  , HasModes(columns.Has(RowColumns::Mode))
{
}

void CheckStatedRows(const LineSource& lines, std::int64_t count, std::uint64_t leastBytes)
{
  const std::uint64_t room = (lines.MostBytesLeft() + 1) / leastBytes; // no end of the last line
  if (count < 0 || static_cast<std::uint64_t>(count) > room)
  {
    throw std::invalid_argument(Text(count, " rows are stated, the file has room for ", room, "."));
  }
}

void SphereRows::Read(std::int64_t count)
{
  CheckStatedRows(this->Lines, count, 2 * this->Columns.Count);
  const auto rows = static_cast<std::size_t>(count);
  // A packed stream may state room that it does not have
  const std::size_t reserved = std::min<std::size_t>(rows, 1u << 22);
  for (std::vector<double>* array : { &this->Frame.X, &this->Frame.Y, &this->Frame.Z })
  {
    array->reserve(reserved);
  }
  this->Frame.Radius.reserve(
    this->Columns.Has(RowColumns::Radius) || this->Columns.Has(RowColumns::Diameter) ? reserved
                                                                                     : 0);
  this->Frame.Id.reserve(this->Columns.Has(RowColumns::Id) ? reserved : 0);
  this->Frame.Type.reserve(this->Columns.Has(RowColumns::Type) ? reserved : 0);
  std::string_view line;
  for (std::size_t n = 0; n < rows; ++n)
  {
    const bool found = this->Lines.Next(line);
    SplitBlanks(found ? line : std::string_view(), this->Row);
    std::string_view next;
    if (!found || (this->Row.size() < this->Columns.Count && !this->Lines.Peek(next)))
    {
      throw std::invalid_argument(Text(count, " rows are required, got ", n, "."));
    }
    this->Append(this->Row);
  }
  this->Finish();
}

void SphereRows::ReadAll(std::string_view end)
{
  std::string_view line;
  while (this->Lines.Peek(line) && (end.empty() || line.substr(0, end.size()) != end))
  {
    this->Lines.Next(line);
    SplitBlanks(line, this->Row);
    if (!this->Row.empty())
    {
      this->Append(this->Row);
    }
  }
  this->Finish();
}

double SphereRows::Number(const Fields& fields, int field) const
{
  double value;
  const std::string_view text = fields[static_cast<std::size_t>(field)];
  if (!ParseNumber(text, value) || !std::isfinite(value))
  {
    this->Lines.Fail(this->Columns.Describe(field) + " requires " + NumberFault(text));
  }
  return value;
}

double SphereRows::RadiusOf(const Fields& fields) const
{
  const int radius = this->Columns.Field[RowColumns::Radius];
  const int diameter = this->Columns.Field[RowColumns::Diameter];
  const int field = radius >= 0 ? radius : diameter;
  const double value = this->Number(fields, field) * (radius >= 0 ? 1.0 : 0.5);
  if (!(value > 0.0 || (this->Columns.Points && value == 0.0)))
  {
    this->Lines.Fail(
      Text(this->Columns.Describe(field), " requires a number >", this->Columns.Points ? "=" : "",
        " 0, got ", Quote(fields[static_cast<std::size_t>(field)]), "."));
  }
  if (radius >= 0 && diameter >= 0)
  {
    const double twice = this->Number(fields, diameter);
    if (!(std::abs(twice - 2.0 * value) <= 1e-3 * twice))
    {
      this->Lines.Fail(
        Text("radius and diameter are required to agree, got ", value, " and ", twice, "."));
    }
  }
  return value;
}

void SphereRows::Append(const Fields& fields)
{
  if (fields.size() < this->Columns.Count ||
    (fields.size() > this->Columns.Count && !this->Columns.More))
  {
    this->Lines.Fail(Text(this->Columns.Count, " fields are required, got ", fields.size(), "."));
  }
  const auto& field = this->Columns.Field;
  const double x = this->Number(fields, field[RowColumns::X]);
  const double y = this->Number(fields, field[RowColumns::Y]);
  const double z = this->Number(fields, field[RowColumns::Z]);
  if (field[RowColumns::Radius] >= 0 || field[RowColumns::Diameter] >= 0)
  {
    this->Frame.Radius.push_back(this->RadiusOf(fields));
  }
  this->Frame.X.push_back(x);
  this->Frame.Y.push_back(y);
  this->Frame.Z.push_back(z);
  if (this->HasModes)
  {
    this->AppendWhole(fields, field[RowColumns::Mode], this->Frame.Mode, this->HasModes);
  }
  if (this->HasIds)
  {
    this->AppendWhole(fields, field[RowColumns::Id], this->Frame.Id, this->HasIds);
  }
  if (field[RowColumns::Type] >= 0)
  {
    this->AppendType(fields[static_cast<std::size_t>(field[RowColumns::Type])]);
  }
}

template <class T>
void SphereRows::AppendWhole(const Fields& fields, int field, std::vector<T>& values, bool& has)
{
  const std::string_view text = fields[static_cast<std::size_t>(field)];
  std::int64_t value;
  if (ParseWhole(text, value) && value >= std::numeric_limits<T>::min() &&
    value <= std::numeric_limits<T>::max())
  {
    values.push_back(static_cast<T>(value));
    return;
  }
  has = false;
  values = {};
  this->Frame.Warnings.push_back(
    Text(this->Columns.Describe(field), " is left out: whole numbers are required, got ",
      Quote(text), " in line ", this->Lines.Line(), "."));
}

void SphereRows::AppendType(std::string_view field)
{
  std::vector<int>& types = this->Frame.Type;
  std::int64_t number;
  if (this->Names.empty() && ParseWhole(field, number) &&
    std::abs(static_cast<double>(number)) <= std::numeric_limits<int>::max())
  {
    types.push_back(static_cast<int>(number));
    return;
  }
  const auto place = [this](std::string_view name)
  {
    const auto known = this->Names.find(name);
    return known != this->Names.end()
      ? known->second
      : this->Names.emplace(name, static_cast<int>(this->Names.size())).first->second;
  };
  if (this->Names.empty()) // the first name makes names of the numbers before it
  {
    for (int& type : types)
    {
      type = place(std::to_string(type));
    }
  }
  types.push_back(place(field));
}

void SphereRows::Finish()
{
  if (this->Names.empty())
  {
    return;
  }
  std::vector<int> rank(this->Names.size());
  int next = 1;
  for (const auto& [name, place] : this->Names)
  {
    this->Frame.TypeNames.push_back(name);
    rank[static_cast<std::size_t>(place)] = next++;
  }
  for (int& type : this->Frame.Type)
  {
    type = rank[static_cast<std::size_t>(type)];
  }
  this->Names.clear();
}
}
