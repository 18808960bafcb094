// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/PackFormats.h"

#include "ruc/Base/Text.h"
#include "ruc/Formats/Grammars/Grammars.h"

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

const PackFormat* FindFormat(ByteStream& bytes)
{
  const std::string begin = ReadBytes(bytes, 0, 4096);
  for (const PackFormat* format : PackFormats())
  {
    if (format->Recognise(begin))
    {
      return format;
    }
  }
  return nullptr;
}

PackFrame ReadFrame(const PackFormat& format, ByteStream& bytes,
  const std::vector<FramePlace>& frames, std::size_t n, const ReadSettings& settings)
{
  try
  {
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
}
