// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/FramePack.h"
#include "ruc/Formats/PackFormats.h"
#include "ruc/Particles/ParticleModes.h"

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/** The window of the example pack. */
inline const ruc::Window Block =
  ruc::Window::MakeBox({ 0, 0, 0 }, { 1445.372, 1287.892, 789.106 }, { false, false, false });

/** The example pack, with the modes of the examples, in canonical order. */
inline ruc::SpherePack ReadPack()
{
  std::ifstream file(RUC_EXAMPLE_DATA "/bead_block.csv");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  ruc::SpherePack pack = ruc::ReadPack(text).Pack;
  std::vector<double> diameters;
  for (double radius : pack.Radius)
  {
    diameters.push_back(2.0 * radius);
  }
  const ruc::ParticleModes modes(diameters, {});
  for (double d : diameters)
  {
    pack.Mode.push_back(modes.ModeOf(d));
  }
  ruc::SortCanonically(pack);
  return pack;
}
