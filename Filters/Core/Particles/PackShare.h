// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/CheckedPiece.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/** What every rank knows about a pack that is spread over ranks. It is the same on all of them. */
struct PackTotals
{
  Window Observed; // in which the centres lie
  std::int64_t NumberOfSpheres = 0;
  double LargestRadius = 0.0;
  // For every mode the number of its spheres, their volume and their surface area. A pack without
  // modes counts as one mode.
  std::vector<std::int64_t> Count;
  std::vector<double> Volume;
  std::vector<double> Surface;

  int NumberOfModes() const { return static_cast<int>(this->Count.size()); }
  /** The volume mean diameter of all spheres, (sum d^3 / number)^(1/3). */
  double MeanDiameter() const;
};

/**
 * A pack that is spread over ranks: the spheres of one rank, and the totals. No rank ever holds
 * more of the pack than its share and the surroundings that it asks for (PairNeighbourhood).
 */
struct PackShare : PackTotals
{
  /**
   * The spheres of this rank, wrapped into the box along periodic axes and in canonical order
   * (SortCanonically).
   */
  SpherePack Own;
};

/**
 * Shares a pack out by regions of space that hold about as many spheres each, from whatever pieces
 * the ranks hold. `Id` is dropped. What is summed up in integers over all shares does not depend on
 * how the pack was shared. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for faults that only the whole pack can
 * show: a periodic edge that is too narrow, two spheres with one centre, or a gap in the modes.
 */
PackShare SharePack(CheckedPiece piece, Communicator& ranks);

/** Does the checks of CheckedPiece first. */
PackShare SharePack(SpherePack piece, const Window& window, bool withModes, Communicator& ranks);

/** The same for one rank that holds the whole pack, which has modes. */
PackShare SharePack(SpherePack pack, const Window& window);

/**
 * Returns the whole pack on every rank, in canonical order (SortCanonically). Where any rank has no
 * `Id`, all ids are the places in that order. It is meant for small packs, such as unit cells.
 * Collective; throws as SharePack does.
 */
SpherePack GatherPack(CheckedPiece piece, Communicator& ranks);
}
