// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CellSearch.h"
#include "RunProgress.h"

#include <string>
#include <vector>

/** The texts that a reconstruction shows its user. */
namespace CellMessages
{
/** Describes where the search for cell `cell`, counted from 0, stands. */
RunProgress DescribeProgress(
  int cell, const ruc::SearchState& state, const CellSearch::Settings& settings);

/**
 * Returns the warning that a user needs where a pack is too small to tell near neighbours or pores
 * that weigh something; empty where it is not.
 */
std::string FindNeighbourWarning(const ruc::NeighbourTarget& neighbours);

/** Returns the warnings that a user needs about the cells that were found. */
std::vector<std::string> FindWarnings(const std::vector<CellSearch::FoundCell>& cells,
  const ruc::CellContents& contents, const CellSearch::Settings& settings);
}
