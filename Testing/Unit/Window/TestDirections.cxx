// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/Directions.h"

#include "Oracles.h"

TEST(Directions, RefusesFewerThanTwo)
{
  EXPECT_SAYS(ruc::EvenDirections(1), "NumberOfDirections requires a number >= 2, got 1.");
  EXPECT_SAYS(ruc::EvenDirections(-3), "got -3.");
}

TEST(Directions, AreSpreadEvenly)
{
  // The mean of n n^T is 1/3 to the order of 1 / count, and nearest neighbours (n and -n alike) are
  // not much nearer than in a triangular lattice, where the angle is sqrt(4 pi / (sqrt(3) count))
  const int count = 200;
  const std::vector<ruc::Vector3> directions = ruc::EvenDirections(count);
  ASSERT_EQ(directions.size(), 200u);
  for (int p = 0; p < 3; ++p)
  {
    for (int q = 0; q < 3; ++q)
    {
      double mean = 0.0;
      for (const ruc::Vector3& n : directions)
      {
        mean += n[p] * n[q] / count;
      }
      EXPECT_NEAR(mean, p == q ? 1.0 / 3.0 : 0.0, 1.0 / count);
    }
  }
  double least = 10.0;
  for (int i = 0; i < count; ++i)
  {
    const ruc::Vector3& a = directions[i];
    EXPECT_NEAR(std::hypot(a[0], a[1], a[2]), 1.0, 1e-15);
    EXPECT_GT(a[2], 0.0);
    for (int j = 0; j < i; ++j)
    {
      const ruc::Vector3& b = directions[j];
      const double cosine = std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
      // At the equator the two halves of the spiral meet as they like
      if (a[2] > 0.1 && b[2] > 0.1)
      {
        least = std::min(least, std::acos(std::min(cosine, 1.0)));
      }
    }
  }
  EXPECT_GT(least, 0.7 * std::sqrt(4.0 * oracle::Pi / (std::sqrt(3.0) * count)));
}
