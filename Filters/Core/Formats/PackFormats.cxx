// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/PackFormats.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/Fields.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/GzipBytes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace ruc
{
const std::vector<const PackFormat*>& PackFormats()
{
  // Strict signs first: tables come last, as almost any text may be one
  static const std::vector<const PackFormat*> formats = {
    &HoomdGsd,
    &LammpsDump,
    &EsysGeometry,
    &YadeText,
    &LbpmPack,
    &ExtendedXyz,
    &SkogePack,
    &MercuryData,
    &LammpsData,
    &BaranauXyzd,
    &Table,
  };
  return formats;
}

namespace
{
// Their rows of numbers look like those of tables
bool IsVtkFile(std::string_view begin)
{
  return begin.rfind("# vtk DataFile", 0) == 0 || begin.rfind("<?xml", 0) == 0 ||
    begin.rfind("<VTKFile", 0) == 0;
}
}

const PackFormat* FindFormat(ByteStream& bytes)
{
  const std::string begin = ReadBytes(bytes, 0, 4096);
  if (IsVtkFile(begin))
  {
    return nullptr;
  }
  for (const PackFormat* format : PackFormats())
  {
    if (format->Recognise(begin))
    {
      return format;
    }
  }
  return nullptr;
}

namespace
{
std::string ListOfFormats()
{
  std::string list;
  for (const PackFormat* format : PackFormats())
  {
    list += Text(list.empty() ? "" : ", ", format->Name);
  }
  return list;
}
}

const PackFormat& ChooseFormat(
  ByteStream& bytes, std::string_view name, const ReadSettings& settings)
{
  for (const PackFormat* format : PackFormats())
  {
    if (name == format->Name)
    {
      return *format;
    }
  }
  if (name != AutomaticFormat)
  {
    throw std::invalid_argument(
      Text("Format requires ", AutomaticFormat, ", ", ListOfFormats(), "; got '", name, "'."));
  }
  if (settings.SkipLines > 0)
  {
    return Table;
  }
  if (const PackFormat* format = FindFormat(bytes))
  {
    return *format;
  }
  const std::string begin = ReadBytes(bytes, 0, 4096);
  if (IsVtkFile(begin))
  {
    throw std::invalid_argument("A file of another program is required, got one of VTK: open it "
                                "by ParaView's own reader, and apply Points To Sphere Pack.");
  }
  if (!begin.empty() && FirstLines(begin, 1)[0].find('\0') != std::string_view::npos)
  {
    throw std::invalid_argument(Text("A file of one of these formats is required: ",
      ListOfFormats(), "; got bytes that are no text and have the sign of none."));
  }
  return Table;
}

PackFrame ReadFrame(const PackFormat& format, ByteStream& bytes,
  const std::vector<FramePlace>& frames, std::size_t n, const ReadSettings& settings)
{
  try
  {
    Require(settings.SkipLines >= 0, "SkipLines", "a number >= 0", settings.SkipLines);
    PackFrame frame = format.Read(bytes, frames.at(n), settings);
    if (frame.Size() == 0)
    {
      throw std::invalid_argument("At least one sphere is required, got none.");
    }
    frame.Format = format.Name;
    return frame;
  }
  catch (const std::invalid_argument& fault)
  {
    if (frames.size() == 1)
    {
      throw;
    }
    throw std::invalid_argument(Text("Frame ", n + 1, ": ", fault.what()));
  }
}

std::vector<double> FrameTimes(const std::vector<FramePlace>& frames)
{
  std::vector<double> times;
  for (const FramePlace& frame : frames)
  {
    if (!frame.Time || (!times.empty() && !(*frame.Time > times.back())))
    {
      times.clear();
      break;
    }
    times.push_back(*frame.Time);
  }
  for (std::size_t n = times.size(); n < frames.size(); ++n)
  {
    times.push_back(static_cast<double>(n));
  }
  return times;
}

FramePack ReadPack(std::string_view bytes)
{
  const std::unique_ptr<ByteStream> unpacked = Unpack(std::make_unique<MemoryBytes>(bytes));
  const ReadSettings settings;
  const PackFormat& format = ChooseFormat(*unpacked, AutomaticFormat, settings);
  return MakePack(ReadFrame(format, *unpacked, format.Scan(*unpacked), 0, settings), {});
}

const PackFormat& FormatOfExtension(std::string_view extension)
{
  std::string known;
  const std::string wanted = Lower(extension);
  for (const PackFormat* format : PackFormats())
  {
    Fields extensions;
    SplitBlanks(format->Writer.Extensions, extensions);
    if (std::find(extensions.begin(), extensions.end(), wanted) != extensions.end())
    {
      return *format;
    }
    for (std::string_view other : extensions)
    {
      known += Text(known.empty() ? "" : ", ", other);
    }
  }
  throw std::invalid_argument(
    Text("one of the extensions ", known, " is required, got ", Quote(extension), "."));
}

WrittenPack WritePack(
  const PackFormat& format, const FramePack& pack, const WriteSettings& settings)
{
  Require(settings.Density > 0.0 && std::isfinite(settings.Density), "Density",
    "a finite number > 0", settings.Density);
  if (pack.Pack.Empty())
  {
    throw std::invalid_argument(NoSpheres);
  }
  return format.Writer.Write(pack, settings);
}
}
