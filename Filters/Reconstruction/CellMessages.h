// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CellSearch.h"
#include "RunProgress.h"

#include <string>
#include <vector>

/** What a reconstruction tells its user in words. */
namespace CellMessages
{
/** Where the search for cell `cell`, from 0, stands. */
RunProgress DescribeProgress(
  int cell, const ruc::SearchState& state, const CellSearch::Settings& settings);

/** What a user has to know of the cells that were found. */
std::vector<std::string> FindWarnings(
  const std::vector<CellSearch::FoundCell>& cells, const CellSearch::Settings& settings);
}
