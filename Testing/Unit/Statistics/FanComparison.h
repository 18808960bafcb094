// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Oracles.h"
#include "SampledComparison.h"
#include "ruc/Statistics/Sampling/FanSampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

/** What tests of throws of fans have in common. */
namespace fans
{
using ruc::FanSettings;
using ruc::PhaseTriple;
using ruc::SamplingRegion;
using ruc::SpherePack;
using ruc::ThreePointGrid;
using ruc::ThreePointProbability;
using ruc::Window;

/** Samples on one rank and one thread. */
inline ThreePointProbability Fans(const SpherePack& pack, int modes, const SamplingRegion& region,
  const ThreePointGrid& grid, const std::vector<PhaseTriple>& triples, const FanSettings& settings)
{
  const OneThread alone;
  ruc::Communicator serial;
  return ruc::SampleFans(pack, modes, region, grid, triples, settings, serial);
}

/** Calls visit(k1, k2, t) for every place of a grid, in order. */
template <class Visit>
void ForEachPlace(const ThreePointGrid& grid, Visit&& visit)
{
  for (int t = 0; t < grid.Angles(); ++t)
  {
    for (int k2 = 0; k2 < grid.Points(); ++k2)
    {
      for (int k1 = 0; k1 < grid.Points(); ++k1)
      {
        visit(k1, k2, t);
      }
    }
  }
}
}
