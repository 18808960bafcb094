// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/CellObjective.h"

#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/PairLoops.h"

#include <omp.h>

#include <algorithm>
#include <cmath>

namespace ruc
{
namespace
{
// Chunks are small, so that ranks and threads get equal shares of a small cell
constexpr std::size_t ChunkOfCentres = 8;

std::vector<SphereType> CellTypes(const std::vector<double>& radii, const std::vector<int>& modes)
{
  std::vector<SphereType> types;
  for (std::size_t t = 0; t < radii.size(); ++t)
  {
    types.push_back({ modes.empty() ? static_cast<int>(t) + 1 : modes[t], radii[t] });
  }
  return types;
}

// The type of every sphere, in their order
std::vector<std::int32_t> TypesOfSpheres(const std::vector<int>& count)
{
  std::vector<std::int32_t> types;
  for (std::size_t t = 0; t < count.size(); ++t)
  {
    types.insert(types.end(), count[t], static_cast<std::int32_t>(t));
  }
  return types;
}

// Runs pass(begin, end, sums) over this rank's chunks of centres on all threads, and adds the sums
// of all threads up
template <class Pass>
void OverChunks(
  const Communicator& ranks, std::size_t centres, std::vector<std::int64_t>& sums, Pass&& pass)
{
  const std::int64_t chunks =
    static_cast<std::int64_t>((centres + ChunkOfCentres - 1) / ChunkOfCentres);
#pragma omp parallel
  {
    // A thread by itself adds to the sums directly
    const bool alone = omp_get_num_threads() == 1;
    std::vector<std::int64_t> own(alone ? 0 : sums.size(), 0);
    std::int64_t* target = alone ? sums.data() : own.data();
#pragma omp for schedule(dynamic) nowait
    for (std::int64_t chunk = ranks.Rank(); chunk < chunks; chunk += ranks.Size())
    {
      pass(chunk * ChunkOfCentres, std::min((chunk + 1) * ChunkOfCentres, centres), target);
    }
#pragma omp critical
    std::transform(own.begin(), own.end(), sums.begin(), sums.begin(), std::plus<>());
  }
}
}

CellObjective::CellObjective(
  const CellContents& contents, const TwoPointProbability& target, Communicator& communicator)
  : Contents(contents)
  , Ranks(communicator)
  , Sizes(contents.Radii(), target.Lags.Maximum(), 1.0)
  , TypeOf(TypesOfSpheres(contents.Count))
  , Histogram(CellTypes(contents.Radius, contents.Mode), target.Lags, SearchKnots)
  , TwoPoint(contents, target, this->Histogram, communicator)
  , Overlap(contents, this->Histogram)
{
}

CellObjective::Terms CellObjective::Evaluate(
  const double* centres, double* gradient, std::int64_t* signal)
{
  const Window box = this->Contents.MakeBox();
  const SpherePack pack = this->Contents.MakePack(centres);
  const CellList cells(pack, box, this->Sizes);
  std::vector<std::int32_t> types;
  for (std::uint32_t i : cells.Index)
  {
    types.push_back(this->TypeOf[i]);
  }
  const PairCounts pairs = this->CountAllPairs(cells, types, signal);
  Terms terms;
  terms.TwoPoint = this->TwoPoint.Evaluate(pairs);
  terms.Penalty = this->Overlap.Evaluate(pairs);
  if (gradient)
  {
    this->Potential.assign(this->Histogram.Size(), 0.0);
    this->TwoPoint.AddPotential(this->Potential);
    this->Overlap.AddPotential(this->Potential);
    this->FindGradient(cells, types, gradient);
  }
  return terms;
}

PairCounts CellObjective::CountAllPairs(
  const CellList& cells, const std::vector<std::int32_t>& types, std::int64_t* signal)
{
  const double scale = PairHistogram::FixedPointScale(cells.Size(), cells.MostNeighbours(), 1.0);
  this->Sums.assign(this->Histogram.Size() + 1, 0);
  OverChunks(this->Ranks, cells.Size(), this->Sums,
    [&](std::size_t begin, std::size_t end, std::int64_t* sums)
    { CountPairs(this->Histogram, cells, types, scale, begin, end, sums); });
  if (signal)
  {
    this->Sums.back() = *signal;
  }
  this->Ranks.Sum(this->Sums.data(), this->Sums.size());
  if (signal)
  {
    *signal = this->Sums.back();
  }
  return { this->Sums.data(), scale };
}

void CellObjective::FindGradient(
  const CellList& cells, const std::vector<std::int32_t>& types, double* gradient) const
{
  std::vector<double> slopes;
  const double steepest = FindSlopes(this->Histogram, this->Potential, slopes);
  const double scale =
    PairHistogram::FixedPointScale(1, cells.MostNeighbours(), std::max(steepest, 1e-30));
  std::vector<std::int64_t> forces(4 * cells.Size(), 0);
  OverChunks(this->Ranks, cells.Size(), forces,
    [&](std::size_t begin, std::size_t end, std::int64_t* sums)
    { AddPairForces(this->Histogram, cells, types, slopes, scale, begin, end, sums); });
  this->Ranks.Sum(forces.data(), forces.size());
  for (std::size_t j = 0; j < cells.Size(); ++j)
  {
    for (int q = 0; q < 3; ++q)
    {
      gradient[3 * cells.Index[j] + q] = forces[4 * j + q] / scale;
    }
  }
}

CellFigures FiguresOf(const CellContents& contents)
{
  const double spheres = contents.NumberOfSpheres();
  std::vector<double> share;
  for (int count : contents.Count)
  {
    share.push_back(count / spheres);
  }
  return { spheres, spheres / contents.MakeBox().Volume(),
    *std::max_element(contents.Radius.begin(), contents.Radius.end()), contents.NumberOfModes(),
    contents.Radius, share, contents.Mode };
}

CellFigures CellFigures::Divided(int diameters) const
{
  CellFigures divided = *this;
  divided.Radius.clear();
  divided.Share.clear();
  for (std::size_t m = 0; m < this->Radius.size(); ++m)
  {
    const double share = m < this->Share.size() ? this->Share[m] : 1.0 / this->Radius.size();
    const double spheres = std::max(std::floor(share * this->Spheres), 1.0);
    const int types =
      static_cast<int>(diameters == 0 ? spheres : std::min(1.0 * diameters, spheres));
    divided.Radius.insert(divided.Radius.end(), types, this->Radius[m]);
    divided.Share.insert(divided.Share.end(), types, share / types);
    divided.Mode.insert(divided.Mode.end(), types, static_cast<int>(m) + 1);
  }
  return divided;
}

double EstimateObjectiveBytes(const CellFigures& cell, const LagGrid& lags)
{
  // For each number of the histogram: counts, penalty, potential, its slopes, and what ranks gather
  constexpr double bytesOfNumber = 6.0 * sizeof(double);
  const std::vector<SphereType> types = CellTypes(cell.Radius, cell.Mode);
  return PairHistogram::EstimateTables(types, lags, SearchKnots) +
    bytesOfNumber * PairHistogram::EstimateSize(types, lags, SearchKnots);
}

double EstimateEvaluation(const CellFigures& cell, const LagGrid& lags, bool withGradient)
{
  const double pairs =
    0.5 * cell.Spheres * cell.Density * SphereVolume(lags.Maximum() + 2.0 * cell.LargestRadius);
  const double classes = 0.5 * cell.Modes * (cell.Modes + 1.0);
  // What it takes to get from the histogram of a pair of modes to S_rs, on fewer knots than those
  // of an exact sum
  constexpr double SecondsPerClassAndLag = 5e-8;
  return (pairs * SecondsPerHistogramPair + classes * lags.Count * SecondsPerClassAndLag) *
    (withGradient ? 2.0 : 1.0);
}
}
