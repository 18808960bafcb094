// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables, one sphere a line, as spreadsheets, numpy, pandas, R and Fortran write them. Columns are
// separated by semicolons, tabs, commas or blanks; fields may be in double quotes. Their names
// stand in the first row with text, else in the last comment (#, %, //) that has as many fields as
// the rows. Comments, blank rows and rows of separators are passed over. TableColumns.h tells the
// names.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/SphereRows.h"
#include "ruc/Formats/TableColumns.h"
#include "ruc/Formats/TableRows.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace ruc
{
namespace
{
[[noreturn]] void FailEmpty()
{
  throw std::invalid_argument("At least one line with a sphere is required, got none.");
}

class TableReader
{
public:
  TableReader(ByteStream& bytes, const ReadSettings& settings)
    : Rows(bytes, settings.SkipLines)
    , Settings(settings)
  {
  }
  PackFrame Read();

private:
  TableColumns FindColumns(Fields& fields);
  TableColumns FindHeader(Fields& fields);
  std::vector<std::string> NamesOfComment(std::size_t count) const;
  void CheckFirstColumn() const;

  TableRows Rows;
  const ReadSettings& Settings;
  PackFrame Frame;
};

// Names in the last comment that has as many as the rows have fields, and knows x, y and z
std::vector<std::string> TableReader::NamesOfComment(std::size_t count) const
{
  const std::vector<std::string>& comments = this->Rows.GetComments();
  for (auto comment = comments.rbegin(); comment != comments.rend(); ++comment)
  {
    for (char separator : { this->Rows.GetSeparator(), TableRows::Whitespace, ',', ';', '\t' })
    {
      Fields fields;
      TableRows::Split(*comment, separator, fields);
      const std::vector<std::string> names(fields.begin(), fields.end());
      if (names.size() == count && NameCentres(names))
      {
        return names;
      }
    }
  }
  return {};
}

// Takes the row that `fields` holds as names; then it holds the first row of numbers
TableColumns TableReader::FindHeader(Fields& fields)
{
  std::vector<std::string> names(fields.begin(), fields.end());
  while (names.size() > 1 && names.back().empty())
  {
    names.pop_back();
  }
  this->Rows.SetCount(names.size());
  bool any = this->Rows.Next(fields);
  std::vector<std::string> units;
  if (any && fields.size() == names.size() &&
    std::all_of(fields.begin(), fields.end(),
      [](std::string_view field) { return field.empty() || IsLengthUnit(field) || field == "-"; }))
  {
    units.assign(fields.begin(), fields.end());
    std::replace(units.begin(), units.end(), std::string("-"), std::string());
    any = this->Rows.Next(fields);
  }
  if (any && fields.size() == names.size() + 1) // R, whose names of rows have no name
  {
    names.insert(names.begin(), "");
    this->Rows.SetCount(names.size());
    units.clear();
  }
  if (!any)
  {
    fields.clear();
  }
  return FindNamedColumns(names, units, this->Settings);
}

// From the first row
TableColumns TableReader::FindColumns(Fields& fields)
{
  for (std::string_view field : fields)
  {
    const std::string fault = NumberFault(field);
    if (!IsNumber(field) && fault.rfind("a decimal point", 0) == 0)
    {
      throw std::invalid_argument(Text("a number requires ", fault));
    }
  }
  const auto numbers = std::count_if(fields.begin(), fields.end(), IsNumber);
  const bool text = static_cast<std::size_t>(numbers) < fields.size();
  if (text && numbers < 3)
  {
    return this->FindHeader(fields);
  }
  while (fields.size() > 1 && fields.back().empty()) // separators at the end of the line
  {
    fields.pop_back();
  }
  this->Rows.SetCount(fields.size());
  const std::vector<std::string> names = this->NamesOfComment(fields.size());
  return names.empty() ? FindNamelessColumns(fields.size(), this->Settings)
                       : FindNamedColumns(names, {}, this->Settings);
}

bool AreWhole(const std::vector<double>& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double number) { return number == std::floor(number); });
}

// Numbers of rows would be taken for coordinates x where no column has a name. They count from 0 or
// 1; with gaps they still rise, beside coordinates that are not all whole
void TableReader::CheckFirstColumn() const
{
  std::vector<double> x = this->Frame.X;
  const bool rise = std::adjacent_find(x.begin(), x.end(), std::greater_equal<>()) == x.end();
  std::sort(x.begin(), x.end());
  bool counts = x[0] == 0.0 || x[0] == 1.0;
  for (std::size_t n = 0; n < x.size() && counts; ++n)
  {
    counts = x[n] == x[0] + static_cast<double>(n);
  }
  const bool number = rise && x[0] >= 0.0 && AreWhole(x) && !AreWhole(this->Frame.Y);
  if (x.size() >= 3 && (counts || number))
  {
    throw std::invalid_argument(
      "The first column counts the rows: set Columns, such as id,x,y,z or x,y,z,r.");
  }
}

PackFrame TableReader::Read()
{
  Fields fields;
  if (!this->Rows.Next(fields))
  {
    FailEmpty();
  }
  const std::size_t line = this->Rows.GetLines().Line();
  TableColumns table;
  try
  {
    table = this->FindColumns(fields);
  }
  catch (const std::invalid_argument& fault)
  {
    const std::string what = fault.what();
    if (what.rfind("Line ", 0) == 0)
    {
      throw;
    }
    throw std::invalid_argument(Text("Line ", line, ": ", what));
  }
  this->Frame.LengthUnit = table.LengthUnit;
  this->Frame.Warnings = table.Warnings;
  SphereRows rows(this->Rows.GetLines(), table.Columns, this->Frame);
  for (bool more = !fields.empty(); more; more = this->Rows.Next(fields))
  {
    rows.Append(fields);
  }
  rows.Finish();
  if (this->Frame.Size() == 0)
  {
    FailEmpty();
  }
  if (table.Nameless)
  {
    this->CheckFirstColumn();
  }
  return std::move(this->Frame);
}

PackFrame Read(ByteStream& bytes, const FramePlace&, const ReadSettings& settings)
{
  return TableReader(bytes, settings).Read();
}

// Modes, if there are any, have a column of their own, as only tables of this project have them
WrittenPack Write(const FramePack& pack, const WriteSettings&)
{
  const SpherePack& spheres = pack.Pack;
  const bool modes = !spheres.Mode.empty();
  WrittenPack written;
  std::string& text = written.Bytes;
  text = Text("id,type,x,y,z,radius", modes ? ",mode" : "", "\n");
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    text += std::to_string(spheres.Id[i]) + "," + std::to_string(TypeOf(pack, i));
    for (double value : { spheres.X[i], spheres.Y[i], spheres.Z[i], spheres.Radius[i] })
    {
      text += ",";
      AppendNumber(text, value);
    }
    text += (modes ? "," + std::to_string(spheres.Mode[i]) : std::string()) + "\n";
  }
  return written;
}

// A line with three numbers, with decimal commas or not
bool Recognise(std::string_view begin)
{
  if (begin.substr(0, 2) == "\xFF\xFE" || begin.substr(0, 2) == "\xFE\xFF") // UTF-16, to be told so
  {
    return true;
  }
  if (begin.find('\0') != begin.npos)
  {
    return false;
  }
  for (std::string_view line : FirstLines(begin, 4096))
  {
    std::string text(line);
    std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == ';' || c == '"'; }, ' ');
    Fields fields;
    SplitBlanks(text, fields);
    if (std::count_if(fields.begin(), fields.end(), IsNumber) >= 3)
    {
      return true;
    }
  }
  return false;
}
}

const PackFormat Table = { "table", Recognise, ScanOneFrame, Read, { Write, "csv spheres" } };
}
