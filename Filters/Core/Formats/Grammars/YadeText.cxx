// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Text of YADE (py/export.py): a table whose first line "#format x_y_z_r", "#format
// id_x_y_z_r_matId" and the like tells its columns; for x_y_z_r_attrs the last comment does.
#include "ruc/Formats/Fields.h"
#include "ruc/Formats/Grammars/Grammars.h"

namespace ruc
{
namespace
{
constexpr std::string_view Sign = "#format ";

PackFrame Read(ByteStream& bytes, const FramePlace& place, const ReadSettings& settings)
{
  const std::string begin = ReadBytes(bytes, 0, 4096);
  const auto lines = FirstLines(begin, 1);
  const std::string_view format =
    lines.empty() ? std::string_view() : TrimBlanks(lines[0].substr(Sign.size()));
  ReadSettings named = settings;
  if (named.Columns.empty() && format.find("attrs") == format.npos)
  {
    for (char c : format)
    {
      named.Columns += c == '_' ? ',' : c;
    }
  }
  return Table.Read(bytes, place, named);
}

bool Recognise(std::string_view begin)
{
  return begin.substr(0, Sign.size()) == Sign;
}
}

const PackFormat YadeText = { "YADE text", Recognise, ScanOneFrame, Read };
}
