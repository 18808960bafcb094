// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Text.h"

#include <stdexcept>

namespace ruc
{
/**
 * Throws std::invalid_argument, such as "Seed requires a number >= 0, got -1.", unless `good`.
 * Every refusal of a setting reads like this.
 */
template <class What, class Got>
void Require(bool good, const char* name, const What& what, const Got& got)
{
  if (!good)
  {
    throw std::invalid_argument(Text(name, " requires ", what, ", got ", got, "."));
  }
}
}
