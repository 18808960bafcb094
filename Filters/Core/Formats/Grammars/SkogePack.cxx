// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Packs of Donev's PackLSD and of Skoge's program (cims.nyu.edu/~donev/Packing/PackLSD, box.C): the
// dimension; "N species"; the number of spheres of each species; their diameters, absent where all
// sizes differ; the edges of the cell; T or F, periodic or wall, along each; rows of x y z, or of
// x y z diameter, which then holds.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/LineSource.h"
#include "ruc/Formats/SphereRows.h"

#include <algorithm>
#include <stdexcept>

namespace ruc
{
namespace
{
// Three words T or F
bool ParsePeriodic(std::string_view line, std::array<bool, 3>& periodic)
{
  Fields words;
  SplitBlanks(line, words);
  for (std::size_t q = 0; q < 3 && words.size() == 3; ++q)
  {
    if (words[q] != "T" && words[q] != "F")
    {
      return false;
    }
    periodic[q] = words[q] == "T";
  }
  return words.size() == 3;
}

struct Header
{
  std::vector<std::int64_t> Counts; // of each species
  std::vector<double> Diameters;    // of each species; may be empty
  FrameCell Cell;
  std::array<bool, 3> Periodic{};
  std::int64_t Count = 0;
};

// All numbers up to the line of T and F: counts, diameters, edges, on whatever lines they stand
std::vector<double> ReadNumbers(LineSource& lines, std::array<bool, 3>& periodic)
{
  std::vector<double> all, some;
  while (true)
  {
    const std::string_view line = lines.Require("a line of T and F");
    if (ParsePeriodic(line, periodic))
    {
      return all;
    }
    if (!ParseNumbers(line, some))
    {
      lines.Fail(Text("numbers, or T or F along three axes, are required, got ", Quote(line), "."));
    }
    all.insert(all.end(), some.begin(), some.end());
  }
}

Header ReadHeader(LineSource& lines)
{
  std::vector<double> dimension, counts;
  if (!ParseNumbers(lines.Require("the dimension"), dimension) || dimension.size() != 1 ||
    dimension[0] != 3.0)
  {
    lines.Fail("3 dimensions are required, got others.");
  }
  if (!ParseNumbers(lines.Require("the number of spheres and species"), counts) ||
    counts.size() != 2 || !(counts[0] >= 1.0 && counts[0] < 1e15) ||
    !(counts[1] >= 1.0 && counts[1] < 1e4))
  {
    lines.Fail("the numbers of spheres and of species are required, got others.");
  }
  Header header;
  header.Count = static_cast<std::int64_t>(counts[0]);
  const auto species = static_cast<std::size_t>(counts[1]);
  const std::vector<double> numbers = ReadNumbers(lines, header.Periodic);
  if (numbers.size() != species + 9 && numbers.size() != 2 * species + 9)
  {
    lines.Fail(Text(species + 9, " or ", 2 * species + 9,
      " numbers are required before the line of T and F, got ", numbers.size(), "."));
  }
  double sum = 0.0;
  for (std::size_t s = 0; s < species; ++s)
  {
    sum += numbers[s];
    header.Counts.push_back(
      numbers[s] >= 0.0 && numbers[s] < 1e15 ? static_cast<std::int64_t>(numbers[s]) : 0);
  }
  if (sum != counts[0])
  {
    lines.Fail(Text("species of ", header.Count, " spheres in all are required, got ", sum, "."));
  }
  header.Diameters.assign(numbers.begin() + static_cast<long>(species), numbers.end() - 9);
  for (std::size_t n = 0; n < 9; ++n)
  {
    header.Cell.Edges[n / 3][n % 3] = numbers[numbers.size() - 9 + n];
  }
  return header;
}

// Rows come species after species
void AddSpecies(const Header& header, bool withRadii, PackFrame& frame)
{
  for (std::size_t s = 0; s < header.Counts.size(); ++s)
  {
    const auto count = static_cast<std::size_t>(header.Counts[s]);
    frame.Type.insert(frame.Type.end(), count, static_cast<int>(s) + 1);
    if (withRadii)
    {
      if (!(header.Diameters[s] > 0.0))
      {
        throw std::invalid_argument(
          Text("Diameters > 0 are required, got ", header.Diameters[s], "."));
      }
      frame.Radius.insert(frame.Radius.end(), count, 0.5 * header.Diameters[s]);
    }
  }
}

PackFrame Read(ByteStream& bytes, const FramePlace&, const ReadSettings&)
{
  LineSource lines(bytes);
  const Header header = ReadHeader(lines);
  std::string_view line;
  Fields row;
  if (lines.Peek(line))
  {
    SplitBlanks(line, row);
  }
  const bool column = row.size() == 4;
  if (!column && header.Diameters.empty())
  {
    lines.Fail("diameters are required, of the species or in a fourth column, got none.");
  }
  PackFrame frame;
  SphereRows(lines,
    RowColumns::Named(column ? std::vector<std::string>{ "x", "y", "z", "diameter" }
                             : std::vector<std::string>{ "x", "y", "z" }),
    frame)
    .Read(header.Count);
  AddSpecies(header, !column, frame);
  SetBox(frame, header.Cell, header.Periodic, true);
  return frame;
}

bool Recognise(std::string_view begin)
{
  const auto lines = FirstLines(begin, 60);
  std::vector<double> numbers;
  if (lines.size() < 5 || TrimBlanks(lines[0]).size() != 1 || !ParseNumbers(lines[0], numbers) ||
    !ParseNumbers(lines[1], numbers) || numbers.size() != 2)
  {
    return false;
  }
  std::array<bool, 3> periodic;
  return std::any_of(lines.begin() + 2, lines.end(),
    [&](std::string_view line) { return ParsePeriodic(line, periodic); });
}
}

const PackFormat SkogePack = { "Donev, Skoge", Recognise, ScanOneFrame, Read };
}
