// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * A pack, and how tests measure its third order.
 */

#include "Oracles.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

namespace oracle
{
inline ruc::ThirdOrderOfSpheres Measure(
  const ruc::SpherePack& pack, const ruc::Window& window, const ruc::ThirdOrderSettings& settings)
{
  ruc::Communicator serial;
  return ruc::MeasureThirdOrder(ruc::SharePack(pack, window), settings, serial);
}

/** A pack without overlap in a periodic cube of edge 10. */
inline ruc::SpherePack SomePack()
{
  return RelaxedPack({ 60, 90 }, { 0.9, 0.6 }, PeriodicCube(10.0), 3);
}

inline ruc::ThirdOrderSettings Settings(double cutOff, bool byMode)
{
  ruc::ThirdOrderSettings settings;
  settings.CutOff = cutOff;
  settings.ByMode = byMode;
  settings.Blocks = 8;
  return settings;
}
}
