// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// pack.out of LBPM (OPM/LBPM, common/SpherePack.cpp): five lines of header, the second with the
// edges of the domain, then x y z r; and what other packers write: three lines "lo hi", then the
// same rows. Both are periodic, and may repeat spheres beyond the box.
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
constexpr std::string_view DomainLength = "Domain Length";

// The numbers behind the colon, where commas may stand between them
std::vector<double> NumbersAfterColon(std::string_view line)
{
  std::string text(line.substr(std::min(line.find(':'), line.size() - 1) + 1));
  std::replace(text.begin(), text.end(), ',', ' ');
  std::vector<double> numbers;
  return ParseNumbers(text, numbers) ? numbers : std::vector<double>();
}

FrameCell ReadHeaderOfLbpm(LineSource& lines, std::optional<std::size_t>& stated)
{
  std::string_view line = lines.Require("Number of Spheres");
  const std::vector<double> count = line.empty() ? std::vector<double>() : NumbersAfterColon(line);
  if (count.size() == 1 && count[0] >= 0.0 && count[0] < 1e15)
  {
    stated = static_cast<std::size_t>(count[0]);
  }
  line = lines.Require("Domain Length");
  const std::vector<double> edges = line.empty() ? std::vector<double>() : NumbersAfterColon(line);
  if (edges.size() != 3)
  {
    lines.Fail(Text("Domain Length requires three numbers, got ", Quote(line), "."));
  }
  for (int n = 2; n < 5; ++n)
  {
    lines.Require("a header of five lines");
  }
  return FrameCell::FromBounds({}, { edges[0], edges[1], edges[2] });
}

FrameCell ReadBounds(LineSource& lines)
{
  Vector3 low, high;
  for (std::size_t q = 0; q < 3; ++q)
  {
    std::vector<double> bounds;
    const std::string_view line = lines.Require("lo hi");
    if (!ParseNumbers(line, bounds) || bounds.size() != 2 || !(bounds[0] < bounds[1]))
    {
      lines.Fail(Text("two rising numbers are required, got ", Quote(line), "."));
    }
    low[q] = bounds[0];
    high[q] = bounds[1];
  }
  return FrameCell::FromBounds(low, high);
}

PackFrame Read(ByteStream& bytes, const FramePlace&, const ReadSettings&)
{
  LineSource lines(bytes);
  std::string_view first;
  std::optional<std::size_t> stated;
  const bool bounds = lines.Peek(first) && first.find(':') == first.npos;
  const FrameCell cell = bounds ? ReadBounds(lines) : ReadHeaderOfLbpm(lines, stated);
  PackFrame frame;
  SphereRows(lines, RowColumns::Named({ "x", "y", "z", "radius" }), frame).ReadAll();
  if (stated && frame.Size() < *stated)
  {
    throw std::invalid_argument(Text(*stated, " rows are required, got ", frame.Size(), "."));
  }
  SetBox(frame, cell, { true, true, true }, true);
  return frame;
}

bool Recognise(std::string_view begin)
{
  const auto lines = FirstLines(begin, 4);
  if (lines.size() < 4)
  {
    return false;
  }
  std::vector<double> numbers[4];
  bool bounds = true;
  for (std::size_t n = 0; n < 4; ++n)
  {
    bounds = bounds && ParseNumbers(lines[n], numbers[n]) && numbers[n].size() == (n < 3 ? 2 : 4);
  }
  return bounds || lines[1].substr(0, DomainLength.size()) == DomainLength;
}
}

const PackFormat LbpmPack = { "LBPM pack", Recognise, ScanOneFrame, Read };
}
