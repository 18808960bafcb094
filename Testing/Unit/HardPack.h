// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Packing/DensePack.h"

/**
 * Hard spheres of the radii 1 (mode 1) and 0.6 (mode 2) after some collisions, which have gaps of
 * all widths. The box is that of a periodic pack; as a window that is not periodic it cuts spheres.
 */
struct HardPack
{
  HardPack(int large, int small, double fraction, bool periodic = true)
  {
    ruc::DensePackSettings settings;
    settings.Radii.assign(large, 1.0);
    settings.Radii.insert(settings.Radii.end(), small, 0.6);
    settings.Fraction = fraction;
    settings.Protocol = ruc::PackingProtocol::Events;
    settings.Equilibration = 20.0;
    const ruc::DensePack made =
      ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
    this->Pack = made.Pack;
    for (double radius : this->Pack.Radius)
    {
      this->Pack.Mode.push_back(radius == 1.0 ? 1 : 2);
    }
    this->Box =
      ruc::Window::MakeBox(made.Box.Origin, made.Box.Size, { periodic, periodic, periodic });
  }
  ruc::SpherePack Pack;
  ruc::Window Box;
};
