// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Images/VoxelGrid.h"

#include <array>
#include <utility>
#include <vector>

namespace ruc
{
/** How the share that a sphere has of a voxel is found. */
enum class FractionMethod
{
  Exact,       // by the closed form of BallInBox
  Supersampled // as the share of points in the sphere, of as many along each axis, evenly spaced
};
constexpr int CountOf(FractionMethod)
{
  return 2;
}

/**
 * Returns the voxels along an axis, first to last - 1, that a sphere reaches of those from `first`
 * to `last` - 1. `centre` is measured from the lower face of voxel 0.
 */
std::pair<int, int> VoxelsReached(
  double centre, double radius, double spacing, int first, int last);

/**
 * Adds the shares that spheres have of voxels. The corners of the voxels that a sphere reaches are
 * evaluated once each, plane by plane, from wedges of which each pair of coordinates has one; so an
 * object keeps tables, and every thread has one of its own. A voxel's share of a sphere depends on
 * sphere and voxel alone, and not on what else is filled.
 */
class SphereFractions
{
public:
  /** `samplesPerAxis` counts for Supersampled alone. */
  SphereFractions(const VoxelGrid& grid, FractionMethod method, int samplesPerAxis);

  /**
   * Adds the shares of a sphere to those voxels of `block` that lie in the planes `planes`.
   * `values` has a number for each voxel of the block, x running fastest.
   */
  void Add(const Vector3& centre, double radius, const VoxelBlock& block, const VoxelRange& planes,
    float* values);

private:
  /** What is known along an axis. */
  struct Axis
  {
    int First = 0, Count = 0;         // voxels
    std::vector<double> Corner;       // the coordinates of their faces, from the sphere's centre
    std::vector<double> Near, Far;    // the squares of each voxel's least and greatest
    std::vector<double> Cap;          // BallWedge(|corner|, 0)
    std::vector<double> SampleSquare; // of the coordinates of samples, voxel by voxel
  };

  void SetAxis(int q, double centre, double radius, int first, int last);
  void SetWedges(int p, int q, double radius, std::vector<double>& wedges) const;
  /** Finds the differences along x and y of the corners' volumes in the plane of corners `k`. */
  void FindPlane(int k, double radius, std::vector<double>& differences);
  void AddExact(double radius, const VoxelBlock& block, float* values);
  void AddSampled(double radius, const VoxelBlock& block, float* values);
  /** Returns the number of samples of a voxel in the sphere; voxels count from the sphere's first.
   */
  int CountSamples(int i, int j, int k, double square) const;
  float* RowOf(const VoxelBlock& block, int j, int k, float* values) const;

  VoxelGrid Grid;
  FractionMethod Method;
  int Samples;
  std::array<Axis, 3> Axes;
  std::vector<double> WedgesXY, WedgesXZ,
    WedgesYZ; // of pairs of corners, the first running fastest
  std::vector<double> Before, After, Row;
};
}
