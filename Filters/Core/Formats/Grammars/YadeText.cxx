// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Text of YADE (py/export.py): a table whose first line "#format x_y_z_r", "#format
// id_x_y_z_r_matId" and the like tells its columns; for x_y_z_r_attrs the last comment does.
#include "ruc/Formats/Fields.h"
#include "ruc/Formats/Grammars/Grammars.h"

#include <stdexcept>

namespace ruc
{
namespace
{
constexpr std::string_view Sign = "#format ";

bool Recognise(std::string_view begin)
{
  return begin.substr(0, Sign.size()) == Sign;
}

PackFrame Read(ByteStream& bytes, const FramePlace& place, const ReadSettings& settings)
{
  const std::string begin = ReadBytes(bytes, 0, 4096);
  if (!Recognise(begin))
  {
    throw std::invalid_argument("Line 1: '#format …' is required, got something else.");
  }
  const std::string_view format = TrimBlanks(FirstLines(begin, 1)[0].substr(Sign.size()));
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

WrittenPack Write(const FramePack& pack, const WriteSettings&)
{
  const SpherePack& spheres = pack.Pack;
  WrittenPack written;
  std::string& text = written.Bytes;
  text = "#format id_x_y_z_r_matId\n";
  for (std::size_t i = 0; i < spheres.Size(); ++i)
  {
    text += std::to_string(spheres.Id[i]) + " ";
    AppendNumbers(text, { spheres.X[i], spheres.Y[i], spheres.Z[i], spheres.Radius[i] });
    text += " " + std::to_string(TypeOf(pack, i)) + "\n";
  }
  return written;
}
}

const PackFormat YadeText = { "YADE text", Recognise, ScanOneFrame, Read, { Write, "yade txt" } };
}
