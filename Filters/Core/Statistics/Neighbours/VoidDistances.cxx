// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Neighbours/VoidDistances.h"

#include "ruc/Base/Range.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/Neighbours/CriticalRadius.h"
#include "ruc/Statistics/Neighbours/PoreThroats.h"
#include "ruc/Statistics/Neighbours/SurfaceDistances.h"
#include "ruc/Statistics/Results/SpaceBlocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ruc
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double FinestSpacing = 0.05; // of the mean diameter
constexpr double UsualPoints = 1.6e7, MostPoints = 1e9;
constexpr std::size_t PointsAtATime = 1 << 20;
constexpr double WidestThroat = 0.5; // mean diameters
constexpr double PercolationExponent = 0.876;

// In all but one of a thousand points of the matrix of random spheres the nearest one is closer
double UsualDistance(double meanDiameter, double fraction)
{
  return meanDiameter * std::max(std::cbrt(0.9 / fraction) - 0.5, 0.6);
}

double MaximumDistanceOf(const VoidSettings& settings, double meanDiameter, double largestRadius,
  double fraction, const Window& observed)
{
  if (settings.MaximumDistance > 0.0)
  {
    return settings.MaximumDistance;
  }
  double distance = UsualDistance(meanDiameter, fraction);
  for (int q = 0; q < 3; ++q)
  {
    distance = observed.Periodic[q] ? std::min(distance, 0.99 * (observed.Size[q] - largestRadius))
                                    : distance;
  }
  return distance;
}

double SpacingOf(const VoidSettings& settings, double meanDiameter, const Window& box)
{
  return settings.Spacing > 0.0 ? settings.Spacing
                                : LatticeSpacing(box, FinestSpacing * meanDiameter, UsualPoints);
}

PointLattice MakeLattice(const Window& box, const std::array<bool, 3>& periodic, double spacing)
{
  PointLattice lattice;
  lattice.Periodic = periodic;
  double points = 1.0;
  for (int q = 0; q < 3; ++q)
  {
    // Even along every axis, so that every second point is a lattice, too
    const double pairs = std::max(std::ceil(0.5 * box.Size[q] / spacing), 2.0);
    points *= 2.0 * pairs;
    Require(points <= MostPoints, "Spacing", Text("a lattice of at most ", MostPoints, " points"),
      spacing);
    lattice.Count[q] = 2 * static_cast<int>(pairs);
    lattice.Spacing[q] = box.Size[q] / lattice.Count[q];
    lattice.Origin[q] = box.Origin[q] + 0.5 * lattice.Spacing[q];
  }
  return lattice;
}

// The points of the matrix, counted by block and by how many distances of the table are less
class DistanceCounts
{
public:
  DistanceCounts(const SpaceBlocks& blocks, const VoidSettings& settings)
    : Blocks(blocks)
    , Steps(settings.Distances)
    , Most(settings.MaximumDistance)
    , Counts(static_cast<std::size_t>(blocks.Count()) * (settings.Distances + 2), 0)
    , Sums(blocks.Count(), 0.0)
  {
  }

  double DistanceAt(int k) const { return this->Most * k / this->Steps; }

  void Add(const Vector3& point, double distance)
  {
    const int block = this->Blocks.Of(point);
    int k = this->Steps;
    if (distance < static_cast<float>(this->Most))
    {
      k = std::min(static_cast<int>(distance / this->Most * this->Steps), this->Steps);
      // The quotient is rounded
      k = this->DistanceAt(k) < distance ? k : k - 1;
      k = k + 1 < this->Steps && this->DistanceAt(k + 1) < distance ? k + 1 : k;
    }
    ++this->Counts[static_cast<std::size_t>(block) * (this->Steps + 2) + k + 1];
    this->Sums[block] += distance;
    this->Largest = std::max(this->Largest, distance);
  }

  void Find(VoidDistances& result) const
  {
    const std::size_t width = this->Steps + 2;
    std::vector<double> norms, above(this->Sums.size(), 0.0);
    for (std::size_t block = 0; block < this->Sums.size(); ++block)
    {
      const auto begin = this->Counts.begin() + static_cast<std::ptrdiff_t>(block * width);
      const std::int64_t points =
        std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(width), std::int64_t(0));
      norms.push_back(static_cast<double>(points));
      result.Points += points;
      result.Blocks += points > 0;
    }
    result.Mean = JackknifeRatio(this->Sums, norms);
    result.Largest = this->Largest;
    result.Share.resize(this->Steps + 1);
    for (int k = this->Steps; k >= 0; --k)
    {
      for (std::size_t block = 0; block < above.size(); ++block)
      {
        above[block] += static_cast<double>(this->Counts[block * width + k + 1]);
      }
      result.Share[k] = JackknifeRatio(above, norms);
    }
    for (int k = 0; k <= this->Steps; ++k)
    {
      result.Distance.push_back(this->DistanceAt(k));
    }
    result.Beyond = result.Share.back().Value;
  }

private:
  const SpaceBlocks& Blocks;
  int Steps;
  double Most, Largest = 0.0;
  std::vector<std::int64_t> Counts; // at k + 1: those above distance k, and at most k + 1
  std::vector<double> Sums;
};

// Measures the distances plane by plane. Rank 0 keeps those of all points, raised by PoreThroats, 0
// outside the region.
std::vector<float> Measure(const PackShare& share, const SamplingRegion& region,
  const PointLattice& lattice, DistanceCounts& counts, const VoidSettings& settings,
  Communicator& ranks, const std::function<void(double)>& progress)
{
  std::vector<float> kept;
  const double most = settings.MaximumDistance;
  std::optional<PoreThroats> throats;
  if (settings.WithCriticalRadius)
  {
    throats.emplace(share, lattice, std::min(most, WidestThroat * share.MeanDiameter()), ranks);
  }
  const int planes =
    static_cast<int>(std::max<std::size_t>(1, PointsAtATime / lattice.PlaneSize()));
  for (int first = 0; first < lattice.Count[0]; first += planes)
  {
    const int last = std::min(first + planes, lattice.Count[0]);
    const SurfaceDistances own = FindSurfaceDistances(share.Own, lattice, most, first, last);
    std::vector<double> distances(own.Distance.begin(), own.Distance.end());
    ranks.Minimum(distances.data(), distances.size());
    const std::vector<double> raised =
      throats ? throats->Raise(own, distances, first, ranks) : std::vector<double>();
    std::size_t n = 0;
    for (int i = first; i < last; ++i)
    {
      for (int j = 0; j < lattice.Count[1]; ++j)
      {
        for (int k = 0; k < lattice.Count[2]; ++k, ++n)
        {
          const Vector3 point = lattice.PointAt(i, j, k);
          const bool isVoid = distances[n] > 0.0 && region.Contains(point);
          if (isVoid)
          {
            counts.Add(point, distances[n]);
          }
          if (throats && ranks.Rank() == 0)
          {
            kept.push_back(isVoid ? static_cast<float>(raised[n]) : 0.0F);
          }
        }
      }
    }
    if (progress)
    {
      progress(0.8 * last / lattice.Count[0]);
    }
  }
  return kept;
}

// The part of the lattice that fills a box, in which critical radii are found; or none of it
LatticeValues BoxOf(
  const SamplingRegion& region, const PointLattice& lattice, const std::vector<float>& distances)
{
  const LatticeValues all = { distances.data(),
    { static_cast<std::ptrdiff_t>(lattice.PlaneSize()), lattice.Count[2], 1 }, lattice.Count,
    lattice.Periodic };
  const Window& shape = region.GetShape();
  if (shape.GetShape() == Window::Shape::Box)
  {
    const bool isWhole = region.Volume() > (1.0 - 1e-9) * shape.Volume();
    return isWhole ? all : all.Box({}, {});
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(shape.Axis[axis]) > 1.0 - 1e-9)
    {
      std::array<int, 3> from = { 0, 0, 0 }, count = all.Count;
      for (int q = 0; q < 3; ++q)
      {
        const double outside = 0.5 - 0.5 * std::sqrt(0.5);
        from[q] = q == axis ? 0 : static_cast<int>(std::ceil(outside * count[q]));
        count[q] -= 2 * from[q];
      }
      return all.Box(from, count);
    }
  }
  return all.Box({}, {});
}

std::array<ValueWithError, 3> FindCriticalRadii(
  const LatticeValues& box, double spacing, double meanDiameter)
{
  const ValueWithError unknown = { NotANumber, NotANumber };
  std::array<ValueWithError, 3> radii = { unknown, unknown, unknown };
  if (std::any_of(box.Count.begin(), box.Count.end(), [](int count) { return count < 4; }))
  {
    return radii;
  }
  const std::array<double, 3> found = FindCriticalValues(box);
  std::array<double, 3> sums{}, squares{};
  for (int n = 0; n < 8; ++n)
  {
    const std::array<int, 3> half = { box.Count[0] / 2, box.Count[1] / 2, box.Count[2] / 2 };
    const std::array<double, 3> ofEighth =
      FindCriticalValues(box.Box({ n / 4 * half[0], n / 2 % 2 * half[1], n % 2 * half[2] }, half));
    for (int q = 0; q < 3; ++q)
    {
      sums[q] += ofEighth[q];
      squares[q] += ofEighth[q] * ofEighth[q];
    }
  }
  const double beside = spacing * spacing / (12.0 * meanDiameter);
  for (int q = 0; q < 3; ++q)
  {
    const double scatter = std::sqrt(std::max(squares[q] - sums[q] * sums[q] / 8.0, 0.0) / 7.0);
    radii[q] = { found[q],
      std::hypot(beside, scatter * std::pow(2.0, -1.0 / PercolationExponent)) };
  }
  return radii;
}
}

void CheckSettings(const VoidSettings& settings)
{
  Range::AtLeast(0.0).Check("Spacing", settings.Spacing);
  Range::AtLeast(0.0).Check("MaximumDistance", settings.MaximumDistance);
  Range::From(1, 100000).Check("NumberOfDistances", settings.Distances);
  Range::From(2, 1000).Check("Blocks", settings.Blocks);
}

VoidSettings WithMaximumDistance(const VoidSettings& settings, const PackTotals& pack)
{
  VoidSettings found = settings;
  const double fraction =
    std::accumulate(pack.Volume.begin(), pack.Volume.end(), 0.0) / pack.Observed.Volume();
  found.MaximumDistance =
    MaximumDistanceOf(settings, pack.MeanDiameter(), pack.LargestRadius, fraction, pack.Observed);
  return found;
}

VoidDistances MeasureVoids(const PackShare& share, const SamplingRegion& region,
  const VoidSettings& settings, Communicator& ranks, const std::function<void(double)>& progress)
{
  CheckSettings(settings);
  const VoidSettings found = WithMaximumDistance(settings, share);
  const double most = found.MaximumDistance;
  for (int q = 0; q < 3; ++q)
  {
    const double longest = share.Observed.Size[q] - share.LargestRadius;
    Require(!share.Observed.Periodic[q] || most < longest, "MaximumDistance",
      Text("less than the periodic edge without the largest radius, ", longest), most);
  }
  const Window& box = region.GetBounds();
  const PointLattice lattice =
    MakeLattice(box, share.Observed.Periodic, SpacingOf(settings, share.MeanDiameter(), box));
  const SpaceBlocks blocks(box, settings.Blocks);
  DistanceCounts counts(blocks, found);
  const std::vector<float> distances =
    Measure(share, region, lattice, counts, found, ranks, progress);

  VoidDistances result;
  counts.Find(result);
  Require(result.Points > 0, "Void Distances",
    Text("points outside the spheres in the region, of the ",
      static_cast<double>(lattice.Count[0]) * lattice.Count[1] * lattice.Count[2],
      " points of the lattice"),
    "none");
  result.Spacing = *std::max_element(lattice.Spacing.begin(), lattice.Spacing.end());
  result.MaximumDistance = most;
  std::vector<double> critical;
  if (!found.WithCriticalRadius)
  {
    result.CriticalRadius.fill({ NotANumber, NotANumber });
    return result;
  }
  if (ranks.Rank() == 0)
  {
    for (const ValueWithError& radius :
      FindCriticalRadii(BoxOf(region, lattice, distances), result.Spacing, share.MeanDiameter()))
    {
      critical.insert(critical.end(), { radius.Value, radius.Error });
    }
  }
  ranks.Broadcast(critical, 0);
  for (int q = 0; q < 3; ++q)
  {
    result.CriticalRadius[q] = { critical[2 * q], critical[2 * q + 1] };
  }
  return result;
}

Estimate EstimateVoids(const PackFigures& pack, const VoidSettings& settings)
{
  constexpr double secondsPerDistance = 1.5e-9, secondsPerPoint = 2.5e-7;
  constexpr double bytesPerPoint = 22.0, bytesAtATime = 16.0;
  CheckSettings(settings);
  const double fraction = pack.Density() * SphereVolume(0.5 * pack.MeanDiameter);
  const double most =
    MaximumDistanceOf(settings, pack.MeanDiameter, pack.LargestRadius, fraction, pack.Observed);
  const Window box = pack.Observed.GetBounds();
  const double points = box.Volume() / std::pow(SpacingOf(settings, pack.MeanDiameter, box), 3);
  const double distances = points * pack.Density() * SphereVolume(0.5 * pack.MeanDiameter + most);
  return { distances * secondsPerDistance + points * secondsPerPoint,
    (points * bytesPerPoint + PointsAtATime * bytesAtATime) / BytesOfMegabyte, 0.0,
    settings.MaximumDistance > 0.0 ? std::string() : Text("Maximum Distance ", most) };
}
}
