// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/CellContents.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/**
 * Returns random centres, one of the two ways in which a cell is filled before a search (section IV
 * B of the paper): x, y, z of every sphere in the order of the modes, uniform in [0, edge)^3
 * without regard to overlap. They depend on the contents, the seed and `number` alone, which tells
 * the individuals of a population apart. The other way is DepositBallistically.
 */
std::vector<double> RandomCentres(
  const CellContents& contents, std::uint32_t seed, std::uint32_t number);

/** The seconds that it takes to put a sphere at random or to deposit it. */
constexpr double SecondsPerStartedSphere = 1e-6;
}
