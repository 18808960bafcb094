// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/NeighbourSums.h"

#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Neighbours/SurfaceDistances.h"
#include "ruc/Statistics/PairSums/WeightedPairs.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ruc
{
namespace
{
constexpr double LeastGap = 1e-4;
constexpr double LeastNearest = 2.5e-6;        // mean diameters
constexpr double LeastThreshold = 0.002;       // below it are the overlaps of measured packs
constexpr double PoreSpacing = 0.125;          // of the lattice, in mean diameters
constexpr double MostPorePoints = 4e6;         // the lattice is coarser in a large pack
constexpr double LargestPoreInDiameters = 0.4; // mean diameters
constexpr std::size_t PorePointsAtATime = 1 << 20;

// The columns over which errors are found
class Columns
{
public:
  explicit Columns(const Window& window)
    : Bounds(window.GetBounds())
  {
    const Vector3& size = this->Bounds.Size;
    this->Shortest = static_cast<int>(std::min_element(size.begin(), size.end()) - size.begin());
  }

  static constexpr int Count = 9;

  int Of(const Vector3& centre) const
  {
    const auto third = [&](int axis)
    {
      const double place = (centre[axis] - this->Bounds.Origin[axis]) / this->Bounds.Size[axis];
      return static_cast<int>(std::clamp(std::floor(3.0 * place), 0.0, 2.0));
    };
    return 3 * third((this->Shortest + 1) % 3) + third((this->Shortest + 2) % 3);
  }

private:
  Window Bounds;
  int Shortest;
};

// Whether a layer can be taken off the window's border
bool HasInside(const Window& window, double margin)
{
  return window.IsFullyPeriodic() || 2.0 * margin < 0.999 * window.ShortestEdge();
}

// The largest reach of a neighbour
double NeighbourReach(const PackShare& share)
{
  return 2.0 * share.LargestRadius * (1.0 + LargestNeighbourGap);
}

void AddNorms(const std::vector<std::int64_t>& counts, BlockHistogram& histogram)
{
  std::copy(counts.begin(), counts.end(), histogram.Norm.begin());
}

HingeSums MeasureGaps(
  const PackShare& share, const WeightedPairs& pairs, const Columns& columns, Communicator& ranks)
{
  BlockHistogram histogram(LeastGap, LargestNeighbourGap, Columns::Count);
  const std::vector<std::int64_t> sums = pairs.Sum(histogram.Weight.size(), ranks, {},
    [&](std::size_t begin, std::size_t end, std::int64_t* own)
    {
      pairs.ForEach(begin, end,
        [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, const Vector3&,
          double d2, double weight)
        {
          const double gap = std::sqrt(d2) / (share.Own.Radius[i] + part.Pack.Radius[j]) - 1.0;
          if (gap < LargestNeighbourGap)
          {
            const int bin = histogram.BinOf(gap);
            for (int column : { columns.Of(share.Own.Centre(i)), columns.Of(part.Pack.Centre(j)) })
            {
              own[std::size_t(column) * BlockHistogram::Bins + bin] +=
                RoundToFixedPoint(pairs.Scale * weight);
            }
          }
        });
    });
  for (std::size_t n = 0; n < histogram.Weight.size(); ++n)
  {
    histogram.Weight[n] = WideValue(&sums[2 * n]) / pairs.Scale;
  }
  std::vector<std::int64_t> centres(Columns::Count, 0);
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    ++centres[columns.Of(share.Own.Centre(i))];
  }
  ranks.Sum(centres.data(), centres.size());
  AddNorms(centres, histogram);
  return FindHingeSums(histogram, HingeSide::Below, LeastThreshold);
}

// The least gap of a sphere that another rank owns, as a pair of two ranks is met by one of them
struct ForeignGap
{
  Vector3 Centre;
  double Gap;

  template <class Self>
  static auto Fields(Self& self)
  {
    return std::tie(self.Centre, self.Gap);
  }
};

// The least gap d - a - b of every own sphere, infinite where it has no neighbour
std::vector<double> FindNearest(
  const PackShare& share, const WeightedPairs& pairs, Communicator& ranks)
{
  std::vector<double> nearest(share.Own.Size(), std::numeric_limits<double>::infinity());
  std::map<Vector3, double> foreign;
  pairs.ForEach(0, pairs.Pairs.Size(),
    [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, const Vector3&,
      double d2, double)
    {
      const double contact = share.Own.Radius[i] + part.Pack.Radius[j];
      const double gap = std::sqrt(d2) - contact;
      if (gap < LargestNeighbourGap * contact)
      {
        nearest[i] = std::min(nearest[i], gap);
        double& other = &part == &pairs.Pairs.Parts.front()
          ? nearest[j]
          : foreign.try_emplace(part.Pack.Centre(j), gap).first->second;
        other = std::min(other, gap);
      }
    });
  std::vector<ForeignGap> told;
  for (const auto& [centre, gap] : foreign)
  {
    told.push_back({ centre, gap });
  }
  std::map<Vector3, std::size_t> places;
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    places[share.Own.Centre(i)] = i;
  }
  for (const ForeignGap& gap : ranks.Concatenate(told))
  {
    const auto place = places.find(gap.Centre);
    if (place != places.end())
    {
      nearest[place->second] = std::min(nearest[place->second], gap.Gap);
    }
  }
  return nearest;
}

HingeSums MeasureNearest(
  const PackShare& share, const WeightedPairs& pairs, const Columns& columns, Communicator& ranks)
{
  const double reach = NeighbourReach(share);
  if (!HasInside(share.Observed, reach))
  {
    return {};
  }
  const Window inside = share.Observed.Shrunk(reach);
  BlockHistogram histogram(LeastNearest * share.MeanDiameter(),
    2.0 * LargestNeighbourGap * share.LargestRadius, Columns::Count);
  std::vector<std::int64_t> counts(histogram.Weight.size(), 0), centres(Columns::Count, 0);
  const std::vector<double> nearest = FindNearest(share, pairs, ranks);
  for (std::size_t i = 0; i < share.Own.Size(); ++i)
  {
    const Vector3 centre = share.Own.Centre(i);
    if (inside.Contains(centre))
    {
      const int column = columns.Of(centre);
      ++centres[column];
      if (std::isfinite(nearest[i]))
      {
        ++counts[std::size_t(column) * BlockHistogram::Bins + histogram.BinOf(nearest[i])];
      }
    }
  }
  ranks.Sum(counts.data(), counts.size());
  ranks.Sum(centres.data(), centres.size());
  if (std::accumulate(centres.begin(), centres.end(), std::int64_t(0)) < LeastCentresOfSums)
  {
    return {};
  }
  std::copy(counts.begin(), counts.end(), histogram.Weight.begin());
  AddNorms(centres, histogram);
  return FindHingeSums(histogram, HingeSide::Below, LeastThreshold * share.MeanDiameter());
}

// The lattice of the points where pores are measured
PointLattice MakePoreLattice(const PackShare& share, const Window& inside)
{
  const Window box = inside.GetBounds();
  const double spacing = LatticeSpacing(box, PoreSpacing * share.MeanDiameter(), MostPorePoints);
  PointLattice lattice;
  lattice.Periodic = share.Observed.Periodic;
  for (int q = 0; q < 3; ++q)
  {
    lattice.Count[q] = std::max(1, static_cast<int>(std::ceil(box.Size[q] / spacing)));
    lattice.Spacing[q] = box.Size[q] / lattice.Count[q];
    lattice.Origin[q] = box.Origin[q] + 0.5 * lattice.Spacing[q];
  }
  return lattice;
}

HingeSums MeasurePores(
  const PackShare& share, double largestPore, const Columns& columns, Communicator& ranks)
{
  const double margin = share.LargestRadius + largestPore;
  if (!HasInside(share.Observed, margin))
  {
    return {};
  }
  const Window inside = share.Observed.Shrunk(margin);
  if (inside.Volume() < LeastCentresOfSums * std::pow(share.MeanDiameter(), 3))
  {
    return {};
  }
  const PointLattice lattice = MakePoreLattice(share, inside);
  BlockHistogram histogram(0.0, largestPore, Columns::Count);
  const int planes =
    static_cast<int>(std::max<std::size_t>(1, PorePointsAtATime / lattice.PlaneSize()));
  for (int first = 0; first < lattice.Count[0]; first += planes)
  {
    const int last = std::min(first + planes, lattice.Count[0]);
    const SurfaceDistances own = FindSurfaceDistances(share.Own, lattice, largestPore, first, last);
    std::vector<double> distances(own.Distance.begin(), own.Distance.end());
    ranks.Minimum(distances.data(), distances.size());
    std::size_t n = 0;
    for (int i = first; i < last; ++i)
    {
      for (int j = 0; j < lattice.Count[1]; ++j)
      {
        for (int k = 0; k < lattice.Count[2]; ++k, ++n)
        {
          const Vector3 point = lattice.PointAt(i, j, k);
          if (distances[n] > 0.0 && inside.Contains(point))
          {
            const int column = columns.Of(point);
            ++histogram.Norm[column];
            ++histogram
                .Weight[std::size_t(column) * BlockHistogram::Bins + histogram.BinOf(distances[n])];
          }
        }
      }
    }
  }
  return FindHingeSums(histogram, HingeSide::Above, 0.0);
}
}

NeighbourSums MeasureNeighbourSums(const PackShare& share, Communicator& ranks)
{
  NeighbourSums sums;
  sums.LargestPore = LargestPoreInDiameters * share.MeanDiameter();
  if (share.NumberOfSpheres < LeastCentresOfSums ||
    !(share.Observed.Reach() > NeighbourReach(share)))
  {
    return sums;
  }
  const Columns columns(share.Observed);
  const WeightedPairs pairs(share,
    SizeClasses(share.Own.Radius, 0.0, 1.0 + LargestNeighbourGap, ranks), ranks, "ContactWeight");
  sums.Gaps = MeasureGaps(share, pairs, columns, ranks);
  sums.Nearest = MeasureNearest(share, pairs, columns, ranks);
  sums.Pores = MeasurePores(share, sums.LargestPore, columns, ranks);
  return sums;
}

Estimate EstimateNeighbourSums(const PackFigures& pack)
{
  constexpr double secondsPerPair = 2e-7, secondsPerDistance = 3e-9, secondsPerPoint = 4e-8;
  const Window box = pack.Observed.GetBounds();
  const double spacing = LatticeSpacing(box, PoreSpacing * pack.MeanDiameter, MostPorePoints);
  const double points = box.Volume() / (spacing * spacing * spacing);
  const double reach = 0.5 * pack.MeanDiameter + LargestPoreInDiameters * pack.MeanDiameter;
  const double distances = points * pack.Density() * SphereVolume(reach);
  const double pairs = pack.PairsWithin((1.0 + LargestNeighbourGap) * pack.MeanDiameter);
  return { pairs * secondsPerPair + distances * secondsPerDistance + points * secondsPerPoint,
    // Of a stretch of points the distances twice and the spheres, and the histograms
    (PorePointsAtATime * 16.0 + 4.0 * Columns::Count * BlockHistogram::Bins * sizeof(double)) /
      BytesOfMegabyte,
    0.0 };
}
}
