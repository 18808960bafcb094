// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/PairSums/PairSumErrors.h"
#include "ruc/Statistics/Results/Jackknife.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ruc
{
/** What a descriptor tells of, and so what term of a search fits it. */
enum class DescriptorKind
{
  Fraction, // and surface: what the spheres of a cell are
  TwoPoint,
  Gaps,
  Pores,
  Chords,
  Order,
  ThirdOrder
};
/** The number of kinds. */
constexpr int CountOf(DescriptorKind)
{
  return 7;
}

/** One figure of a pack, with its standard error as a sample of its medium, or NaN. */
struct Descriptor
{
  std::string Name;
  DescriptorKind Kind;
  ValueWithError Value;
};

/**
 * How the figures of a pack and of cells are measured. The lengths are those of the pack, so that
 * cells are measured in the same way.
 */
struct DescriptorSettings
{
  LagGrid Lags{};            // of S_rs
  double MeanDiameter = 0.0; // the volume mean of the pack
  int Blocks = 64;           // for the standard errors, from 8 to 1000
};

/**
 * The figures of a pack or a cell:
 *
 * - c_1, ... c_m and `Surface`, the surface of the spheres over the volume, in 1 / length;
 * - `Neighbours 2 %`, `5 %` and `10 %`: the mean number of spheres around one with a gap d / (a +
 * b)
 *   - 1 up to that, where each pair weighs V / gamma(d) as in S_rs; and `Nearest gap`, the mean
 *   distance to the nearest surface (NeighbourStatistics);
 * - `Q6` and `Faces`, means over the radical cells (NeighbourStatistics);
 * - `Pore mean`, the mean distance from points of the matrix to the nearest surface, `Pores > D/8`
 *   and `> D/4`, their shares farther than a part of the mean diameter D (VoidDistances);
 * - `Chord` and `Lineal path D/4`, `D/2` and `D` of the matrix: the mean chord and the probability
 *   that a segment of that length lies in the matrix (ChordLengths);
 * - `zeta` and `eta` of the spheres (ThirdOrderOfSpheres).
 *
 * A window is sampled at a margin from its faces. Figures that a method refuses to tell, as where
 * no sphere is far enough from the faces, or of spheres that overlap, are left out.
 */
struct PackDescriptors
{
  std::vector<Descriptor> Values;
  std::vector<std::string> LeftOut; // why figures are, in whole sentences
  TwoPointProbability Sums{ 1, { 1.0, 1 } };
  std::optional<TwoPointErrors> Errors; // of a pack
};

/** Tells the share that is done, and of what. */
using DescriptorProgress = std::function<void(double done, const std::string& what)>;

/**
 * Measures a pack, with its own errors by blocks, or (`isCell`) a cell, which needs no room for
 * blocks; its errors are then those of the methods that tell them, else NaN. The result is equal,
 * bit by bit, for any number of ranks and threads. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, for lags that SumPairs refuses, and for a
 * pack without room for blocks (FindPairSumErrors).
 */
PackDescriptors MeasureDescriptors(const PackShare& share, const DescriptorSettings& settings,
  bool isCell, Communicator& ranks, const DescriptorProgress& progress = {});
}
