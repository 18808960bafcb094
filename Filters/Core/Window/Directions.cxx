// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Window/Directions.h"

#include "ruc/Base/Require.h"

#include <cmath>

namespace ruc
{
std::vector<Vector3> EvenDirections(int count)
{
  Require(count >= 2, "NumberOfDirections", "a number >= 2", count);
  constexpr double goldenAngle = 2.39996322972865332;
  std::vector<Vector3> directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = (i + 0.5) / count;
    const double lateral = std::sqrt(1.0 - z * z);
    const double turn = goldenAngle * i;
    directions.push_back({ lateral * std::cos(turn), lateral * std::sin(turn), z });
  }
  return directions;
}
}
