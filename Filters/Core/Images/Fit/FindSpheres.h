// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Estimate.h"
#include "ruc/Images/Fit/SphereFit.h"
#include "ruc/Images/Fit/TwoPhases.h"

#include <functional>
#include <string>
#include <vector>

namespace ruc
{
/** How spheres are looked for. Lengths are in mean edges of a voxel. */
struct SphereSearch : PhaseSearch
{
  Vector3 Edges = { 1.0, 1.0, 1.0 }; // of a voxel, in their mean
  double LeastDiameter = 3.0;        // of a particle
  double OverlapTolerance = 0.2;     // the share of its diameter by which a particle may overlap
  /** Whether the window is the image less the largest radius, so that its spheres are whole. */
  bool WholeOnly = false;
};

/** Why a candidate is no particle. */
enum class DropReason
{
  LowContrast, // it is less than half as much above the matrix as particles are, or not ten
               // standard errors
  Small,       // its diameter is below LeastDiameter
  Overlaps,    // it overlaps a larger one by more than OverlapTolerance
  Outside,     // its centre lies outside the image
  NearBorder   // with WholeOnly, its centre is nearer to the border than the largest radius
};
constexpr int CountOf(DropReason)
{
  return 5;
}
/** The reason in words. */
const char* NameOf(DropReason reason);

struct DroppedBall
{
  FittedBall Ball;
  DropReason Reason;

  /** Whether it is a particle of which only the place is wrong. */
  bool IsParticle() const
  {
    return this->Reason == DropReason::Outside || this->Reason == DropReason::NearBorder;
  }
};

struct FoundSpheres : TwoPhases
{
  std::vector<FittedBall> Balls; // in the order of z, y, x
  std::vector<DroppedBall> Dropped;
  GreyModel Model;
  double Margin = 0.0; // from the image to the window: the largest radius with WholeOnly
  int Sweeps = 0;
  bool Stopped = false; // before the fit had come to its end
};

/**
 * Finds the spheres in an image whose particles are brighter than the matrix: candidates are the
 * maxima of the distance to the nearest voxel at or below the threshold; SphereFit fits them to the
 * grey values; maxima of what is left, smoothed, above half the contrast are candidates too, in up
 * to three rounds. Then those are dropped for which there is a DropReason.
 *
 * With `starts` these are the candidates, and no others are looked for. The image comes back
 * without the halo that it may have got. `progress` is told what is done and the share of it, and
 * returns whether to go on; where it does not on any rank, the fit is as far as it has come.
 *
 * Throws std::invalid_argument, the same on every rank, for an image of one value, for a threshold
 * that is not between its values, and where there is no particle. Collective.
 */
FoundSpheres FindSpheres(VoxelSlab<float>& image, const SphereSearch& search,
  const std::vector<Ball>& starts, Communicator& ranks,
  const std::function<bool(double, const std::string&)>& progress = {});

/**
 * What it takes to find spheres in an image of that size on so many ranks: some 8e-7 s and 16 bytes
 * a voxel.
 */
Estimate EstimateSpheres(const std::array<int, 3>& dimensions, int ranks);

/** Returns what is left of the image, without halo, when the balls are taken from it. */
VoxelSlab<float> ResidualOf(VoxelSlab<float> image, const FoundSpheres& found, Communicator& ranks);
}
