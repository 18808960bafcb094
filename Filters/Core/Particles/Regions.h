// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SpherePack.h"

#include <vector>

namespace ruc
{
/**
 * Divides space into one region for each rank, with about as many spheres in each, by recursive
 * bisection across the longest extent. It goes by a sample of the centres (some 65 000 in all), so
 * that no rank sees more of the pack than that.
 */
class RegionTree
{
public:
  /** Collective. `piece` is this rank's part of a pack of `total` spheres. */
  RegionTree(const SpherePack& piece, std::int64_t total, Communicator& ranks);

  /** Returns the rank to whose region a point belongs. It is the same on every rank. */
  int OwnerOf(const Vector3& point) const;

private:
  struct Node
  {
    int Axis;
    double Cut;       // points below it belong to the lower child
    int Lower, Upper; // children: nodes, or -1 - rank
  };
  // Divides the points among the ranks first to last - 1; returns the node, or -1 - rank
  int Divide(
    std::vector<Vector3>::iterator begin, std::vector<Vector3>::iterator end, int first, int last);

  int Root;
  std::vector<Node> Nodes;
};
}
