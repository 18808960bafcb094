// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Images/Fit/FindSpheres.h"
#include "ruc/Images/Fit/ParticleLabels.h"

#include <functional>
#include <string>
#include <vector>

namespace ruc
{
/** How an image is cut into particles. Lengths are in mean edges of a voxel. */
struct ParticleSearch : PhaseSearch
{
  Vector3 Edges = { 1.0, 1.0, 1.0 }; // of a voxel, in their mean
  double MarkerHeight = 0.5;         // in voxels, of FindBasins
  double LeastDiameter = 3.0;        // of a ball with the volume of a particle
  /** Whether the window is the image less the farthest that a whole particle reaches from its
   * centre, so that its particles are whole. */
  bool WholeOnly = false;
};

/** The particles of an image, of any shape. */
struct CutParticles : TwoPhases
{
  std::vector<ParticleShape> Shapes;
  std::vector<std::int32_t> Labels; // of the shapes: the numbers of their basins, or labels
  /** Of each voxel its particle, from 1; 0 in the matrix; NotKept in particles that are not among
   * them. */
  VoxelSlab<std::int32_t> Number;
  static constexpr std::int32_t NotKept = -1;
  struct Dropped
  {
    ParticleShape Shape;
    DropReason Reason; // Small or NearBorder
  };
  std::vector<Dropped> Others;
  double Margin = 0.0;  // from the image to the window
  bool Stopped = false; // before any were found
};

/**
 * Cuts an image whose particles are brighter than the matrix into particles: they are the basins of
 * the distance to the nearest voxel at or below the threshold, in the image as it is smoothed. The
 * image comes without a halo. `progress` is told what is done and the share of it, and returns
 * whether to go on.
 *
 * Throws std::invalid_argument, the same on every rank, where FindPhases does, and where there is
 * no particle. Collective.
 */
CutParticles CutImage(VoxelSlab<float> image, const ParticleSearch& search, Communicator& ranks,
  const std::function<bool(double, const std::string&)>& progress = {});

/**
 * Takes the labels 1 to `count` of an image for its particles, without a cut. Of the search the
 * edges, the least diameter and WholeOnly count. Throws std::invalid_argument, the same on every
 * rank, where there are none. Collective.
 */
CutParticles TakeLabels(VoxelSlab<std::int32_t> labels, std::int32_t count,
  const ParticleSearch& search, Communicator& ranks);

/** What it takes to cut an image of that size on so many ranks. */
Estimate EstimateCut(const std::array<int, 3>& dimensions, int ranks);
}
