// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Images/SphereFractions.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <vector>

namespace ruc
{
/** What voxels are told of the spheres. */
struct LabelSettings
{
  bool Phases = true;
  bool ParticleIds = false;
  bool Fractions = false; // of all particles together
  bool EveryMode = false; // with Fractions, also of every mode and of the matrix
  FractionMethod Method = FractionMethod::Exact;
  int SamplesPerAxis = 4; // for FractionMethod::Supersampled, 1 to MostSamplesPerAxis

  /** The number of arrays of fractions for a pack of so many modes. */
  int FractionArrays(int modes) const
  {
    return !this->Fractions ? 0 : this->EveryMode ? modes + 2 : 1;
  }
};
constexpr int MostSamplesPerAxis = 64;
constexpr int MostLabelledModes = 255;

/** Where the voxels of a block are written to, x running fastest; null where nothing is wanted. */
struct LabelArrays
{
  std::uint8_t* Phase = nullptr;
  std::int32_t* ParticleId = nullptr;
  /** As many as FractionArrays: that of all particles; with EveryMode modes 1…N_p and the matrix.
   */
  std::vector<float*> Fractions;
};

/** Throws std::invalid_argument unless a pack of so many modes can be labelled with the settings.
 */
void ValidateLabels(const LabelSettings& settings, int modes);

/**
 * Returns by how much the Ids of a pack must be raised for the lowest to be 1 or more, as 0 is for
 * the matrix. Throws std::invalid_argument, the same on every rank, where a rank's piece has
 * spheres without Id, and where 32 bits do not hold the raised ones. Collective.
 */
std::int64_t FindRaise(const SpherePack& piece, Communicator& ranks);

/** Returns how many spheres of all ranks have the Id of another one, but for the first of each Id.
 * Collective. */
std::int64_t CountRepeatedIds(const SpherePack& piece, Communicator& ranks);

/**
 * Returns the spheres that reach this rank's block of voxels, with those of their images along
 * periodic axes that do, from the pieces of a pack that the ranks hold. They come in the order in
 * which they take a voxel: by mode, then by Id, then by place. The Ids of all spheres are raised by
 * `raised`. Collective.
 */
SpherePack SpheresOfBlock(const SpherePack& piece, const Window& window, const VoxelGrid& grid,
  const VoxelBlock& block, std::int64_t raised, Communicator& ranks);

/**
 * Labels the voxels of a block. The phase of a voxel is that of its centre: 0 for the matrix, else
 * the mode of the sphere that holds it, its surface included; in overlaps the lowest mode has it,
 * then the lowest Id. So has ParticleId, which is 0 for the matrix. Fractions are shares of the
 * voxel's volume; those of spheres that overlap add up, to 1 at most.
 *
 * A voxel's labels depend on the pack and the grid alone. So they are equal, bit by bit, for any
 * number of ranks and threads, and however the grid is cut into blocks.
 */
class LabelImage
{
public:
  /** `spheres` are those of SpheresOfBlock, with modes of which the highest in the pack is `modes`.
   */
  LabelImage(const VoxelGrid& grid, const VoxelBlock& block, SpherePack spheres, int modes,
    const LabelSettings& settings);

  /** Fills the planes of voxels of one of `steps` steps, which together are the whole block. */
  void Fill(int step, int steps, const LabelArrays& arrays) const;

private:
  void FillPlanes(const VoxelRange& planes, const LabelArrays& arrays) const;
  void Clear(const VoxelRange& planes, const LabelArrays& arrays) const;
  /** Marks the voxels with centres in a sphere that have no label yet. */
  template <class Label>
  void Mark(std::size_t sphere, const VoxelRange& planes, Label label, Label* labels) const;
  /** Limits sums of fractions to 1, and finds what is left to the matrix. */
  void Complete(const VoxelRange& planes, const LabelArrays& arrays) const;

  VoxelGrid Grid;
  VoxelBlock Block;
  SpherePack Spheres;
  int Modes;
  LabelSettings Settings;
};

/**
 * Returns the number of steps for LabelImage::Fill with which a run is often heard of without
 * cutting many spheres. It is the same on all ranks.
 */
int StepsOfLabels(const VoxelGrid& grid, double largestRadius);

/** What it takes to label the voxels of a grid that is spread over the ranks. */
Estimate EstimateLabels(
  const PackFigures& pack, const VoxelGrid& grid, const LabelSettings& settings);
/** The megabytes of the labels of so many voxels. */
double MegabytesOfLabels(double voxels, int modes, const LabelSettings& settings);
}
