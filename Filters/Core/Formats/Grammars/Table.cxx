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
#include "ruc/Formats/LineSource.h"
#include "ruc/Formats/SphereRows.h"
#include "ruc/Formats/TableColumns.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr char Whitespace = ' '; // as a separator: any run of blanks and tabs

// What stands behind the mark of a comment
bool IsComment(std::string_view line, std::string_view& comment)
{
  for (std::string_view mark : { "#", "%", "//" })
  {
    if (line.substr(0, mark.size()) == mark)
    {
      comment = TrimBlanks(line.substr(
        line.find_first_not_of("#%/") == line.npos ? line.size() : line.find_first_not_of("#%/")));
      return true;
    }
  }
  return false;
}

bool IsNumber(std::string_view field)
{
  double ignored;
  return ParseNumber(field, ignored);
}

// At a separator outside quotes; a field loses the quotes around it
void Split(std::string_view line, char separator, Fields& fields)
{
  if (separator == Whitespace && line.find('"') == line.npos)
  {
    SplitBlanks(line, fields);
    return;
  }
  fields.clear();
  const auto separates = [separator](char c)
  { return separator == Whitespace ? c == ' ' || c == '\t' : c == separator; };
  bool quoted = false;
  for (std::size_t begin = 0, at = 0; at <= line.size(); ++at)
  {
    quoted = quoted != (at < line.size() && line[at] == '"');
    if (at < line.size() && (quoted || !separates(line[at])))
    {
      continue;
    }
    std::string_view field = TrimBlanks(line.substr(begin, at - begin));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    {
      field = TrimBlanks(field.substr(1, field.size() - 2));
    }
    if (separator != Whitespace || at > begin)
    {
      fields.push_back(field);
    }
    begin = at + 1;
  }
}

char FindSeparator(std::string_view line)
{
  Fields fields;
  for (char separator : { ';', '\t', ',' })
  {
    Split(line, separator, fields);
    const bool mixed = separator == '\t' &&
      std::any_of(fields.begin(), fields.end(),
        [](std::string_view field)
        {
          const std::size_t blank = field.find(' ');
          return blank != field.npos && IsNumber(field.substr(0, blank));
        });
    if (fields.size() > 1 && !mixed)
    {
      return separator;
    }
  }
  return Whitespace;
}

[[noreturn]] void FailEmpty()
{
  throw std::invalid_argument("At least one line with a sphere is required, got none.");
}

class TableReader
{
public:
  TableReader(ByteStream& bytes, const ReadSettings& settings)
    : Lines(bytes)
    , Settings(settings)
  {
  }
  PackFrame Read();

private:
  bool NextRow(Fields& fields);
  TableColumns FindColumns(Fields& fields);
  TableColumns FindHeader(Fields& fields);
  std::vector<std::string> NamesOfComment(std::size_t count) const;
  void CheckFirstColumn() const;

  LineSource Lines;
  const ReadSettings& Settings;
  PackFrame Frame;
  char Separator = 0;
  std::size_t Count = 0; // of columns, once it is known
  std::vector<std::string> Comments;
};

// The next line that has fields; false at the end
bool TableReader::NextRow(Fields& fields)
{
  std::string_view line, comment;
  while (this->Lines.Next(line))
  {
    if (this->Lines.Line() <= static_cast<std::size_t>(std::max(this->Settings.SkipLines, 0)))
    {
      continue;
    }
    if (this->Lines.Line() == 1 && line.substr(0, 3) == "\xEF\xBB\xBF")
    {
      line.remove_prefix(3);
    }
    const std::size_t bad = FindBadByte(line);
    if (bad != line.npos)
    {
      const bool wide = line.substr(0, 2) == "\xFF\xFE" || line.substr(0, 2) == "\xFE\xFF";
      this->Lines.Fail(wide
          ? Text("UTF-8 text is required, got UTF-16: save the table as UTF-8.")
          : Text("UTF-8 text is required, got the byte ",
              static_cast<unsigned int>(static_cast<unsigned char>(line[bad])), " at place ",
              bad + 1, ", as in Latin-1: save the table as UTF-8."));
    }
    if (IsComment(TrimBlanks(line), comment))
    {
      if (this->Separator == 0 && this->Comments.size() < 1000)
      {
        this->Comments.emplace_back(comment);
      }
      continue;
    }
    if (this->Separator == 0 && Lower(line).rfind("sep=", 0) == 0 && line.size() == 5)
    {
      this->Separator = line[4];
      continue;
    }
    if (this->Separator == 0 && !TrimBlanks(line).empty())
    {
      this->Separator = FindSeparator(line);
    }
    line = line.substr(0, line.find(" #")); // a comment behind the numbers
    Split(this->Separator == '\t' ? line : TrimBlanks(line), this->Separator, fields);
    if (fields.size() == this->Count + 1 && this->Count > 0 && fields.back().empty())
    {
      fields.pop_back(); // a separator at the end of the line
    }
    if (std::any_of(
          fields.begin(), fields.end(), [](std::string_view field) { return !field.empty(); }))
    {
      return true;
    }
  }
  return false;
}

// Names in the last comment that has as many as the rows have fields, and knows x, y and z
std::vector<std::string> TableReader::NamesOfComment(std::size_t count) const
{
  for (auto comment = this->Comments.rbegin(); comment != this->Comments.rend(); ++comment)
  {
    for (char separator : { this->Separator, Whitespace, ',', ';', '\t' })
    {
      Fields fields;
      Split(*comment, separator, fields);
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
  this->Count = names.size();
  bool any = this->NextRow(fields);
  std::vector<std::string> units;
  if (any && fields.size() == names.size() &&
    std::all_of(fields.begin(), fields.end(),
      [](std::string_view field) { return field.empty() || IsLengthUnit(field) || field == "-"; }))
  {
    units.assign(fields.begin(), fields.end());
    std::replace(units.begin(), units.end(), std::string("-"), std::string());
    any = this->NextRow(fields);
  }
  if (any && fields.size() == names.size() + 1) // R, whose names of rows have no name
  {
    names.insert(names.begin(), "");
    this->Count = names.size();
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
  this->Count = fields.size();
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
  if (!this->NextRow(fields))
  {
    FailEmpty();
  }
  const std::size_t line = this->Lines.Line();
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
  SphereRows rows(this->Lines, table.Columns, this->Frame);
  for (bool more = !fields.empty(); more; more = this->NextRow(fields))
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
