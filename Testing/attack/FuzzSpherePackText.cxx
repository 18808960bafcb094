// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// libFuzzer target: any text is read as a pack, or refused with std::invalid_argument. The first
// two bytes are the reader's settings, the third says whether periodic copies are looked for.
#include "ruc/Formats/SpherePackText.h"
#include "ruc/Particles/PeriodicReplicas.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  if (size < 3)
  {
    return 0;
  }
  ruc::SpherePackTextSettings settings;
  settings.SkipLines = bytes[0] % 4;
  settings.RadiusIsDiameter = bytes[0] & 4;
  settings.RadiusColumn = bytes[0] & 8 ? std::to_string(bytes[1] % 8) : bytes[0] & 16 ? "d" : "";
  settings.Scale = bytes[0] & 32 ? 1e-6 : 1.0;
  ruc::Window box;
  box.Size = { 10.0, 10.0, 10.0 };
  box.Periodic = { true, true, (bytes[2] & 2) != 0 };
  try
  {
    const ruc::SpherePackText text =
      ruc::ParseSpherePack({ reinterpret_cast<const char*>(bytes) + 3, size - 3 }, settings);
    if (bytes[2] & 1)
    {
      ruc::FindPeriodicCopies(text.Pack, box);
    }
  }
  catch (const std::invalid_argument&)
  {
  }
  return 0;
}
