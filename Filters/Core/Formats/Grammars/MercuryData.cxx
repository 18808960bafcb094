// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// .data of MercuryDPM (Kernel/DPMBase.cc): frames of a line "N t xmin ymin zmin xmax ymax zmax" and
// N rows of 14 numbers: centre, velocity, radius, angles, angular velocity, info, which is the
// species. Which axes are periodic is not told.
#include "ruc/Base/Text.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/LineSource.h"
#include "ruc/Formats/SphereRows.h"

#include <stdexcept>

namespace ruc
{
namespace
{
bool IsHeader(const std::vector<double>& numbers)
{
  return numbers.size() == 8 && numbers[0] >= 0.0 && numbers[0] < 1e15 &&
    numbers[0] == static_cast<double>(static_cast<std::int64_t>(numbers[0])) &&
    numbers[2] < numbers[5] && numbers[3] < numbers[6] && numbers[4] < numbers[7];
}

std::vector<double> ReadHeader(LineSource& lines)
{
  std::vector<double> header;
  const std::string_view line = lines.Require("a header");
  if (!ParseNumbers(line, header) || !IsHeader(header))
  {
    lines.Fail(Text("a header 'N t xmin ymin zmin xmax ymax zmax' of three dimensions is required, "
                    "got ",
      Quote(line), "."));
  }
  return header;
}

std::vector<FramePlace> Scan(ByteStream& bytes)
{
  std::vector<FramePlace> places;
  LineSource lines(bytes);
  std::string_view line;
  while (lines.Peek(line) || places.empty())
  {
    if (!places.empty() && TrimBlanks(line).empty())
    {
      lines.Next(line);
      continue;
    }
    places.push_back({ lines.Offset(), lines.Line(), {}, {} });
    try
    {
      const std::vector<double> header = ReadHeader(lines);
      places.back().Time = header[1];
      const auto count = static_cast<std::size_t>(header[0]);
      if (lines.Skip(count) < count)
      {
        break;
      }
    }
    catch (const std::invalid_argument&)
    {
      break;
    }
  }
  return places;
}

PackFrame Read(ByteStream& bytes, const FramePlace& place, const ReadSettings&)
{
  LineSource lines(bytes, place.Offset, place.LinesBefore);
  const std::vector<double> header = ReadHeader(lines);
  PackFrame frame;
  SphereRows(lines,
    RowColumns::Named({ "x", "y", "z", "vx", "vy", "vz", "radius", "alpha", "beta", "gamma",
      "omegax", "omegay", "omegaz", "type" }),
    frame)
    .Read(static_cast<std::int64_t>(header[0]));
  SetBox(frame,
    FrameCell::FromBounds({ header[2], header[3], header[4] }, { header[5], header[6], header[7] }),
    {}, false);
  frame.Time = header[1];
  return frame;
}

bool Recognise(std::string_view begin)
{
  const auto lines = FirstLines(begin, 2);
  std::vector<double> header, row;
  return lines.size() == 2 && ParseNumbers(lines[0], header) && IsHeader(header) &&
    ParseNumbers(lines[1], row) && row.size() == 14;
}
}

const PackFormat MercuryData = { "MercuryDPM data", Recognise, Scan, Read };
}
