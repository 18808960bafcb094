// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

inline void ExpectNear(
  const std::vector<double>& values, const std::vector<double>& expected, double bound)
{
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    EXPECT_NEAR(values[k], expected[k], bound) << "lag " << k;
  }
}

// Gives all spheres radii of their own, different by so little that it cannot matter, so that there
// are more types than the tables take
inline ruc::SpherePack WithDistinctRadii(ruc::SpherePack pack)
{
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    pack.Radius[i] *= 1.0 + 1e-9 * (double(i) / pack.Size() - 0.5);
  }
  return pack;
}

// The documented error of the tables, 1e-6 of each S_rs, is taken as 1e-6 of its largest value,
// which is c_r for r = s; the functions of two modes are no larger than the lesser c_r
constexpr double TableError = 1e-6;
