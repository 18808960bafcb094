// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Results/LagGrid.h"

#include <vector>

namespace ruc
{
/**
 * Returns the values at the lags r_0 … r_K of the function that is linear between these, has the
 * value `atZero` at 0, and is nearest to the values at the lengths, in (0, r_K]: the sum of
 * (difference / length)^2 is least. Lengths or values that are not numbers are left out. Between
 * any two lags in a row, the second included, there must be a length.
 */
std::vector<double> FitRadial(const std::vector<double>& lengths, const std::vector<double>& values,
  double atZero, const LagGrid& lags);
}
