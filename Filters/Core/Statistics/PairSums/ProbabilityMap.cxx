// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ProbabilityMap.h"

#include "ruc/Base/FixedPointSums.h"
#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Base/Vector3.h"
#include "ruc/Base/VectorClones.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/WeightedPairs.h"
#include "ruc/Statistics/Results/LagLimit.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/Results/TwoPointProbability.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ruc
{
namespace
{
constexpr double MostNumbers = 5e7; // in all images, 400 MB
constexpr int Lanes = 8;            // how many numbers of a row are taken together

/**
 * The half of a cubic grid that is summed up, as slices k = 0…Half. They are whole but for k = 0,
 * where rows j > 0 are the mirror images of those j < 0 and stay empty.
 */
struct HalfGrid
{
  int Half;

  std::size_t Row() const { return 2 * static_cast<std::size_t>(this->Half) + 1; }
  std::size_t Slice() const { return this->Row() * this->Row(); }
  std::size_t Size() const { return (static_cast<std::size_t>(this->Half) + 1) * this->Slice(); }
};

/** The slices of a thread, which takes every Stride-th, of images that follow each other. */
struct Images
{
  std::int64_t* Sums;
  int FirstSlice, Stride;
  std::size_t SizeOfImage;
};

/** The voxels of a ball, row after row, in buffers that are large enough for every ball. */
struct Ball
{
  Ball(double contact, const HalfGrid& grid)
  {
    const double edge = std::min(2.0 * contact + 2.0, double(grid.Row()));
    this->Rows.resize(static_cast<std::size_t>(edge * edge));
    this->Squares.resize(static_cast<std::size_t>(edge * edge * edge) + Lanes);
    this->Overlap.resize(this->Squares.size());
  }

  struct Row
  {
    std::size_t First; // place of its first voxel in an image
    int Count;
  };
  std::size_t NumberOfRows = 0, Size = 0;
  std::vector<Row> Rows;
  std::vector<double> Squares; // the squared distances from the centre
  std::vector<std::int64_t> Overlap;
};

// Finds the voxels closer to d than `contact` in the slices of a thread. Lengths are in units of
// the spacing.
RUC_VECTOR_CLONES // for rounding without calls
  void
  FindBall(double contact, const Vector3& d, const HalfGrid& grid, const Images& images, Ball& ball)
{
  Ball::Row* row = ball.Rows.data();
  double* squares = ball.Squares.data();
  const double contact2 = contact * contact, most = grid.Half;
  // In double until the number is known to be in the grid, or next to it
  const auto first = [&](double low, double least)
  { return static_cast<int>(std::min(std::max(std::ceil(low), least), most + 1.0)); };
  const auto last = [&](double high)
  { return static_cast<int>(std::max(std::min(std::floor(high), most), -most - 1.0)); };
  const int lastSlice = last(d[2] + contact);
  int k = first(d[2] - contact, 0.0);
  k += ((images.FirstSlice - k) % images.Stride + images.Stride) % images.Stride;
  for (; k <= lastSlice; k += images.Stride)
  {
    const double z2 = (d[2] - k) * (d[2] - k);
    const double sliceRadius = std::sqrt(std::max(contact2 - z2, 0.0));
    const int lastRow = k > 0 ? last(d[1] + sliceRadius) : std::min(last(d[1] + sliceRadius), 0);
    for (int j = first(d[1] - sliceRadius, -most); j <= lastRow; ++j)
    {
      const double across2 = (d[1] - j) * (d[1] - j) + z2;
      const double chord = std::sqrt(std::max(contact2 - across2, 0.0));
      const int begin = first(d[0] - chord, -most), end = last(d[0] + chord) + 1;
      if (begin < end)
      {
        *row++ = { static_cast<std::size_t>(k / images.Stride) * grid.Slice() +
            (j + grid.Half) * grid.Row() + (begin + grid.Half),
          end - begin };
        // Whole vectors are written at a time; the next row overwrites what is too much
        for (int i = begin; i < end; i += Lanes)
        {
          for (int lane = 0; lane < Lanes; ++lane)
          {
            const double x = d[0] - (i + lane);
            squares[i - begin + lane] = across2 + x * x;
          }
        }
        squares += end - begin;
      }
    }
  }
  ball.NumberOfRows = row - ball.Rows.data();
  ball.Size = squares - ball.Squares.data();
}

// Finds factor x V(sqrt(square)) as integers
RUC_VECTOR_CLONES
void FindOverlap(const LensFormula& lens, double factor, const double* squares, std::size_t count,
  std::int64_t* overlap)
{
  const LensFormula volume = lens;
  for (std::size_t n = 0; n < count; ++n)
  {
    overlap[n] = RoundToFixedPoint(factor * volume(std::sqrt(squares[n])));
  }
}

// Adds factor x V(|d - x|), multiplied by multiple[m] for image m, to those voxels x of a thread
// that are in the half grid
void AddBall(const LensFormula& lens, const Vector3& d, double factor, const HalfGrid& grid,
  const Images& images, const std::vector<std::int64_t>& multiple, Ball& ball)
{
  FindBall(lens.Contact, d, grid, images, ball);
  FindOverlap(lens, factor, ball.Squares.data(), ball.Size, ball.Overlap.data());
  for (std::size_t image = 0; image < multiple.size(); ++image)
  {
    const std::int64_t m = multiple[image];
    const std::int64_t* overlap = ball.Overlap.data();
    for (std::size_t n = 0; m > 0 && n < ball.NumberOfRows; ++n)
    {
      const Ball::Row& row = ball.Rows[n];
      std::int64_t* sums = images.Sums + image * images.SizeOfImage + row.First;
      for (int i = 0; i < row.Count; ++i)
      {
        sums[i] += m * overlap[i];
      }
      overlap += row.Count;
    }
  }
}

// How often the overlap of an unordered pair of spheres, of modes a and b, counts in what is summed
// for S_rs: for two modes this is S_rs itself, for (r, m) the sum of all that have r, for (m, m)
// the sum of all
int MultipleOf(const std::array<int, 2>& phases, int a, int b, int matrix)
{
  const int r = std::min(phases[0], phases[1]), s = std::max(phases[0], phases[1]);
  if (r == matrix)
  {
    return 2;
  }
  if (s == matrix)
  {
    return (a == r) + (b == r);
  }
  return r == s ? 2 * (a == r && b == r) : (std::min(a, b) == r && std::max(a, b) == s);
}

void CheckMap(const PackShare& share, const std::vector<std::array<int, 2>>& pairs, double spacing,
  double reach)
{
  const int matrix = share.NumberOfModes();
  Require(!pairs.empty(), "PhasePairs", "at least one pair of phases", "none");
  for (const std::array<int, 2>& pair : pairs)
  {
    for (int phase : pair)
    {
      Require(phase >= 0 && phase <= matrix, "PhasePairs",
        Text("phases from 0 to ", matrix, " (the matrix)"), phase);
    }
  }
  Require(spacing > 0.0 && std::isfinite(spacing), "Spacing", "a finite number > 0", spacing);
  const LagLimit limit = LagLimit::ForMap(share.Observed, share.LargestRadius);
  limit.Check(reach);
  const double most = std::floor(0.5 * (std::cbrt(MostNumbers / pairs.size()) - 1.0));
  const double half = std::floor(reach / spacing * (1.0 + 1e-12));
  Require(half <= most, "Resolution",
    Text("at most ", most, " for ", pairs.size(), " pairs of phases"), half);
  limit.CheckSpacing(spacing);
}

// How often the overlap of two spheres, of modes counted from 1, counts in every image
struct Multiples
{
  Multiples(const std::vector<std::array<int, 2>>& pairs, int modes)
    : Modes(modes)
    , Two(modes * modes)
    , Self(modes)
  {
    for (const std::array<int, 2>& pair : pairs)
    {
      for (int a = 0; a < modes; ++a)
      {
        for (int b = 0; b < modes; ++b)
        {
          this->Two[a * modes + b].push_back(MultipleOf(pair, a, b, modes));
        }
        this->Self[a].push_back(MultipleOf(pair, a, a, modes) / 2);
      }
    }
  }

  const std::vector<std::int64_t>& Of(int a, int b) const
  {
    return this->Two[(a - 1) * this->Modes + b - 1];
  }
  const std::vector<std::int64_t>& OfItself(int a) const { return this->Self[a - 1]; }

  int Modes;
  std::vector<std::vector<std::int64_t>> Two, Self;
};

// Sums the overlaps of all pairs up in the half grid
class MapSums
{
public:
  MapSums(const PackShare& share, const WeightedPairs& weighted,
    const std::vector<std::array<int, 2>>& pairs, const HalfGrid& grid, double spacing)
    : Share(share)
    , Weighted(weighted)
    , Grid(grid)
    , Spacing(spacing)
    , Scale(weighted.Scale / SphereVolume(share.LargestRadius) * (Pi / 12.0) * spacing * spacing *
        spacing)
    , Counts(pairs, share.NumberOfModes())
    , NumberOfImages(pairs.size())
  {
  }

  // Returns the sums of the centres of this rank, two limbs for each voxel (WideValue), image after
  // image
  std::vector<std::int64_t> Sum(Communicator& ranks, const SumProgress& progress) const
  {
    std::vector<std::int64_t> sums(2 * this->Grid.Size() * this->NumberOfImages, 0);
    // Every thread goes through all pairs and takes slices of its own, so that no thread needs
    // another image
    SumRounds rounds(this->Share.NumberOfSpheres, ranks, progress);
#pragma omp parallel
    this->SumSlices(omp_get_thread_num(), omp_get_num_threads(), rounds, sums);
    rounds.RequireEnd();
    return sums;
  }

private:
  void SumSlices(int first, int stride, SumRounds& rounds, std::vector<std::int64_t>& sums) const
  {
    const int slices = this->Grid.Half + 1;
    const int ownSlices = first < slices ? (slices - 1 - first) / stride + 1 : 0;
    const std::size_t ownSize = ownSlices * this->Grid.Slice();
    FixedPointSums own(ownSize * this->NumberOfImages);
    Ball ball(2.0 * this->Share.LargestRadius / this->Spacing, this->Grid);
    const std::size_t centres = ownSlices > 0 ? this->Weighted.Pairs.Size() : 0;
    for (int round = 0; rounds.GoOn(round); ++round)
    {
      const std::size_t last = rounds.Begin(round + 1, centres);
      for (std::size_t begin = rounds.Begin(round, centres); begin < last;
           begin += this->Weighted.Step)
      {
        this->AddCentres(begin, std::min(begin + this->Weighted.Step, last),
          { own.Take(this->Weighted.Terms), first, stride, ownSize }, ball);
      }
    }
    const std::vector<std::int64_t>& wide = own.Finish();
    const std::size_t slice = 2 * this->Grid.Slice();
    for (std::size_t image = 0; image < this->NumberOfImages; ++image)
    {
      for (int n = 0; n < ownSlices; ++n)
      {
        const auto from = wide.begin() + 2 * image * ownSize + n * slice;
        std::copy(from, from + slice,
          sums.begin() + 2 * image * this->Grid.Size() + (first + n * stride) * slice);
      }
    }
  }

  // Adds the pairs of the centres [begin, end), and each of these centres with itself
  void AddCentres(std::size_t begin, std::size_t end, const Images& images, Ball& ball) const
  {
    const SpherePack& own = this->Share.Own;
    for (std::size_t place = begin; place < end; ++place)
    {
      const std::size_t i = this->Weighted.Pairs.Own().Index[place];
      const double radius = own.Radius[i] / this->Spacing;
      AddBall(LensFormula(radius, radius), { 0.0, 0.0, 0.0 }, this->Scale, this->Grid, images,
        this->Counts.OfItself(own.Mode[i]), ball);
    }
    this->Weighted.ForEach(begin, end,
      [&](std::size_t i, const PairNeighbourhood::Part& part, std::size_t j, const Vector3& d,
        double, double weight)
      {
        const LensFormula lens(own.Radius[i] / this->Spacing, part.Pack.Radius[j] / this->Spacing);
        const double factor = 0.5 * this->Scale * weight;
        for (double sign : { 1.0, -1.0 })
        {
          const double x = sign / this->Spacing;
          const Vector3 lag = { x * d[0], x * d[1], x * d[2] };
          if (lag[2] + lens.Contact > 0.0)
          {
            AddBall(lens, lag, factor, this->Grid, images,
              this->Counts.Of(own.Mode[i], part.Pack.Mode[j]), ball);
          }
        }
      });
  }

  const PackShare& Share;
  const WeightedPairs& Weighted;
  const HalfGrid Grid;
  const double Spacing;
  const double Scale; // from the overlap of a pair to the integers that are summed
  const Multiples Counts;
  const std::size_t NumberOfImages;
};

// The values on the whole grid from the sums of an image, whose unit is `volumes`: S_rm = c_r - sum
// over s of S_rs, and S_mm = 1 - 2 sum over r of c_r + sum over r, s of S_rs
std::vector<double> WholeImage(const std::array<int, 2>& pair, const HalfGrid& grid,
  const std::int64_t* sums, double volumes, const std::vector<double>& fractions)
{
  const int matrix = static_cast<int>(fractions.size()) - 1;
  const int r = std::min(pair[0], pair[1]), s = std::max(pair[0], pair[1]);
  const double constant = s < matrix ? 0.0
    : r < matrix                     ? fractions[r]
                                     : 2.0 * fractions[matrix] - 1.0;
  const double factor = s == matrix && r < matrix ? -volumes : volumes;
  const std::size_t voxels = grid.Row() * grid.Slice(), centre = voxels / 2;
  std::vector<double> values(voxels);
  // Slice 0 has the rows up to the middle one, where j < 0 comes first
  for (std::size_t v = 0; v < grid.Size(); ++v)
  {
    const std::size_t inSlice = v % grid.Slice();
    if (v >= grid.Slice() || inSlice / grid.Row() <= static_cast<std::size_t>(grid.Half))
    {
      const std::size_t place = centre - grid.Slice() / 2 + v;
      const double value = constant + factor * WideValue(&sums[2 * v]);
      values[place] = value;
      values[voxels - 1 - place] = value;
    }
  }
  return values;
}
}

ProbabilityMap MapPairs(const PackShare& share, const std::vector<std::array<int, 2>>& pairs,
  double spacing, double reach, Communicator& ranks, const SumProgress& progress)
{
  CheckMap(share, pairs, spacing, reach);
  const HalfGrid grid = { static_cast<int>(reach / spacing * (1.0 + 1e-12)) };
  const double cube = grid.Half * spacing, rim = 2.0 * share.LargestRadius;
  const SizeClasses classes(share.Own.Radius, std::sqrt(3.0) * cube, 1.0, ranks);
  const WeightedPairs weighted(share, classes, ranks, "Spacing x Resolution", cube, rim);
  std::vector<std::int64_t> sums =
    MapSums(share, weighted, pairs, grid, spacing).Sum(ranks, progress);
  ranks.Sum(sums.data(), sums.size());

  ProbabilityMap map = { { grid.Half, grid.Half, grid.Half }, spacing, pairs, {} };
  const std::vector<double> fractions = OnePointProbability(share);
  const double volumes =
    SphereVolume(share.LargestRadius) / (weighted.Scale * share.Observed.Volume());
  for (std::size_t image = 0; image < pairs.size(); ++image)
  {
    map.Values.push_back(
      WholeImage(pairs[image], grid, &sums[2 * image * grid.Size()], volumes, fractions));
  }
  return map;
}

namespace
{
constexpr double SecondsPerPairOfMap = 3.3e-7;
constexpr double SecondsPerPairAndVoxel = 2.5e-9;
}

Estimate EstimateMap(const PackFigures& pack, double reach, int pairs, int resolution)
{
  const double spacing = reach / resolution, contact = 2.0 * pack.MeanRadius;
  const double voxels = SphereVolume(contact / spacing); // that a pair overlaps
  // There are as many pairs as in a ball of the cube's volume
  return { pack.PairsWithin(1.24 * (reach + contact)) *
      (SecondsPerPairOfMap + voxels * SecondsPerPairAndVoxel),
    24.0 * pairs * std::pow(2.0 * resolution + 1.0, 3) / BytesOfMegabyte, 0.0 };
}
}
