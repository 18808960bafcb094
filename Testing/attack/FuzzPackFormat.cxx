// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// libFuzzer target of one grammar, RUC_GRAMMAR: any bytes, packed by gzip or not, are read frame by
// frame and made packs, or refused with std::invalid_argument. The first byte is the settings. One
// of them says that what follows the last form feed is the text of a file beside it.
#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/Grammars/Grammars.h"
#include "ruc/Formats/GzipBytes.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace
{
void ReadAndMake(const ruc::PackFormat& format, ruc::ByteStream& bytes,
  const std::vector<ruc::FramePlace>& frames, std::size_t n, const ruc::ReadSettings& settings,
  const ruc::PackSettings& packSettings)
{
  try
  {
    const ruc::FramePack pack =
      ruc::MakePack(ruc::ReadFrame(format, bytes, frames, n, settings), packSettings);
    if (pack.Pack.Y.size() != pack.Pack.Size() || pack.Pack.Z.size() != pack.Pack.Size() ||
      pack.Pack.Radius.size() != pack.Pack.Size() || pack.Pack.Id.size() != pack.Pack.Size() ||
      (!pack.Type.empty() && pack.Type.size() != pack.Pack.Size()) ||
      (!pack.Pack.Mode.empty() && pack.Pack.Mode.size() != pack.Pack.Size()))
    {
      std::abort();
    }
  }
  catch (const std::invalid_argument&)
  {
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 1)
  {
    return 0;
  }
  const std::uint8_t choice = data[0];
  std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::string beside;
  const std::size_t mark = content.rfind('\f');
  if (choice & 128 && mark != content.npos)
  {
    beside = content.substr(mark + 1);
    content = content.substr(0, mark);
  }
  ruc::ReadSettings settings;
  settings.SkipLines = choice & 1;
  settings.Columns = choice & 2 ? "id,x,y,z,r" : "";
  settings.RadiusColumn = choice & 4 ? "4" : "";
  settings.Beside = [beside](const std::string&) { return beside; };
  ruc::PackSettings packSettings;
  packSettings.UniformRadius = choice & 8 ? 0.5 : 0.0;
  packSettings.RadiusByType = choice & 16 ? "1=0.3;2=0.42;A=0.6" : "";
  if (choice & 32)
  {
    packSettings.Periodic = { true, true, (choice & 64) != 0 };
  }
  const ruc::PackFormat& format = ruc::RUC_GRAMMAR;
  try
  {
    const auto bytes = ruc::Unpack(std::make_unique<ruc::MemoryBytes>(content), 1u << 24);
    format.Recognise(ruc::ReadBytes(*bytes, 0, 4096));
    const std::vector<ruc::FramePlace> frames = format.Scan(*bytes);
    ruc::FrameTimes(frames);
    for (std::size_t n = 0; n < frames.size() && n < 4; ++n)
    {
      ReadAndMake(format, *bytes, frames, n, settings, packSettings);
    }
  }
  catch (const std::invalid_argument&)
  {
  }
  return 0;
}
