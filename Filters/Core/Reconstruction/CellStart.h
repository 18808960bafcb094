// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Reconstruction/CellContents.h"
#include "ruc/Reconstruction/CellObjective.h"

#include <cstdint>
#include <functional>
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

/**
 * Above this share of MaximumRandomFraction cells are dense: their spheres touch so often that a
 * search from random centres would jam, with overlap.
 */
constexpr double DenseShare = 0.94;

/**
 * Throws std::invalid_argument where the cells of a population would keep overlap: above 0.98 of
 * MaximumRandomFraction spheres that are pushed apart jam.
 */
void RequireLoose(const CellContents& contents);

/** The most that the edge of a dense cell may grow where its spheres jam. */
constexpr double LongestEdge = 1.2;

/**
 * Returns whether a cell of spheres with these radii is dense. Throws std::invalid_argument for a
 * fraction that is more than 0.015 above MaximumRandomFraction. The second form asks for the
 * spheres enlarged by the least gap.
 */
bool IsDense(const std::vector<double>& radii, double fraction, double edge);
bool IsDense(const CellContents& contents);

/**
 * Returns centres of a dense cell without overlap, made by events (MakeDensePack). Where the
 * spheres jam before they fill the cell, its edge is lengthened, LongestEdge times at most. It is
 * given up when `carryOn` returns false; the centres then fill the cell with some overlap.
 */
std::vector<double> DenseCentres(
  CellContents& contents, std::uint32_t seed, const std::function<bool()>& carryOn);

/** What DenseCentres takes; nothing where the cell is not known to be dense. Throws as IsDense. */
Estimate EstimateDenseStart(const CellFigures& cell);

/** The seconds that it takes to put a sphere at random or to deposit it. */
constexpr double SecondsPerStartedSphere = 1e-6;
}
