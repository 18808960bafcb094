// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Base/Estimate.h"
#include "ruc/Images/PhaseSlab.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"
#include "ruc/Statistics/Voxels/ImageLags.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace ruc
{
/** The most labels of an image whose statistics are taken. */
constexpr int MostImageLabels = 64;

/** What is counted in an image. */
struct ImageSettings
{
  int Phases; // modes from 0, the matrix last, in the numbers of PhaseSlab
  std::array<bool, 3> Periodic;
  ImageLags Lags;
  /** The pairs of phases whose S_rs(x) is kept. */
  std::vector<std::array<int, 2>> Maps;
  /** How many spectra a rank keeps, at least two; others are made again where they are needed. */
  int Spectra;
};

/** The two-point statistics of an image. */
struct ImageTwoPoint
{
  TwoPointProbability Probability;
  /** S_rs(x) of the pairs of Maps, symmetrised over x and -x: for the vectors x of at most Last
   * voxels along each axis, from -Last to Last, x running fastest. */
  std::vector<std::vector<double>> Maps;
  /** The surface of every phase per volume, in 1 / length, extrapolated to voxels of no size, and
   * as it is seen at the distance of one voxel; NaN where it is not known. */
  std::vector<double> Surface, SurfaceAtOneVoxel;
};

/**
 * Counts the pairs of voxels of the phases r and s that lie x apart, A_rs(x) = sum over y of I_r(y)
 * I_s(y + x), by Fourier transforms, and normalises them.
 *
 * Along an axis that is not periodic the image is followed by zeros, so that no pair is counted
 * across its faces. W(x) = sum over r and s of A_rs(x) are all pairs inside the image or mask, and
 * S_rs(x) = (A_rs(x) + A_rs(-x)) / 2 W(x). A transform in double precision gives A_rs to about
 * 1e-14 of the number of voxels; it is rounded to integers, so that everything is exact up to the
 * last division, and equal, bit by bit, for any number of ranks and threads.
 *
 * S_rs(r) is S_rs(0) = c_r delta_rs, the share of voxels, and at the other lags the fit of
 * FitRadial to the S_rs of the shells of ImageLags, each of which is the sum of A_rs over that of
 * W.
 *
 * The surface per volume comes from the share p(j) of the pairs j voxels apart along an axis of
 * which the first is in the phase and the second is not, in the mean over axes. With the voxel's
 * edge h, 4 p(1) / h is the surface (Crofton) less what is missed between two voxels: it is never
 * above, but for chance. (8 p(1) - 2 p(2)) / h has no term linear in h any more, which touching
 * particles make. Gaps of a part of a voxel make it too large, by up to the difference of both.
 *
 * `progress` is told the share that is done, and returns whether to go on. Throws
 * std::invalid_argument, the same on every rank, where it says no on any, where an A_rs is farther
 * than 0.1 from an integer, and where there is no voxel in any phase. Collective.
 */
ImageTwoPoint CorrelateImage(const PhaseSlab& image, const ImageSettings& settings,
  Communicator& ranks, const std::function<bool(double)>& progress = {});

/** What CorrelateImage takes of time and memory with so many ranks. */
class ImageWork
{
public:
  ImageWork(const std::array<int, 3>& dimensions, const ImageSettings& settings, int ranks);

  /** How many spectra fit into so many megabytes on every rank, all of them at the most. */
  int SpectraWithin(double megabytes) const;
  /** For so many spectra, of which two at least are needed. */
  Estimate ForSpectra(int spectra) const;

private:
  double Padded; // numbers of a transform
  double Lags;   // the share of a transform's planes that have lags
  int Phases, Maps;
  double MapVoxels, Shells;
  double MegabytesOfSpectrum, MegabytesBeside; // on every rank
};
}
