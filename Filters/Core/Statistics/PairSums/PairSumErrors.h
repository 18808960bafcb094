// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/PackFigures.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/OneMedium.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <string>
#include <vector>

namespace ruc
{
/**
 * The standard errors of S_rs as a sum over the pairs of one pack: how far another pack of the same
 * size and process would be from the medium. They are absolute probabilities.
 */
struct TwoPointErrors
{
  int Blocks = 0;
  std::vector<std::vector<double>> Values; // in the layout of TwoPointProbability::Values
  std::vector<double> Fractions;           // of c_r, the matrix last
  double Surface = 0.0;                    // of the surface of the spheres over the volume
  std::vector<LayerTest> Layers;           // whether the pack is one medium
};

/**
 * Returns the standard errors of `sums`, which are those of SumPairs for the same share, by the
 * scatter of about so many blocks of the pack (TaperedBlocks) with edges of at least two mean
 * diameters.
 *
 * The part of a block in S_rs(r) V is half the overlap of each pair for each of its spheres, times
 * the weight of the block where that sphere lies. Two points that are far apart tell of two places:
 * what the mean over directions has blurred of the fractions is put where it belongs, and beyond
 * two mean diameters the part of a block is c_s V_r + c_r V_s alone, with the volumes V of its
 * spheres. (Without that, errors at long lags would be too small by a factor of up to two.)
 *
 * The spheres of a mode count by their volume, and distances in steps of a quarter of a radius,
 * which changes errors by much less than a hundredth.
 *
 * The result is equal, bit by bit, on every rank and for any number of ranks and threads.
 * Collective. Throws std::invalid_argument, the same on every rank, in the name of `property`: for
 * fewer than eight blocks or more than 1000, a window without room for eight, and so many modes
 * that the sums take more than 5e7 numbers.
 */
TwoPointErrors FindPairSumErrors(const PackShare& share, const TwoPointProbability& sums,
  int blocks, Communicator& ranks, const char* property = "Blocks");

/**
 * Returns the objective floor, the sum over all ordered pairs of phases of the discrete norm of the
 * errors: about the F2 (TwoPointDifference) between this pack and the medium that it is a sample
 * of. Another pack of its size lies sqrt(2) higher.
 */
double ObjectiveFloor(const TwoPointProbability& sums, const TwoPointErrors& errors);

/**
 * Says whether S_m_m at the last lag differs from c_m squared by more than 3 % and three standard
 * errors, as where the window holds layers near walls; an empty text if not.
 */
std::string DescribeWalls(const TwoPointProbability& sums, const TwoPointErrors& errors);

/** What FindPairSumErrors takes. */
Estimate EstimatePairSumErrors(const PackFigures& pack, const LagGrid& lags, int blocks);
}
