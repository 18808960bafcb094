// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Base/FixedPoint.h"

#include "ruc/Base/VectorClones.h"

#include <algorithm>

namespace ruc
{
RUC_VECTOR_CLONES
void AddFixedPoint(
  const double* values, std::size_t count, double most, double scale, std::int64_t* sums)
{
  for (std::size_t n = 0; n < count; ++n)
  {
    sums[n] += RoundToFixedPoint(std::clamp(values[n], -most, most) * scale);
  }
}
}
