// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Tracing/SphereGrid.h"

#include "Oracles.h"

namespace
{
using ruc::SphereGrid;
using ruc::SpherePack;
using ruc::Vector3;
using ruc::Window;

Vector3 PointIn(const Window& box, oracle::Uniform& random)
{
  Vector3 point;
  for (int q = 0; q < 3; ++q)
  {
    point[q] = random(box.Origin[q], box.Origin[q] + box.Size[q]);
  }
  return point;
}
}

TEST(SphereGrid, FindsTheLowestModeAtAPoint)
{
  oracle::Uniform random(7);
  for (const std::array<bool, 3>& periodic :
    { std::array<bool, 3>{ false, false, false }, { true, true, true } })
  {
    for (const oracle::PackInBox& c : oracle::HardPacks(periodic))
    {
      if (c.Box.IsFullyPeriodic() && c.Box.Size[2] < 1.0)
      {
        continue; // the plate, with edges shorter than allowed for the images
      }
      const SphereGrid grid(c.Pack, c.Box);
      for (int n = 0; n < 1000; ++n)
      {
        const Vector3 p = PointIn(c.Box, random);
        int lowest = 99;
        for (std::size_t i = 0; i < c.Pack.Size(); ++i)
        {
          double distance2 = 0.0;
          for (int q = 0; q < 3; ++q)
          {
            double d = p[q] - c.Pack.Centre(i)[q];
            d -= c.Box.Periodic[q] ? c.Box.Size[q] * std::round(d / c.Box.Size[q]) : 0.0;
            distance2 += d * d;
          }
          if (distance2 < c.Pack.Radius[i] * c.Pack.Radius[i])
          {
            lowest = std::min(lowest, c.Pack.Mode[i] - 1);
          }
        }
        EXPECT_EQ(grid.LowestModeAt(p, 99), lowest);
      }
    }
  }
}
