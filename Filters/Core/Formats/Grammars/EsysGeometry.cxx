// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// .geo of ESyS-Particle and LSMGenGeo (answers.launchpad.net/esys-particle/+faq/877): BoundingBox,
// PeriodicBoundaries, Dimension, then the particles, rows of x y z r id tag. EndParticles may be
// absent.
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
constexpr std::string_view Sign = "LSMGeometry";

// Numbers behind the first word of the line
std::vector<double> NumbersBehind(const LineSource& lines, std::string_view line, std::size_t count)
{
  line = TrimBlanks(line);
  std::vector<double> numbers;
  if (!ParseNumbers(line.substr(std::min(line.find_first_of(" \t"), line.size())), numbers) ||
    numbers.size() != count)
  {
    lines.Fail(Text(count, " numbers are required, got ", Quote(line), "."));
  }
  return numbers;
}

std::int64_t ReadCount(LineSource& lines)
{
  std::string_view line = TrimBlanks(lines.Require("Simple"));
  if (line != "Simple")
  {
    lines.Fail(Text("particles 'Simple' are required, got ", Quote(line), "."));
  }
  line = TrimBlanks(lines.Require("a number of particles"));
  std::int64_t count;
  if (!ParseWhole(line, count))
  {
    lines.Fail(Text("a number of particles is required, got ", Quote(line), "."));
  }
  return count;
}

PackFrame Read(ByteStream& bytes, const FramePlace&, const ReadSettings&)
{
  LineSource lines(bytes);
  std::optional<FrameCell> cell;
  std::array<bool, 3> periodic{};
  bool known = false;
  Fields words;
  while (true)
  {
    const std::string_view line = lines.Require("BeginParticles");
    SplitBlanks(line, words);
    const std::string_view word = words.empty() ? std::string_view() : words[0];
    if (word == "BoundingBox")
    {
      const auto n = NumbersBehind(lines, line, 6);
      cell = FrameCell::FromBounds({ n[0], n[1], n[2] }, { n[3], n[4], n[5] });
    }
    else if (word == "PeriodicBoundaries")
    {
      const auto n = NumbersBehind(lines, line, 3);
      periodic = { n[0] != 0.0, n[1] != 0.0, n[2] != 0.0 };
      known = true;
    }
    else if (word == "Dimension" && (words.size() != 2 || words[1] != "3D"))
    {
      lines.Fail(Text("Dimension 3D is required, got ", Quote(line), "."));
    }
    else if (word == "BeginParticles")
    {
      break;
    }
  }
  PackFrame frame;
  const std::int64_t count = ReadCount(lines);
  SphereRows(lines, RowColumns::Named({ "x", "y", "z", "radius", "id", "type" }), frame)
    .Read(count);
  if (cell)
  {
    SetBox(frame, *cell, periodic, known);
  }
  return frame;
}

bool Recognise(std::string_view begin)
{
  return begin.substr(0, Sign.size()) == Sign;
}
}

const PackFormat EsysGeometry = { "ESyS-Particle geometry", Recognise, ScanOneFrame, Read };
}
