// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Reconstruction/Population/PopulationSettings.h"
#include "ruc/Statistics/Results/LagGrid.h"
#include "ruc/Statistics/ThirdOrder/ThreePointGrid.h"
#include "ruc/Window/Window.h"

#include <cstddef>
#include <string>

/**
 * @file
 * What the work on a pack will take, from a few figures of it and without doing any: the number of
 * pairs, points or spheres on a line times the seconds that one takes on a core of a virtual AMD
 * EPYC of 2023. Good to a factor of three where the pack is even, which is enough to tell a minute
 * from a day; `Testing/Benchmark/run` prints estimated over measured.
 */
namespace ruc
{
/** What estimates have to know of a pack. */
struct PackFigures
{
  double Spheres = 0.0;
  Window Observed; // of the centres
  double MeanRadius = 0.0;
  double MeanSquareRadius = 0.0;
  double LargestRadius = 0.0;
  double MeanDiameter = 0.0; // volume mean
  int Modes = 1;
  int Types = 1; // of spheres: mode and radius

  double Density() const { return this->Spheres / this->Observed.Volume(); }
  /** Of centres up to `distance` apart; periodic images count. In a window that of a cube of the
   * same volume, up to its edge. */
  double PairsWithin(double distance) const;
};

struct Estimate
{
  double Seconds = 0.0;         // of one core
  double MegabytesOfRank = 0.0; // of every rank
  double MegabytesOfAll = 0.0;  // shared by the ranks
  std::string Automatic = {};   // what 0 stands for in settings that are then automatic, in words

  Estimate& operator+=(const Estimate& other);
};

/** A pack spread over the ranks, and its overlap. */
Estimate EstimatePack(const PackFigures& pack);

/** SumPairs. */
Estimate EstimatePairSum(const PackFigures& pack, const LagGrid& lags);
/** SumPairsAlong. */
Estimate EstimatePairSumAlong(const PackFigures& pack, const LagGrid& lags, int directions);
/** MapPairs of `pairs` pairs of phases, to `resolution` voxels from the centre, which reach
 * `reach`. */
Estimate EstimateMap(const PackFigures& pack, double reach, int pairs, int resolution);
/** MeasureRadialDistribution. */
Estimate EstimateRadialDistribution(const PackFigures& pack, const LagGrid& lags);
/** SampleChords. */
Estimate EstimateChords(const PackFigures& pack, const LagGrid& lags, double lines);
/** SampleTemplate. */
Estimate EstimateTemplate(const PackFigures& pack, const LagGrid& lags, double throws);
/** SampleFans; its memory with a border. */
Estimate EstimateFans(const PackFigures& pack, const ThreePointGrid& grid, std::size_t triples,
  bool withErrors, double throws);

/** What the search for a cell has to know of it. */
struct CellFigures
{
  double Spheres = 0.0;
  double Density = 0.0; // spheres per volume
  double LargestRadius = 0.0;
  int Modes = 1;
};

/** One evaluation of the objective. */
double EstimateEvaluation(const CellFigures& cell, const LagGrid& lags, bool withGradient);
/** SearchByGradient, to its last iteration. */
Estimate EstimateGradientSearch(const CellFigures& cell, const LagGrid& lags, int iterations);
/** SearchByPopulation, to its last generation; of the hybrid with descents all along. */
Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings);
}
