// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ruc
{
// Phases are counted from 0: first the modes, then the matrix, which is phase `modes`.

/** The name of a phase: "1", "2", … for the modes and "m" for the matrix. */
std::string PhaseName(int phase, int modes);

/**
 * Returns the lists of phases in a text such as "1 1; 3 m", with `length` phases each. Throws
 * std::invalid_argument for any other text; the message is `required`, which says what a list is,
 * followed by what was got.
 */
std::vector<std::vector<int>> ParsePhaseLists(
  const std::string& text, int modes, std::size_t length, const std::string& required);

/** The number of unordered pairs of phases. */
constexpr double PairsOfPhases(int modes)
{
  return 0.5 * (modes + 1.0) * (modes + 2.0);
}
}
