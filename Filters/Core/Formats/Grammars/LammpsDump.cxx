// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Dumps of LAMMPS and LIGGGHTS, by LAMMPS's pages dump, dump_modify, units and Howto_triclinic, and
// LIGGGHTS's dump_custom.cpp. A frame is a run of sections "ITEM: NAME" up to ATOMS, which names
// the columns of the rows that follow. UNITS stands in the first frame alone.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/LineSource.h"
#include "ruc/Formats/SphereRows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::pair<std::string_view, std::string_view> UnitsOfStyles[] = { { "si", "m" },
  { "cgs", "cm" }, { "micro", "µm" }, { "nano", "nm" }, { "real", "Å" }, { "metal", "Å" },
  { "electron", "Bohr" } };
}

std::string LengthUnitOfStyle(std::string_view style)
{
  for (const auto& [name, unit] : UnitsOfStyles)
  {
    if (style == name)
    {
      return std::string(unit);
    }
  }
  return {};
}

std::string StyleOfLengthUnit(std::string_view unit)
{
  std::string style;
  for (const auto& [name, itsUnit] : UnitsOfStyles)
  {
    if (unit == itsUnit)
    {
      style = style.empty() ? std::string(name) : ""; // not where there are two
    }
  }
  return style;
}

namespace
{
constexpr std::string_view Item = "ITEM:";

struct Header
{
  std::optional<double> Time;
  std::optional<std::int64_t> Step, Count;
  std::string LengthUnit;
  std::optional<FrameCell> Cell;
  std::array<bool, 3> Periodic{};
  bool PeriodicityKnown = false;
  std::vector<std::string> Columns;
};

bool BeginsWith(std::string_view text, std::string_view begin)
{
  return text.substr(0, begin.size()) == begin;
}

double ReadNumber(LineSource& lines, const char* what)
{
  const std::string_view text = TrimBlanks(lines.Require(what));
  double value;
  if (!ParseNumber(text, value))
  {
    lines.Fail(Text(what, " requires ", NumberFault(text)));
  }
  return value;
}

std::int64_t ReadWhole(LineSource& lines, const char* what)
{
  const std::string_view text = TrimBlanks(lines.Require(what));
  std::int64_t value;
  if (!ParseWhole(text, value))
  {
    lines.Fail(Text(what, " requires a whole number, got ", Quote(text), "."));
  }
  return value;
}

// The bounding box of a tilted cell is what is stated, not the cell
FrameCell UnboundedCell(const std::array<std::vector<double>, 3>& rows)
{
  const double xy = rows[0][2], xz = rows[1][2], yz = rows[2][2];
  const Vector3 low = { rows[0][0] - std::min({ 0.0, xy, xz, xy + xz }),
    rows[1][0] - std::min(0.0, yz), rows[2][0] };
  const Vector3 high = { rows[0][1] - std::max({ 0.0, xy, xz, xy + xz }),
    rows[1][1] - std::max(0.0, yz), rows[2][1] };
  FrameCell cell = FrameCell::FromBounds(low, high);
  cell.Edges[1][0] = xy;
  cell.Edges[2][0] = xz;
  cell.Edges[2][1] = yz;
  return cell;
}

// BOX BOUNDS [xy xz yz | abc origin] [pp ff …]; the last are absent in old files
void ReadBox(LineSource& lines, std::string_view kind, Header& header)
{
  Fields words;
  SplitBlanks(kind, words);
  const bool tilted = !words.empty() && words[0] == "xy";
  const bool general = !words.empty() && words[0] == "abc";
  const std::size_t flags = tilted ? 3 : general ? 2 : 0;
  header.PeriodicityKnown = words.size() == flags + 3;
  for (std::size_t q = 0; header.PeriodicityKnown && q < 3; ++q)
  {
    header.Periodic[q] = words[flags + q] == "pp";
  }
  std::array<std::vector<double>, 3> rows;
  const std::size_t count = general ? 4 : tilted ? 3 : 2;
  for (std::vector<double>& row : rows)
  {
    const std::string_view line = lines.Require("a bound of the box");
    if (!ParseNumbers(line, row) || row.size() != count)
    {
      lines.Fail(Text(count, " numbers of the box are required, got ", Quote(line), "."));
    }
  }
  if (general)
  {
    header.Cell = FrameCell{ { rows[0][3], rows[1][3], rows[2][3] },
      { Vector3{ rows[0][0], rows[0][1], rows[0][2] }, { rows[1][0], rows[1][1], rows[1][2] },
        { rows[2][0], rows[2][1], rows[2][2] } } };
    return;
  }
  header.Cell = tilted ? UnboundedCell(rows)
                       : FrameCell::FromBounds({ rows[0][0], rows[1][0], rows[2][0] },
                           { rows[0][1], rows[1][1], rows[2][1] });
  for (int q = 0; q < 3; ++q)
  {
    if (!(header.Cell->Edges[q][q] > 0.0))
    {
      lines.Fail(Text("a box with edges > 0 is required, got ", header.Cell->Edges[q][q], "."));
    }
  }
}

void SkipSection(LineSource& lines)
{
  std::string_view line;
  while (lines.Peek(line) && !BeginsWith(line, Item))
  {
    lines.Next(line);
  }
}

// Up to the rows; false at the end of the file
bool ReadHeader(LineSource& lines, Header& header)
{
  std::string_view line;
  bool begun = false;
  while (lines.Next(line))
  {
    if (!begun && TrimBlanks(line).empty())
    {
      continue;
    }
    begun = true;
    if (!BeginsWith(line, Item))
    {
      lines.Fail(Text("a section 'ITEM: …' is required, got ", Quote(line), "."));
    }
    const std::string section(TrimBlanks(line.substr(Item.size())));
    if (section == "UNITS")
    {
      header.LengthUnit = LengthUnitOfStyle(TrimBlanks(lines.Require("a unit style")));
    }
    else if (section == "TIME")
    {
      header.Time = ReadNumber(lines, "TIME");
    }
    else if (section == "TIMESTEP")
    {
      header.Step = ReadWhole(lines, "TIMESTEP");
    }
    else if (section == "NUMBER OF ATOMS")
    {
      header.Count = ReadWhole(lines, "NUMBER OF ATOMS");
    }
    else if (BeginsWith(section, "BOX BOUNDS"))
    {
      ReadBox(lines, std::string_view(section).substr(10), header);
    }
    else if (BeginsWith(section, "ATOMS"))
    {
      Fields names;
      SplitBlanks(std::string_view(section).substr(5), names);
      header.Columns.assign(names.begin(), names.end());
      return true;
    }
    else // LABEL and what else there may be
    {
      SkipSection(lines);
    }
  }
  return false;
}

std::optional<double> TimeOf(const Header& header)
{
  return header.Time ? header.Time
    : header.Step    ? std::optional<double>(static_cast<double>(*header.Step))
                     : std::nullopt;
}

std::vector<FramePlace> Scan(ByteStream& bytes)
{
  std::vector<FramePlace> places;
  LineSource lines(bytes);
  std::string unit;
  for (bool more = true; more;)
  {
    FramePlace place{ lines.Offset(), lines.Line(), {}, unit };
    try
    {
      Header header;
      more = ReadHeader(lines, header);
      const std::int64_t count = header.Count.value_or(0);
      place.Time = TimeOf(header);
      unit = header.LengthUnit.empty() ? unit : header.LengthUnit;
      if (more || places.empty())
      {
        places.push_back(place);
      }
      more = more && count >= 0 &&
        lines.Skip(static_cast<std::size_t>(count)) == static_cast<std::size_t>(count);
    }
    catch (const std::invalid_argument&)
    {
      places.push_back(place);
      break;
    }
  }
  return places;
}

// The kinds of positions, in the order in which they are preferred
struct Kind
{
  const char *X, *Y, *Z;
  bool Scaled;
};
constexpr Kind Kinds[] = { { "x", "y", "z", false }, { "xu", "yu", "zu", false },
  { "xs", "ys", "zs", true }, { "xsu", "ysu", "zsu", true } };

// The first kind that all three positions have. Its columns get the names that SphereRows knows.
const Kind& FindKind(const LineSource& lines, std::vector<std::string>& columns)
{
  const auto find = [&](const char* name)
  { return std::find(columns.begin(), columns.end(), name); };
  for (const Kind& kind : Kinds)
  {
    const auto x = find(kind.X), y = find(kind.Y), z = find(kind.Z);
    if (x != columns.end() && y != columns.end() && z != columns.end())
    {
      *x = "x";
      *y = "y";
      *z = "z";
      return kind;
    }
  }
  std::string names;
  for (const std::string& name : columns)
  {
    names += (names.empty() ? "" : " ") + name;
  }
  lines.Fail(Text("three positions of one kind are required, such as x y z or xs ys zs, got the "
                  "columns '",
    names, "'."));
}

PackFrame Read(ByteStream& bytes, const FramePlace& place, const ReadSettings&)
{
  LineSource lines(bytes, place.Offset, place.LinesBefore);
  Header header;
  if (!ReadHeader(lines, header))
  {
    throw std::invalid_argument("A section 'ITEM: ATOMS' is required, got the end of the file.");
  }
  if (!header.Count)
  {
    lines.Fail("a section 'ITEM: NUMBER OF ATOMS' is required before the atoms, got none.");
  }
  PackFrame frame;
  const Kind& kind = FindKind(lines, header.Columns);
  if (kind.Scaled && !header.Cell)
  {
    lines.Fail("a section 'ITEM: BOX BOUNDS' is required by scaled positions, got none.");
  }
  SphereRows(lines, RowColumns::Named(header.Columns), frame).Read(*header.Count);
  if (kind.Scaled)
  {
    PlaceFractions(frame, *header.Cell);
  }
  if (header.Cell)
  {
    SetBox(frame, *header.Cell, header.Periodic, header.PeriodicityKnown);
  }
  frame.LengthUnit = header.LengthUnit.empty() ? place.LengthUnit : header.LengthUnit;
  frame.Time = header.Time;
  frame.Step = header.Step;
  return frame;
}

// Without UNITS, which older programs do not know. A time that is no step has a section of its own.
WrittenPack Write(const FramePack& pack, const WriteSettings& settings)
{
  const Window box = BoxOrBounds(pack);
  const LammpsNumbers numbers(pack);
  const double time = pack.Time.value_or(0.0);
  const bool step = time == std::floor(time) && std::abs(time) < 1e15;
  WrittenPack written;
  std::string& text = written.Bytes;
  if (!step)
  {
    text += "ITEM: TIME\n";
    AppendNumber(text, time);
    text += "\n";
  }
  text += Text("ITEM: TIMESTEP\n", step ? static_cast<std::int64_t>(time) : settings.Frame,
    "\nITEM: NUMBER OF ATOMS\n", pack.Pack.Size(), "\nITEM: BOX BOUNDS");
  for (bool periodic : box.Periodic)
  {
    text += periodic ? " pp" : " ff";
  }
  for (int q = 0; q < 3; ++q)
  {
    text += "\n";
    AppendNumbers(text, { box.Origin[q], box.Origin[q] + box.Size[q] });
  }
  text += "\nITEM: ATOMS id type diameter x y z\n";
  const SpherePack& spheres = pack.Pack;
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    text += numbers.Of(pack, i);
    AppendNumbers(text, { 2.0 * spheres.Radius[i], spheres.X[i], spheres.Y[i], spheres.Z[i] });
    text += "\n";
  }
  return written;
}

bool Recognise(std::string_view begin)
{
  return BeginsWith(begin.substr(std::min(begin.find_first_not_of(" \t\r\n"), begin.size())), Item);
}
}

const PackFormat LammpsDump = { "LAMMPS dump", Recognise, Scan, Read,
  { Write, "dump lammpstrj", true } };
}
