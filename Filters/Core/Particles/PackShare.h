// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/CheckedPiece.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/** What every rank knows of a pack that is spread over ranks; the same on all. */
struct PackTotals
{
  Window Observed; // of the centres
  std::int64_t NumberOfSpheres = 0;
  double LargestRadius = 0.0;
  std::vector<std::int64_t> Count; // spheres of every mode; one mode where the pack has none
  std::vector<double> Volume;      // of the spheres of every mode
  std::vector<double> Surface;     // likewise

  int NumberOfModes() const { return static_cast<int>(this->Count.size()); }
  /** (sum d^3 / number)^(1/3) */
  double MeanDiameter() const;
};

/**
 * A pack that is spread over ranks: the spheres of one rank, and the totals. No rank ever holds
 * more of the pack than its share and the surroundings it asks for (PairNeighbourhood).
 */
struct PackShare : PackTotals
{
  /** The spheres of this rank, wrapped into the box along periodic axes, in canonical order. */
  SpherePack Own;
};

/**
 * Collective: shares a pack out by regions of space with about as many spheres each, from whatever
 * pieces the ranks hold. The result of anything summed over all shares does not depend on how. `Id`
 * is left behind.
 *
 * Throws std::invalid_argument, the same on every rank, for what only the whole pack can tell: a
 * periodic edge that is too narrow, two spheres with one centre, a gap in the modes.
 */
PackShare SharePack(CheckedPiece piece, Communicator& ranks);

/** The same after the checks of CheckedPiece. */
PackShare SharePack(SpherePack piece, const Window& window, bool withModes, Communicator& ranks);

/** The same for one rank that holds all of a pack with modes. */
PackShare SharePack(SpherePack pack, const Window& window);

/**
 * Collective: the whole pack on every rank, in canonical order (SortCanonically), with `Id`, or the
 * place in that order where a rank has none. For packs that are small, such as unit cells. Throws
 * as SharePack does.
 */
SpherePack GatherPack(CheckedPiece piece, Communicator& ranks);
}
