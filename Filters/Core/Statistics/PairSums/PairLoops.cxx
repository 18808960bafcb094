// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairLoops.h"

#include "ruc/Base/FixedPoint.h"
#include "ruc/Base/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace ruc
{
namespace
{
// The length of a part of a range of centres; distances and weights are found in vector registers
// before the histogram is touched
constexpr std::size_t ChunkSize = 256;

struct Chunk
{
  std::size_t Size;
  const double *X, *Y, *Z;
  const std::int32_t* Type;
  double Distance[ChunkSize];
  double Weight[ChunkSize];
};

// The displacement is (centre - place) + shift (see PairNeighbourhood)
RUC_VECTOR_CLONES
void FindDistances(Chunk& chunk, const double* place, const double* shift)
{
  const double *cx = chunk.X, *cy = chunk.Y, *cz = chunk.Z;
  const double x = place[0], y = place[1], z = place[2];
  const double sx = shift[0], sy = shift[1], sz = shift[2];
  const int size = static_cast<int>(chunk.Size);
#pragma GCC ivdep
  for (int k = 0; k < size; ++k)
  {
    const double dx = (cx[k] - x) + sx;
    const double dy = (cy[k] - y) + sy;
    const double dz = (cz[k] - z) + sz;
    chunk.Distance[k] = std::sqrt(dx * dx + dy * dy + dz * dz);
  }
}

// The set covariance of a box is the product of (edge - loss x |displacement|) over its axes.
// `loss` is 0 along periodic axes, the only ones with a shift.
RUC_VECTOR_CLONES
void WeighByBox(
  Chunk& chunk, const double* place, const double* edge, const double* loss, double numerator)
{
  const double x = place[0], y = place[1], z = place[2];
  const double *cx = chunk.X, *cy = chunk.Y, *cz = chunk.Z;
  const double ex = edge[0], ey = edge[1], ez = edge[2];
  const double lx = loss[0], ly = loss[1], lz = loss[2];
  const int size = static_cast<int>(chunk.Size);
#pragma GCC ivdep
  for (int k = 0; k < size; ++k)
  {
    chunk.Weight[k] = numerator /
      ((ex - lx * std::abs(cx[k] - x)) * (ey - ly * std::abs(cy[k] - y)) *
        (ez - lz * std::abs(cz[k] - z)));
  }
}

using Four = double __attribute__((vector_size(32)));
using FourIntegers = std::int64_t __attribute__((vector_size(32)));

// Always inlined, so that it is compiled for the caller's instruction set
[[gnu::always_inline]] inline void AddRounded(const Four& values, std::int64_t* sums)
{
  const Four zero = Four{} + FixedPointRounder;
  FourIntegers now;
  std::memcpy(&now, sums, sizeof(now));
  now += FourIntegers(values + zero) - FourIntegers(zero);
  std::memcpy(sums, &now, sizeof(now));
}

[[gnu::always_inline]] inline std::size_t KeepCloserThan(
  double cutoff, const Chunk& chunk, std::uint16_t* kept)
{
  std::size_t number = 0;
  for (std::size_t k = 0; k < chunk.Size; ++k)
  {
    kept[number] = static_cast<std::uint16_t>(k);
    number += chunk.Distance[k] < cutoff;
  }
  return number;
}

RUC_VECTOR_CLONES
void AddToHistogram(
  const Chunk& chunk, double cutoff, const PairHistogram::Lookup* lookups, std::int64_t* histogram)
{
  std::uint16_t kept[ChunkSize];
  const std::size_t number = KeepCloserThan(cutoff, chunk, kept);
  // The cubic Hermite basis, for value and slope at the lower knot and value and slope at the upper
  const Four constant = { 1.0, 0.0, 0.0, 0.0 };
  const Four linear = { 0.0, 1.0, 0.0, 0.0 };
  const Four quadratic = { -3.0, -2.0, 3.0, -1.0 };
  const Four cubic = { 2.0, 1.0, -2.0, 1.0 };
  for (std::size_t n = 0; n < number; ++n)
  {
    const std::size_t k = kept[n];
    const PairHistogram::Lookup& lookup = lookups[chunk.Type[k]];
    const double u =
      std::min(chunk.Distance[k] * lookup.InverseSpacing + lookup.Shift, lookup.Last);
    const std::int32_t knot = static_cast<std::int32_t>(u);
    const double t = u - knot;
    const Four weights = (constant + t * (linear + t * (quadratic + t * cubic))) * chunk.Weight[k];
    AddRounded(weights, histogram + lookup.Begin + 2 * knot);
  }
}
}

namespace
{
constexpr double NoShift[3] = { 0.0, 0.0, 0.0 };

// Puts the centres [begin, end) of a cell list into `chunk`, part by part, and calls visit(first)
// for each
template <class Visit>
void ForEachChunk(Chunk& chunk, const CellList& cells, const std::int32_t* types, std::size_t begin,
  std::size_t end, Visit&& visit)
{
  for (std::size_t from = begin; from < end; from += ChunkSize)
  {
    chunk.Size = std::min(ChunkSize, end - from);
    chunk.X = &cells.X[from];
    chunk.Y = &cells.Y[from];
    chunk.Z = &cells.Z[from];
    chunk.Type = &types[from];
    visit(from);
  }
}
}

void CountPairs(const PairHistogram& classes, const CellList& cells,
  const std::vector<std::int32_t>& types, double scale, std::size_t begin, std::size_t end,
  std::int64_t* histogram)
{
  Chunk chunk;
  std::fill(std::begin(chunk.Weight), std::end(chunk.Weight), scale);
  std::vector<CellList::Range> ranges;
  for (std::size_t i = begin; i < end; ++i)
  {
    cells.FindRanges(i, ranges);
    for (const CellList::Range& range : ranges)
    {
      const double place[3] = { range.X, range.Y, range.Z };
      ForEachChunk(chunk, cells, types.data(), range.Begin, range.End,
        [&](std::size_t)
        {
          FindDistances(chunk, place, NoShift);
          AddToHistogram(chunk, range.Reach, classes.LookupRow(types[i]), histogram);
        });
    }
  }
}

void CountPairs(const PairHistogram& classes, const PairNeighbourhood& pairs,
  const std::vector<std::vector<std::int32_t>>& types, const Window& window, double scale,
  std::size_t begin, std::size_t end, std::int64_t* histogram)
{
  const bool cylinder = window.GetShape() == Window::Shape::Cylinder;
  const double numerator = scale * window.Volume();
  const double loss[3] = { window.Periodic[0] ? 0.0 : 1.0, window.Periodic[1] ? 0.0 : 1.0,
    window.Periodic[2] ? 0.0 : 1.0 };
  Chunk chunk;
  std::fill(std::begin(chunk.Weight), std::end(chunk.Weight), scale);
  std::vector<PairNeighbourhood::Range> ranges;
  for (std::size_t i = begin; i < end; ++i)
  {
    const double place[3] = { pairs.Own().X[i], pairs.Own().Y[i], pairs.Own().Z[i] };
    pairs.FindRanges(i, ranges);
    for (const PairNeighbourhood::Range& range : ranges)
    {
      const PairNeighbourhood::Part& part = pairs.Parts[range.Part];
      ForEachChunk(chunk, part.Cells, types[range.Part].data(), range.Begin, range.End,
        [&](std::size_t)
        {
          FindDistances(chunk, place, part.Shift.data());
          for (std::size_t k = 0; cylinder && k < chunk.Size; ++k)
          {
            if (chunk.Distance[k] < range.Reach)
            {
              chunk.Weight[k] = numerator /
                window.SetCovariance(
                  chunk.X[k] - place[0], chunk.Y[k] - place[1], chunk.Z[k] - place[2]);
            }
          }
          if (!cylinder && !window.IsFullyPeriodic())
          {
            WeighByBox(chunk, place, window.Size.data(), loss, numerator);
          }
          AddToHistogram(chunk, range.Reach, classes.LookupRow(types[0][i]), histogram);
        });
    }
  }
}

double FindSlopes(
  const PairHistogram& classes, const std::vector<double>& potential, std::vector<double>& slopes)
{
  slopes.assign(2 * potential.size(), 0.0);
  double bound = 0.0;
  for (int c = 0; c < classes.NumberOfClasses(); ++c)
  {
    const PairKernel& kernel = classes.Kernel(c);
    const double* knot = &potential[classes.Begin(c)];
    double* slope = &slopes[2 * classes.Begin(c)];
    for (int m = 0; m < kernel.Intervals; ++m, knot += 2, slope += 4)
    {
      const double rise = knot[2] - knot[0];
      slope[0] = knot[1] / kernel.Spacing;
      slope[1] = 2.0 * (3.0 * rise - 2.0 * knot[1] - knot[3]) / kernel.Spacing;
      slope[2] = 3.0 * (knot[1] + knot[3] - 2.0 * rise) / kernel.Spacing;
      bound = std::max(bound, std::abs(slope[0]) + std::abs(slope[1]) + std::abs(slope[2]));
    }
  }
  return bound;
}

namespace
{
// Does what AddToHistogram does for forces; `places` are the centres x, y, z, 0 of the chunk, to
// which `gradient` belongs
RUC_VECTOR_CLONES
void AddForces(const Chunk& chunk, double cutoff, const PairHistogram::Lookup* lookups,
  const double* slopes, double scale, const double* centre, const double* places, std::int64_t* own,
  std::int64_t* gradient)
{
  std::uint16_t kept[ChunkSize];
  const std::size_t number = KeepCloserThan(cutoff, chunk, kept);
  Four from;
  std::memcpy(&from, centre, sizeof(from));
  for (std::size_t n = 0; n < number; ++n)
  {
    const std::size_t k = kept[n];
    const PairHistogram::Lookup& lookup = lookups[chunk.Type[k]];
    const double d = chunk.Distance[k];
    const double u = std::min(d * lookup.InverseSpacing + lookup.Shift, lookup.Last);
    const std::int32_t knot = static_cast<std::int32_t>(u);
    const double t = u - knot;
    const double* slope = slopes + 2 * (lookup.Begin + 2 * knot);
    const double force = scale * (slope[0] + t * (slope[1] + t * slope[2])) / std::max(d, 1e-30);
    Four to;
    std::memcpy(&to, places + 4 * k, sizeof(to));
    const Four pull = (to - from) * force;
    AddRounded(pull, gradient + 4 * k);
    AddRounded(-pull, own);
  }
}
}

void AddPairForces(const PairHistogram& classes, const CellList& cells,
  const std::vector<std::int32_t>& types, const std::vector<double>& slopes, double scale,
  std::size_t begin, std::size_t end, std::int64_t* gradient)
{
  std::vector<double> places(4 * cells.Size(), 0.0);
  for (std::size_t j = 0; j < cells.Size(); ++j)
  {
    places[4 * j] = cells.X[j];
    places[4 * j + 1] = cells.Y[j];
    places[4 * j + 2] = cells.Z[j];
  }
  Chunk chunk;
  std::vector<CellList::Range> ranges;
  for (std::size_t i = begin; i < end; ++i)
  {
    cells.FindRanges(i, ranges);
    for (const CellList::Range& range : ranges)
    {
      const double centre[4] = { range.X, range.Y, range.Z, 0.0 };
      ForEachChunk(chunk, cells, types.data(), range.Begin, range.End,
        [&](std::size_t from)
        {
          FindDistances(chunk, centre, NoShift);
          AddForces(chunk, range.Reach, classes.LookupRow(types[i]), slopes.data(), scale, centre,
            &places[4 * from], gradient + 4 * i, gradient + 4 * from);
        });
    }
  }
}
}
