// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThreePointGrid.h"

#include "Statistics/FanComparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace
{
using ruc::ThreePointGrid;
}

TEST(ThreePointGrid, OrdersPlacesAndCountsPairs)
{
  for (int directions : { 2, 3, 4, 7, 20 })
  {
    const ThreePointGrid grid = { { 0.5, 4 }, directions };
    std::size_t place = 0;
    fans::ForEachPlace(
      grid, [&](int k1, int k2, int t) { EXPECT_EQ(grid.PlaceOf(k1, k2, t), place++); });
    EXPECT_EQ(grid.Size(), place);
    std::map<int, int> pairs;
    for (int i = 0; i < directions; ++i)
    {
      for (int j = 0; j < directions; ++j)
      {
        ++pairs[std::min(std::abs(i - j), directions - std::abs(i - j))];
      }
    }
    ASSERT_EQ(grid.Angles(), static_cast<int>(pairs.size()));
    for (int t = 0; t < grid.Angles(); ++t)
    {
      EXPECT_EQ(grid.RayPairs(t), pairs[t]);
      EXPECT_DOUBLE_EQ(grid.Angle(t), 360.0 / directions * t);
    }
  }
  // The paper's angles
  const ThreePointGrid paper = { { 0.5, 4 }, 20 };
  EXPECT_EQ(paper.Angle(0), 0.0);
  EXPECT_EQ(paper.Angle(4), 72.0);
  EXPECT_EQ(paper.Angle(10), 180.0);
}
