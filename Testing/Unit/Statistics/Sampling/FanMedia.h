// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Statistics/FanComparison.h"

namespace fans
{
/** A pack and the region in which it is sampled. */
struct Medium
{
  const char* Name;
  SpherePack Pack;
  SamplingRegion Region;
  double Spacing;
};

/** Overlapping spheres of two modes in regions of all kinds. */
inline std::vector<Medium> Media()
{
  const Window periodic = Window::MakeBox({ -1, 2, 3 }, { 4, 5, 4.5 }, { true, true, true });
  const Window partly = Window::MakeBox({ -1, 2, 3 }, { 4, 5, 6 }, { true, false, true });
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 5, 6, 5.5 }, { false, false, false });
  const Window cylinder = Window::MakeCylinder({ 2, 2, 1 }, { 0.3, -1, 2 }, 2.2, 4.0);
  const Window around = Window::MakeBox({ -2, -2, -2 }, { 9, 9, 9 }, { false, false, false });
  std::vector<std::uint8_t> inside(6 * 6 * 6, 1);
  inside[2 + 6 * (3 + 6 * 2)] = inside[5] = inside[4] = inside[3 + 6 * (3 + 6 * 3)] = 0;
  return { { "periodic", oracle::RandomPack({ 12, 25 }, { 0.9, 0.5 }, periodic, 1),
             SamplingRegion(periodic, 0.0), 0.9 },
    { "partly periodic", oracle::RandomPack({ 12, 25 }, { 0.9, 0.5 }, partly, 2),
      SamplingRegion(partly, 0.3), 0.31 },
    { "box", oracle::RandomPack({ 12, 25 }, { 0.9, 0.5 }, box, 3), SamplingRegion(box, 0.5), 0.29 },
    { "cylinder", oracle::RandomPack({ 40, 90 }, { 0.9, 0.5 }, around, 4),
      SamplingRegion(cylinder, 0.0), 0.3 },
    { "mask", oracle::RandomPack({ 40, 90 }, { 0.9, 0.5 }, around, 5),
      SamplingRegion(ruc::VoxelMask({ 6, 6, 6 }, { 0, 0, 0 }, { 0.8, 0.9, 1.0 }, inside), 0.0),
      0.33 },
    { "empty", SpherePack(), SamplingRegion(periodic, 0.0), 0.5 } };
}

/** Triples of two modes and the matrix; two of them are another one with s and q swapped. */
inline const std::vector<PhaseTriple> Triples = { { 0, 0, 0 }, { 2, 2, 2 }, { 0, 1, 2 },
  { 1, 2, 0 }, { 1, 0, 2 }, { 2, 1, 1 }, { 0, 2, 1 } };

/** Expects the same number, or none from both. */
inline void ExpectSame(double a, double b, const char* what, std::size_t triple, std::size_t place)
{
  EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
    << what << " of triple " << triple << " at " << place << ": " << a << " and " << b;
}
}
