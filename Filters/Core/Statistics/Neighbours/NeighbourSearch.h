// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Statistics/Neighbours/NeighbourStatistics.h"
#include "ruc/Statistics/Results/SpaceBlocks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ruc
{
/** How many neighbours there are by block, pair of modes, and step of the gap. */
struct GapCounts
{
  GapCounts(int blocks, int modes, const NeighbourSettings& settings);

  /** The gap that is step k. */
  double GapAt(int k) const { return k * this->Step; }
  /** Adds a neighbour of that gap, if it is at most MaximumGap, to the first step that holds it. */
  void Add(int block, int mode, int ofMode, double gap, std::vector<std::int64_t>& counts) const;
  std::size_t PlaceOf(int block, int mode, int ofMode) const
  {
    return ((static_cast<std::size_t>(block) * this->Modes + mode) * this->Modes + ofMode) *
      (this->Steps + 1);
  }
  std::size_t Size() const { return this->PlaceOf(this->Blocks, 0, 0); }

  int Blocks, Modes, Steps;
  double Step;
};

/** A contact of a sphere of the share; a pair is met from both its spheres. */
struct KnownContact
{
  std::uint32_t Sphere; // its place in the share
  std::int64_t Other;   // that of the other one, or -1 - its place among the foreign centres
  Vector3 Offset;
  double Gap;
  int OtherMode;
  bool Tells; // whether the contact is told from this side
};

/** What a rank finds around the spheres of its share. */
struct FoundNeighbours
{
  std::vector<NeighbourStatistics::Sphere> Spheres; // without rattlers
  std::vector<KnownContact> Contacts; // in the order of the first sphere's sorted place
  std::vector<Vector3> Foreign;       // centres that are no own ones, or images of these
  std::vector<std::int64_t> Counts;   // GapCounts, of all ranks
};

/** Collective. */
FoundNeighbours FindNeighbours(const PackShare& share, const CountedCentres& centres,
  const NeighbourSettings& settings, const SpaceBlocks& blocks, const GapCounts& layout,
  Communicator& ranks, const std::function<void(double)>& progress);

/**
 * Marks the rattlers, and returns for every sphere of the share the number of its contacts with
 * spheres that are none. Collective.
 */
std::vector<int> FindRattlers(const PackShare& share, FoundNeighbours& found, Communicator& ranks);
}
