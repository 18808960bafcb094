// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Particles/PairNeighbourhood.h"
#include "ruc/Statistics/Neighbours/SurfaceDistances.h"

#include <cstddef>
#include <vector>

namespace ruc
{
/**
 * How wide pores are near the points of a lattice. The widest way through a throat between three
 * spheres is the curve on which they are equally far; a point of a lattice beside it is nearer to
 * one of them, by up to its spacing. So a point is moved onto that curve, across it and by no more
 * than half the diagonal of a voxel, and takes the distance from there.
 */
class PoreThroats
{
public:
  /** Points farther than `widest` from every sphere stay where they are. Collective. */
  PoreThroats(
    const PackShare& share, const PointLattice& lattice, double widest, Communicator& ranks);

  /**
   * Returns the distances of the planes from `first` on, `nearest`, raised where points are moved.
   * `own` are those that this rank alone finds. Collective.
   */
  std::vector<double> Raise(const SurfaceDistances& own, const std::vector<double>& nearest,
    int first, Communicator& ranks) const;

private:
  struct Around;
  // The distance near a point, which is relative to the centre of its nearest sphere
  double RaiseOne(const Vector3& point, double distance, const std::vector<Around>& around) const;
  void Gather(std::size_t sphere, std::vector<Around>& around) const;
  Vector3 FromCentre(const Vector3& point, std::size_t sphere) const;

  const PackShare& Share;
  PointLattice Lattice;
  double Widest, Farthest; // the latter is how far a point may be moved
  Surroundings Spheres;
  std::vector<std::size_t> SortedPlace; // of every sphere of the share
};
}
