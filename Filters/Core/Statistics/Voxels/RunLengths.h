// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Images/PhaseSlab.h"
#include "ruc/Statistics/Sampling/ChordLengths.h"
#include "ruc/Statistics/Voxels/ImageLags.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ruc
{
/** The runs of equal phases along the voxels of all lines of an image along one axis. */
struct RunCounts
{
  /** The number of runs of every length, 0 first: for every phase, cut runs included. */
  std::vector<std::vector<std::int64_t>> Runs;
  /** The same of runs whose both ends are in the image: another phase is beside them. */
  std::vector<std::vector<std::int64_t>> Chords;
  /** The same of runs of voxels of any phase, between faces of the image and voxels outside. */
  std::vector<std::int64_t> Inside;
  /** The number of voxels on periodic lines that have one phase all along, for every phase, and on
   * those that are inside all along. */
  std::vector<std::int64_t> Endless;
  std::int64_t EndlessInside = 0;
  /** The number of places where a run of each phase begins beside another phase. */
  std::vector<std::int64_t> Starts;
};

/**
 * Counts the runs along the axes x, y, z of an image that is cut across z, the same on every rank.
 * Collective.
 */
std::array<RunCounts, 3> CountRuns(
  const PhaseSlab& image, int phases, const std::array<bool, 3>& periodic, Communicator& ranks);

/**
 * Returns the chord-length and lineal-path functions at the lags k `edge`, k = 0 … `count`, from
 * the runs along the three axes, with the definitions of ChordLengths: a chord of n voxels of edge
 * h has the length n h. Cut runs count in LinealPath only. Where edges of voxels are not the lag's
 * step, both are interpolated. There are no errors, which are not known for one image. MeanChord is
 * 4 c_r / `surface` of the phase.
 */
ChordLengths ChordsOfRuns(const std::array<RunCounts, 3>& runs, const Vector3& spacing, double edge,
  int count, const std::vector<double>& fractions, const std::vector<double>& surface);
}
