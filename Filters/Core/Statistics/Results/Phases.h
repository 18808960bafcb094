// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ruc
{
// Phases are counted from 0: the modes, then the matrix, which is phase `modes`.

/** "1", "2", …, "m". */
std::string PhaseName(int phase, int modes);

/**
 * The lists of phases in a text such as "1 1; 3 m", `length` phases each. Throws
 * std::invalid_argument for any other text: `required`, which ends with what a list is, then what
 * was got.
 */
std::vector<std::vector<int>> ParsePhaseLists(
  const std::string& text, int modes, std::size_t length, const std::string& required);

/** Unordered pairs of phases. */
constexpr double PairsOfPhases(int modes)
{
  return 0.5 * (modes + 1.0) * (modes + 2.0);
}
}
