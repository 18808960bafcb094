// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/DensePack.h"
#include "ruc/Packing/EventRemoval.h"

#include "PackingOracles.h"

#include <random>

namespace
{
ruc::DensePack Dense()
{
  ruc::DensePackSettings settings;
  settings.Radii.assign(300, 0.5);
  settings.Fraction = 0.63;
  return ruc::MakeDensePack(settings, [](const ruc::GrowthStep&, double) { return true; });
}
}

TEST(EventRemoval, TakesALittleOverlapOut)
{
  const ruc::DensePack dense = Dense();
  ruc::SpherePack pack = dense.Pack;
  std::mt19937 engine(1);
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    pack.X[i] += 0.002 * (engine() / 4294967296.0 - 0.5);
  }
  ruc::WrapIntoBox(pack, dense.Box);
  const ruc::SpherePack before = pack;
  EXPECT_LT(oracle::LeastRoom(pack, dense.Box), -1e-5);
  EXPECT_TRUE(ruc::RemoveOverlapByEvents(pack, dense.Box, 1, []() { return true; }));
  EXPECT_GE(oracle::LeastRoom(pack, dense.Box), 0.0);
  EXPECT_EQ(pack.Radius, before.Radius);
  double furthest = 0.0;
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    const double d = std::abs(pack.Y[i] - before.Y[i]);
    furthest = std::max(furthest, std::min(d, dense.Box.Size[1] - d));
  }
  EXPECT_LT(furthest, 0.25);
}

TEST(EventRemoval, LeavesWhatItCannotFree)
{
  const ruc::DensePack dense = Dense();
  ruc::SpherePack pack = dense.Pack;
  for (double& r : pack.Radius)
  {
    r *= 1.02; // a fraction of 0.668
  }
  const ruc::SpherePack before = pack;
  EXPECT_FALSE(ruc::RemoveOverlapByEvents(pack, dense.Box, 1, []() { return true; }));
  EXPECT_EQ(pack.X, before.X);
  pack = dense.Pack;
  pack.X[0] += 0.05;
  const ruc::SpherePack moved = pack;
  EXPECT_FALSE(ruc::RemoveOverlapByEvents(pack, dense.Box, 1, []() { return false; }));
  EXPECT_EQ(pack.X, moved.X);
}
