// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Data files of LAMMPS and LIGGGHTS, by LAMMPS's page read_data: a title, lines of a header, then
// sections, of which Atoms alone holds spheres. The files do not tell which axes are periodic. YADE
// (py/export.py) writes radii where the others have diameters; its title is LIGGGHTS Description,
// and its box holds the spheres closely.
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
struct Header
{
  std::string Title, Style;
  std::optional<std::int64_t> Count;
  std::array<std::vector<double>, 3> Bounds; // lo hi
  std::vector<double> Tilts;
  std::array<std::vector<double>, 3> Vectors; // of a general box
  std::vector<double> Origin;
};

// What stands in front of the keywords of a line, as numbers
bool ReadKeywords(
  const Fields& words, std::size_t numbers, std::string_view keywords, std::vector<double>& values)
{
  Fields wanted;
  SplitBlanks(keywords, wanted);
  if (words.size() != numbers + wanted.size() ||
    !std::equal(wanted.begin(), wanted.end(), words.begin() + static_cast<long>(numbers)))
  {
    return false;
  }
  values.assign(numbers, 0.0);
  for (std::size_t n = 0; n < numbers; ++n)
  {
    if (!ParseNumber(words[n], values[n]) || !std::isfinite(values[n]))
    {
      values.clear();
    }
  }
  return !values.empty();
}

void ReadHeaderLine(const LineSource& lines, const Fields& words, Header& header)
{
  static const char* const bounds[3] = { "xlo xhi", "ylo yhi", "zlo zhi" };
  static const char* const vectors[3] = { "avec", "bvec", "cvec" };
  if (words.size() == 2 && words[1] == "atoms")
  {
    std::int64_t count;
    if (!ParseWhole(words[0], count))
    {
      lines.Fail(Text("a whole number of atoms is required, got ", Quote(words[0]), "."));
    }
    header.Count = count;
    return;
  }
  for (std::size_t q = 0; q < 3; ++q)
  {
    if (ReadKeywords(words, 2, bounds[q], header.Bounds[q]))
    {
      if (!(header.Bounds[q][0] < header.Bounds[q][1]))
      {
        lines.Fail(Text("a box with edges > 0 is required, got ", header.Bounds[q][0], " to ",
          header.Bounds[q][1], "."));
      }
      return;
    }
    if (ReadKeywords(words, 3, vectors[q], header.Vectors[q]))
    {
      return;
    }
  }
  ReadKeywords(words, 3, "xy xz yz", header.Tilts) ||
    ReadKeywords(words, 3, "abc origin", header.Origin);
}

Header ReadHeader(LineSource& lines)
{
  Header header;
  header.Title = lines.Require("a title");
  std::string_view line;
  Fields words;
  while (lines.Next(line))
  {
    const std::size_t comment = std::min(line.find('#'), line.size());
    SplitBlanks(line.substr(0, comment), words);
    if (!words.empty() && words[0] == "Atoms")
    {
      header.Style = TrimBlanks(line.substr(std::min(comment + 1, line.size())));
      return header;
    }
    ReadHeaderLine(lines, words, header);
  }
  throw std::invalid_argument("A section Atoms is required, got the end of the file.");
}

const std::vector<std::string>& ColumnsOf(LineSource& lines, const std::string& style)
{
  static const std::vector<std::string> sphere = { "id", "type", "diameter", "density", "x", "y",
    "z" };
  static const std::vector<std::string> atomic = { "id", "type", "x", "y", "z" };
  std::string_view line;
  while (lines.Peek(line) && TrimBlanks(line).empty())
  {
    lines.Next(line);
  }
  Fields row;
  SplitBlanks(line, row);
  const std::size_t count = row.size();
  if (style == "sphere" || (style.empty() && (count == 7 || count == 10)))
  {
    return sphere;
  }
  if (style == "atomic" || (style.empty() && (count == 5 || count == 8)))
  {
    return atomic;
  }
  if (!style.empty())
  {
    lines.Fail(Text("atoms of the style sphere or atomic are required, got ", Quote(style), "."));
  }
  lines.Next(line);
  lines.Fail(
    Text("the columns id type diameter density x y z are required, got ", count, " columns."));
}

// Whether spheres of these radii touch the box from inside, as in a file of YADE, along x and y;
// along z YADE takes a wrong bound
bool FitsClosely(const PackFrame& frame, const Header& header)
{
  const std::vector<double>* const centres[2] = { &frame.X, &frame.Y };
  for (std::size_t q = 0; q < 2; ++q)
  {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < frame.Size(); ++i)
    {
      low = std::min(low, (*centres[q])[i] - frame.Radius[i]);
      high = std::max(high, (*centres[q])[i] + frame.Radius[i]);
    }
    const std::vector<double>& bounds = header.Bounds[q];
    const double tolerance =
      2e-5 * std::max({ high - low, std::abs(low), std::abs(high) }); // six digits
    if (bounds.empty() || !(std::abs(bounds[0] - low) <= tolerance) ||
      !(std::abs(bounds[1] - high) <= tolerance))
    {
      return false;
    }
  }
  return true;
}

void TakeRadiiOfYade(PackFrame& frame, const Header& header)
{
  if (header.Title.rfind("LIGGGHTS Description", 0) != 0 || frame.Radius.empty())
  {
    return;
  }
  for (double& radius : frame.Radius)
  {
    radius *= 2.0; // what was halved is a radius
  }
  if (FitsClosely(frame, header))
  {
    frame.Warnings.push_back("Column 3 holds radii, as YADE writes them: they fit the box.");
    return;
  }
  for (double& radius : frame.Radius)
  {
    radius *= 0.5;
  }
}

void SetBoxOf(const Header& header, PackFrame& frame)
{
  const auto& [a, b, c] = header.Vectors;
  if (!a.empty() && !b.empty() && !c.empty())
  {
    FrameCell cell;
    for (std::size_t q = 0; q < 3; ++q)
    {
      cell.Origin[q] = header.Origin.empty() ? 0.0 : header.Origin[q];
      cell.Edges[0][q] = a[q];
      cell.Edges[1][q] = b[q];
      cell.Edges[2][q] = c[q];
    }
    SetBox(frame, cell, {}, false);
    return;
  }
  const auto& [x, y, z] = header.Bounds;
  if (!x.empty() && !y.empty() && !z.empty())
  {
    FrameCell cell = FrameCell::FromBounds({ x[0], y[0], z[0] }, { x[1], y[1], z[1] });
    if (!header.Tilts.empty())
    {
      cell.Edges[1][0] = header.Tilts[0];
      cell.Edges[2][0] = header.Tilts[1];
      cell.Edges[2][1] = header.Tilts[2];
    }
    SetBox(frame, cell, {}, false);
  }
}

// "…, timestep = 0, units = si" of write_data
std::string FromTitle(const std::string& title, std::string_view key)
{
  const std::size_t at = title.find(key);
  if (at == std::string::npos)
  {
    return {};
  }
  const std::size_t begin = at + key.size();
  return title.substr(begin, title.find_first_of(", \t", begin) - begin);
}

PackFrame Read(ByteStream& bytes, const FramePlace&, const ReadSettings&)
{
  LineSource lines(bytes);
  const Header header = ReadHeader(lines);
  if (!header.Count)
  {
    lines.Fail("a line 'N atoms' is required before the section Atoms, got none.");
  }
  RowColumns columns = RowColumns::Named(ColumnsOf(lines, header.Style));
  columns.More = true; // image flags, and what comes by other commands
  PackFrame frame;
  SphereRows(lines, columns, frame).Read(*header.Count);
  TakeRadiiOfYade(frame, header);
  SetBoxOf(header, frame);
  frame.LengthUnit = LengthUnitOfStyle(FromTitle(header.Title, "units = "));
  std::int64_t step;
  if (ParseWhole(FromTitle(header.Title, "timestep = "), step))
  {
    frame.Step = step;
  }
  return frame;
}

WrittenPack Write(const FramePack& pack, const WriteSettings& settings)
{
  const Window box = BoxOrBounds(pack);
  const LammpsNumbers numbers(pack);
  const SpherePack& spheres = pack.Pack;
  const std::string style = StyleOfLengthUnit(pack.LengthUnit);
  const int types = pack.Type.empty() ? 1 : *std::max_element(pack.Type.begin(), pack.Type.end());
  WrittenPack written;
  written.HoldLengthUnit = !style.empty();
  std::string& text = written.Bytes;
  text = Text("Sphere pack", style.empty() ? "" : ", units = ", style, "\n\n", spheres.Size(),
    " atoms\n", types + numbers.AddedToType, " atom types\n\n");
  for (int q = 0; q < 3; ++q)
  {
    AppendNumbers(text, { box.Origin[q], box.Origin[q] + box.Size[q] });
    text += Text(" ", "xyz"[q], "lo ", "xyz"[q], "hi\n");
  }
  text += "\nAtoms # sphere\n\n";
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    text += numbers.Of(pack, i);
    AppendNumbers(text,
      { 2.0 * spheres.Radius[i], settings.Density, spheres.X[i], spheres.Y[i], spheres.Z[i] });
    text += "\n";
  }
  return written;
}

bool Recognise(std::string_view begin)
{
  bool atoms = false, bounds = false;
  Fields words;
  const auto lines = FirstLines(begin, 100);
  for (std::size_t n = 1; n < lines.size(); ++n)
  {
    SplitBlanks(lines[n].substr(0, lines[n].find('#')), words);
    std::int64_t count;
    atoms = atoms || (words.size() == 2 && words[1] == "atoms" && ParseWhole(words[0], count));
    bounds = bounds || (words.size() == 4 && words[2] == "xlo" && words[3] == "xhi") ||
      (words.size() == 4 && words[3] == "avec");
  }
  return atoms && bounds;
}
}

const PackFormat LammpsData = { "LAMMPS data", Recognise, ScanOneFrame, Read, { Write, "data" } };
}
