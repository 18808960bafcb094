// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Extended XYZ, by the README of libAtoms/extxyz. A frame is a line with the number of its rows, a
// line of key=value, and the rows. Lattice holds the three edges of the cell one after the other;
// pbc is T along all of them unless it is told, and without Lattice there is no box. Positions are
// never guessed to be fractions. Without Properties the columns are species x y z.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/LineSource.h"
#include "ruc/Formats/SphereRows.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace ruc
{
namespace
{
using Pairs = std::map<std::string, std::string, std::less<>>;

// The value that begins at `at`, which moves behind it: in quotes, in brackets, or a word
std::string TakeValue(std::string_view line, std::size_t& at)
{
  const char open = at < line.size() ? line[at] : ' ';
  if (open == '"' || open == '\'')
  {
    const std::size_t end = std::min(line.find(open, at + 1), line.size());
    const std::string value(line.substr(at + 1, end - at - 1));
    at = std::min(end + 1, line.size());
    return value;
  }
  const std::size_t begin = at;
  for (int depth = 0; at < line.size() && (depth > 0 || (line[at] != ' ' && line[at] != '\t'));
       ++at)
  {
    depth += (line[at] == '[' || line[at] == '{') - (line[at] == ']' || line[at] == '}');
  }
  return std::string(line.substr(begin, at - begin));
}

// Keys in lower case; one without a value is T
Pairs ParsePairs(std::string_view line)
{
  Pairs pairs;
  for (std::size_t at = 0;;)
  {
    at = line.find_first_not_of(" \t", at);
    if (at == std::string_view::npos)
    {
      return pairs;
    }
    const std::size_t end = std::min(line.find_first_of("= \t", at), line.size());
    const std::string key = Lower(line.substr(at, end - at));
    const std::size_t sign = std::min(line.find_first_not_of(" \t", end), line.size());
    if (sign < line.size() && line[sign] == '=')
    {
      at = std::min(line.find_first_not_of(" \t", sign + 1), line.size());
      pairs[key] = TakeValue(line, at);
    }
    else
    {
      at = end;
      pairs[key] = "T";
    }
  }
}

// The words of an array, whatever its brackets and commas
std::vector<std::string> WordsOf(std::string value)
{
  std::replace_if(
    value.begin(), value.end(),
    [](char c) { return std::string_view("[]{},").find(c) != std::string_view::npos; }, ' ');
  Fields words;
  SplitBlanks(value, words);
  return { words.begin(), words.end() };
}

std::vector<double> NumbersOf(
  const LineSource& lines, const Pairs& pairs, const char* key, const char* what)
{
  const auto found = pairs.find(Lower(key));
  std::vector<double> numbers;
  if (found != pairs.end())
  {
    for (const std::string& word : WordsOf(found->second))
    {
      numbers.push_back(0.0);
      if (!ParseNumber(word, numbers.back()))
      {
        lines.Fail(Text(key, " requires ", what, ", got ", Quote(found->second), "."));
      }
    }
  }
  return numbers;
}

std::array<bool, 3> PeriodicOf(const LineSource& lines, const Pairs& pairs)
{
  const auto found = pairs.find("pbc");
  if (found == pairs.end())
  {
    return { true, true, true };
  }
  const std::vector<std::string> words = WordsOf(Lower(found->second));
  std::array<bool, 3> periodic{};
  for (std::size_t q = 0; q < 3; ++q)
  {
    const std::string word = words.size() == 3 ? words[q] : "";
    periodic[q] = word == "t" || word == "true" || word == "1";
    if (!periodic[q] && word != "f" && word != "false" && word != "0")
    {
      lines.Fail(Text("pbc requires three of T and F, got ", Quote(found->second), "."));
    }
  }
  return periodic;
}

// Names of the columns as SphereRows knows them, from "species:S:1:pos:R:3:radius:R:1"
std::vector<std::string> ColumnsOf(const LineSource& lines, const Pairs& pairs)
{
  const auto found = pairs.find("properties");
  std::string text = found == pairs.end() ? "species:S:1:pos:R:3" : found->second;
  const std::string given = text;
  std::replace(text.begin(), text.end(), ':', ' ');
  Fields parts;
  SplitBlanks(text, parts);
  std::vector<std::string> names;
  bool typed = false;
  for (std::size_t n = 0; n < parts.size(); n += 3)
  {
    const std::string name = Lower(parts[n]);
    std::int64_t count = 0;
    if (n + 2 >= parts.size() || !ParseWhole(parts[n + 2], count) || count < 1 || count > 1000)
    {
      lines.Fail(Text("Properties requires name:type:count, got ", Quote(given), "."));
    }
    const bool position = name == "pos" || name == "position" || name == "positions";
    if (position && count != 3)
    {
      lines.Fail(Text("positions of 3 columns are required, got ", count, "."));
    }
    typed = typed || name == "type";
    for (std::int64_t c = 0; c < count; ++c)
    {
      names.push_back(position ? std::string(1, "xyz"[c])
          : name == "radii"    ? "radius"
          : count > 1          ? name + "_" // no role
                               : name);
    }
  }
  std::replace(
    names.begin(), names.end(), std::string(typed ? "" : "species"), std::string("type"));
  for (const char* axis : { "x", "y", "z" })
  {
    if (std::find(names.begin(), names.end(), axis) == names.end())
    {
      lines.Fail(Text("Properties requires pos:R:3, got ", Quote(given), "."));
    }
  }
  return names;
}

void SetLattice(const LineSource& lines, const Pairs& pairs, PackFrame& frame)
{
  const std::vector<double> lattice = NumbersOf(lines, pairs, "Lattice", "9 numbers");
  if (lattice.empty())
  {
    return;
  }
  const std::vector<double> origin = NumbersOf(lines, pairs, "Origin", "3 numbers");
  if (lattice.size() != 9 || (!origin.empty() && origin.size() != 3))
  {
    throw std::invalid_argument(Text("Lattice requires 9 numbers and Origin 3, got ",
      lattice.size(), " and ", origin.size(), "."));
  }
  FrameCell cell;
  for (std::size_t q = 0; q < 3; ++q)
  {
    cell.Origin[q] = origin.empty() ? 0.0 : origin[q];
    for (std::size_t p = 0; p < 3; ++p)
    {
      cell.Edges[q][p] = lattice[3 * q + p];
    }
  }
  SetBox(frame, cell, PeriodicOf(lines, pairs), true);
}

std::int64_t ReadCount(LineSource& lines)
{
  const std::string_view line = TrimBlanks(lines.Require("a number of rows"));
  std::int64_t count;
  if (!ParseWhole(line, count))
  {
    lines.Fail(Text("a number of rows is required, got ", Quote(line), "."));
  }
  return count;
}

std::vector<FramePlace> Scan(ByteStream& bytes)
{
  std::vector<FramePlace> places;
  LineSource lines(bytes);
  std::string_view line;
  while (lines.Peek(line) || places.empty())
  {
    FramePlace place{ lines.Offset(), lines.Line(), {}, {} };
    if (!places.empty() && TrimBlanks(line).empty())
    {
      lines.Next(line);
      continue;
    }
    try
    {
      const auto count = static_cast<std::size_t>(std::max<std::int64_t>(ReadCount(lines), 0));
      const std::vector<double> time =
        NumbersOf(lines, ParsePairs(lines.Require("a line of key=value")), "time", "a number");
      place.Time = time.size() == 1 ? std::optional<double>(time[0]) : std::nullopt;
      places.push_back(place);
      if (lines.Skip(count) < count)
      {
        break;
      }
    }
    catch (const std::invalid_argument&)
    {
      places.push_back(place);
      break;
    }
  }
  return places;
}

PackFrame Read(ByteStream& bytes, const FramePlace& place, const ReadSettings&)
{
  LineSource lines(bytes, place.Offset, place.LinesBefore);
  const std::int64_t count = ReadCount(lines);
  const Pairs pairs = ParsePairs(lines.Require("a line of key=value"));
  PackFrame frame;
  const RowColumns columns = RowColumns::Named(ColumnsOf(lines, pairs));
  const std::vector<double> time = NumbersOf(lines, pairs, "time", "a number");
  frame.Time = time.size() == 1 ? std::optional<double>(time[0]) : std::nullopt;
  SphereRows(lines, columns, frame).Read(count);
  SetLattice(lines, pairs, frame);
  return frame;
}

// The first four columns are those of a plain XYZ file
WrittenPack Write(const FramePack& pack, const WriteSettings&)
{
  const SpherePack& spheres = pack.Pack;
  WrittenPack written;
  std::string& text = written.Bytes;
  text = std::to_string(spheres.Size()) + "\n";
  if (pack.Box)
  {
    const Window box = pack.Box->GetBounds();
    text += "Lattice=\"";
    AppendNumbers(text, { box.Size[0], 0, 0, 0, box.Size[1], 0, 0, 0, box.Size[2] });
    text += "\" Origin=\"";
    AppendNumbers(text, { box.Origin[0], box.Origin[1], box.Origin[2] });
    text += "\" pbc=\"";
    for (int q = 0; q < 3; ++q)
    {
      text += Text(q > 0 ? " " : "", box.Periodic[q] ? "T" : "F");
    }
    text += "\" ";
  }
  if (pack.Time)
  {
    text += "Time=";
    AppendNumber(text, *pack.Time);
    text += " ";
  }
  text += "Properties=type:I:1:pos:R:3:radius:R:1:id:I:1\n";
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    text += std::to_string(TypeOf(pack, i)) + " ";
    AppendNumbers(text, { spheres.X[i], spheres.Y[i], spheres.Z[i], spheres.Radius[i] });
    text += " " + std::to_string(spheres.Id[i]) + "\n";
  }
  return written;
}

// A number, then a line that has one of the keys, or rows that begin with a name
bool Recognise(std::string_view begin)
{
  const auto lines = FirstLines(begin, 3);
  std::int64_t count;
  if (lines.size() < 3 || !ParseWhole(TrimBlanks(lines[0]), count))
  {
    return false;
  }
  const std::string keys = Lower(lines[1]);
  Fields row;
  SplitBlanks(lines[2], row);
  double number;
  return keys.find("properties=") != std::string::npos ||
    keys.find("lattice=") != std::string::npos ||
    (row.size() == 4 && !ParseNumber(row[0], number) && ParseNumber(row[1], number) &&
      ParseNumber(row[2], number) && ParseNumber(row[3], number));
}
}

const PackFormat ExtendedXyz = { "extended XYZ", Recognise, Scan, Read, { Write, "extxyz", true } };
}
