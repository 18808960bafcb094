// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Estimates/Estimates.h"

#include "ruc/Base/Vector3.h"
#include "ruc/Statistics/Sampling/FanSampling.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
constexpr double Megabyte = 1e6;

// Seconds, measured
constexpr double PerPair = 9.5e-9;       // found, and added to a histogram
constexpr double PerPairByLists = 25e-9; // handed out one by one
constexpr double PerPairOfClosedForm = 4.8e-8;
constexpr double PerPairAndLag = 0.5e-9;
constexpr double PerClassAndLag = 1.3e-6;     // histogram of a pair of types to S_rs
constexpr double PerClassAndLagOfCell = 5e-8; // on fewer knots
constexpr double PerPairAndDirection = 1.5e-9;
constexpr double PerPairDirectionAndLag = 3e-11;
constexpr double PerPairOfMap = 3.3e-7;
constexpr double PerPairAndVoxel = 2.5e-9;
constexpr double PerSphereAndBatch = 4e-8;    // projected onto the grid of lines
constexpr double PerHit = 110e-9;             // of a line by a sphere
constexpr double PerPairOfChanges = 7e-9;     // of phases on a line
constexpr double PerBatchEntry = 3.7e-9;      // a pair of phases and a lag of a batch
constexpr double PerPoint = 50e-9;            // whose phase is looked up
constexpr double PerRayHit = 3.5e-7;          // of a fan
constexpr double PerPairOfIntervals = 1.4e-9; // on two rays of a fan
constexpr double PerGridEntry = 1e-9;         // of S_rsq, a batch
constexpr double PerSphere = 1e-6;            // shared, sorted, its overlap
constexpr double PerMemberSphere = 1e-6;      // at random or deposited
constexpr double PerChildSphere = 1.4e-5;     // and freed from overlap by springs

constexpr double LeastBatches = 64.0; // of lines or throws
constexpr double MostLinesInBatch = 4096.0;
constexpr int FewestBatchesOfFans = 32;
constexpr double BytesPerSphere = 250.0;
constexpr double DirectTypes = 256; // more of them take the closed form

double Cube(double x)
{
  return x * x * x;
}

double PairsOfPhases(int modes)
{
  return 0.5 * (modes + 1) * (modes + 2);
}

// Of the pairs of an even medium in a cube of edge 1, the share closer than r <= 1
double CubePairShare(double r)
{
  return r * r * r * (4.0 / 3.0 * Pi + r * (-1.5 * Pi + r * (1.6 - r / 6.0)));
}

// Lags at which two spheres at rest overlap, one of them moved
double LagsOfPair(const PackFigures& pack, const LagGrid& lags)
{
  return std::min(4.0 * pack.MeanRadius / lags.Spacing, static_cast<double>(lags.Count));
}

// Spheres on a line of that length
double HitsOn(double length, const PackFigures& pack)
{
  return pack.Density() * Pi * pack.MeanSquareRadius * length;
}

// Pairs of phase changes on a line up to `lag` apart: two for a sphere
double PairsOfChanges(double hits, double length, double lag)
{
  const double reach = std::min(lag / length, 1.0);
  return 4.0 * hits * hits * reach * (1.0 - 0.5 * reach);
}
}

double PackFigures::PairsWithin(double distance) const
{
  const double all = 0.5 * this->Spheres * this->Spheres;
  const double volume = this->Observed.Volume();
  if (this->Observed.IsFullyPeriodic())
  {
    return all * 4.0 / 3.0 * Pi * Cube(distance) / volume;
  }
  return all * CubePairShare(std::min(distance / std::cbrt(volume), 1.0));
}

Estimate& Estimate::operator+=(const Estimate& other)
{
  this->Seconds += other.Seconds;
  this->MegabytesOfRank += other.MegabytesOfRank;
  this->MegabytesOfAll += other.MegabytesOfAll;
  return *this;
}

Estimate EstimatePack(const PackFigures& pack)
{
  return { pack.Spheres * PerSphere, 0.0, pack.Spheres * BytesPerSphere / Megabyte };
}

Estimate EstimatePairSum(const PackFigures& pack, const LagGrid& lags)
{
  const double pairs = pack.PairsWithin(lags.Maximum() + 2.0 * pack.LargestRadius);
  const double classes = 0.5 * pack.Types * (pack.Types + 1.0);
  if (pack.Types > DirectTypes)
  {
    return { pairs * (PerPairOfClosedForm + LagsOfPair(pack, lags) * PerPairAndLag),
      16.0 * PairsOfPhases(pack.Modes) * lags.Count / Megabyte, 0.0 };
  }
  return { pairs * PerPair + classes * lags.Count * PerClassAndLag,
    64.0 * classes * lags.Count / Megabyte, 0.0 };
}

Estimate EstimatePairSumAlong(const PackFigures& pack, const LagGrid& lags, int directions)
{
  const double pairs = pack.PairsWithin(lags.Maximum() + 2.0 * pack.LargestRadius);
  return { pairs *
      (PerPairByLists +
        directions * (PerPairAndDirection + LagsOfPair(pack, lags) * PerPairDirectionAndLag)),
    24.0 * directions * PairsOfPhases(pack.Modes) * lags.Count / Megabyte, 0.0 };
}

Estimate EstimateMap(const PackFigures& pack, double reach, int pairs, int resolution)
{
  const double spacing = reach / resolution, contact = 2.0 * pack.MeanRadius;
  const double voxels = 4.0 / 3.0 * Pi * Cube(contact / spacing); // of a pair
  // As many pairs as in a ball of the cube's volume
  return { pack.PairsWithin(1.24 * (reach + contact)) * (PerPairOfMap + voxels * PerPairAndVoxel),
    24.0 * pairs * Cube(2.0 * resolution + 1.0) / Megabyte, 0.0 };
}

Estimate EstimateRadialDistribution(const PackFigures& pack, const LagGrid& lags)
{
  return { pack.PairsWithin(lags.Maximum()) * PerPairByLists, 0.0, 0.0 };
}

Estimate EstimateChords(const PackFigures& pack, const LagGrid& lags, double lines)
{
  // The mean chord of a cube, 4 volumes over the surface; and a periodic line with its last lag
  const double edge = std::cbrt(pack.Observed.Volume());
  const double length = pack.Observed.IsFullyPeriodic() ? edge + lags.Maximum() : 2.0 / 3.0 * edge;
  const double hits = HitsOn(length, pack);
  const double ordered = (pack.Modes + 1.0) * (pack.Modes + 1.0);
  // As many lines in a batch as spheres lie side by side
  const double ofBatch = std::clamp(1.8 * std::pow(pack.Spheres, 2.0 / 3.0), 1.0, MostLinesInBatch);
  const double batches = std::max(lines / ofBatch, LeastBatches);
  return { lines *
        (hits * PerHit + PairsOfChanges(hits, length, lags.Maximum()) * PerPairOfChanges) +
      batches * (pack.Spheres * PerSphereAndBatch + ordered * lags.Count * PerBatchEntry),
    100.0 * ordered * lags.Count / Megabyte + 10.0, 0.0 };
}

Estimate EstimateTemplate(const PackFigures& pack, const LagGrid& lags, double throws)
{
  constexpr double Rays = 20.0;
  const double ordered = (pack.Modes + 1.0) * (pack.Modes + 1.0);
  return { throws * Rays * lags.Count * PerPoint +
      LeastBatches * ordered * lags.Count * PerBatchEntry,
    100.0 * ordered * lags.Count / Megabyte + 10.0, 0.0 };
}

Estimate EstimateFans(const PackFigures& pack, const ThreePointGrid& grid, std::size_t triples,
  bool withErrors, double throws)
{
  const double rays = grid.Directions;
  const double hits = HitsOn(grid.Lags.Maximum(), pack);
  // Intervals of a phase on a ray; the rays of a pair at every angle once
  const double intervals = hits + 1.0;
  const double ofThrow = rays * hits * PerRayHit +
    static_cast<double>(triples) * 0.5 * rays * rays * intervals * intervals * PerPairOfIntervals;
  const double tables = static_cast<double>(grid.Size()) * (triples + 1.0);
  return { throws * ofThrow + FewestBatchesOfFans * tables * PerGridEntry,
    EstimateFanMemory(grid, triples, withErrors, true) / Megabyte,
    8.0 * static_cast<double>(grid.Size()) * triples * (withErrors ? 2 : 1) / Megabyte };
}

double EstimateEvaluation(const CellFigures& cell, const LagGrid& lags, bool withGradient)
{
  const double pairs = 0.5 * cell.Spheres * cell.Density * 4.0 / 3.0 * Pi *
    Cube(lags.Maximum() + 2.0 * cell.LargestRadius);
  const double classes = 0.5 * cell.Modes * (cell.Modes + 1.0);
  return (pairs * PerPair + classes * lags.Count * PerClassAndLagOfCell) *
    (withGradient ? 2.0 : 1.0);
}

Estimate EstimateGradientSearch(const CellFigures& cell, const LagGrid& lags, int iterations)
{
  return { cell.Spheres * PerMemberSphere +
      (iterations + 1.0) * EstimateEvaluation(cell, lags, true),
    cell.Spheres * 1000.0 / Megabyte, 0.0 };
}

Estimate EstimatePopulationSearch(
  const CellFigures& cell, const LagGrid& lags, const PopulationSettings& settings)
{
  const double evaluation = EstimateEvaluation(cell, lags, false);
  const double member = cell.Spheres * PerMemberSphere + evaluation;
  const double child = cell.Spheres * PerChildSphere + evaluation;
  const double descent = settings.RefinementSteps * EstimateEvaluation(cell, lags, true);
  const double children = settings.RefinementSteps > 0 ? 0.0 : settings.MatingPool;
  return { settings.Population * member +
      static_cast<double>(settings.MaximumGenerations) * (children * child + descent),
    settings.Population * cell.Spheres * 24.0 / Megabyte, 0.0 };
}
}
