// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Voxels/ImageCorrelation.h"

#include "ruc/Base/Text.h"
#include "ruc/Images/FourierTransform.h"
#include "ruc/Statistics/Results/Phases.h"
#include "ruc/Statistics/Voxels/RadialFit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace ruc
{
namespace
{
using Triple = std::array<int, 3>;

constexpr double FarFromInteger = 0.1;

// The period of the transform: along an axis that is not periodic, no lag must come round
Triple TransformSize(const Triple& dimensions, const ImageSettings& settings)
{
  Triple size;
  for (int q = 0; q < 3; ++q)
  {
    size[q] = settings.Periodic[q]
      ? dimensions[q]
      : LineTransform::FastLength(dimensions[q] + settings.Lags.Last[q]);
  }
  return size;
}

// A_rs(x) + A_rs(-x), as integers, of all pairs of phases
class PairCounts
{
public:
  PairCounts(const ImageSettings& settings, Communicator& ranks)
    : Settings(settings)
    , Names(settings.Phases - 1, settings.Lags.Lags)
    , Slab{ settings.Lags.Last[2] + 1, ranks.Size() }
    , Rank(ranks.Rank())
    , Rows(2 * std::size_t(settings.Lags.Last[1]) + 1)
    , Row(2 * std::size_t(settings.Lags.Last[0]) + 1)
    , All(this->Slab.Size(this->Rank) * this->Rows * this->Row, 0)
    , Maps(settings.Maps.size())
  {
    this->Shells.assign(this->Names.Pairs(), {});
    this->Axes.assign(this->Names.Pairs(), {});
    for (std::int64_t z = this->Slab.Begin(this->Rank); z < this->Slab.End(this->Rank); ++z)
    {
      for (int y = -settings.Lags.Last[1]; y <= settings.Lags.Last[1]; ++y)
      {
        for (int x = -settings.Lags.Last[0]; x <= settings.Lags.Last[0]; ++x)
        {
          this->ShellOf.push_back(settings.Lags.ShellOf(x, y, static_cast<int>(z)));
        }
      }
    }
  }

  void Add(int r, int s, const FourierTransform& transform, const FourierTransform::Spectrum& ofR,
    const FourierTransform::Spectrum& ofS, Communicator& ranks)
  {
    const int pair = this->Names.PairOf(r, s);
    this->Shells[pair].assign(this->Settings.Lags.Shells(), 0);
    const auto map = std::find(this->Settings.Maps.begin(), this->Settings.Maps.end(),
      Triple2{ std::min(r, s), std::max(r, s) });
    std::vector<std::int64_t>* kept =
      map == this->Settings.Maps.end() ? nullptr : &this->Maps[map - this->Settings.Maps.begin()];
    if (kept)
    {
      kept->assign(this->All.size(), 0);
    }
    double farthest = 0.0;
    transform.Correlate(ofR, ofS, this->Settings.Lags.Last, ranks,
      [&](int z, const std::vector<double>& values)
      {
        const std::size_t begin = this->PlaceOf(z);
        for (std::size_t n = 0; n < values.size(); ++n)
        {
          const double rounded = std::rint(values[n]);
          farthest = std::max(farthest, std::abs(values[n] - rounded));
          const auto count = static_cast<std::int64_t>(rounded);
          // Both orders of a pair of two phases belong to all pairs
          this->All[begin + n] += r == s ? count : 2 * count;
          const int shell = this->ShellOf[begin + n];
          if (shell >= 0)
          {
            // The planes z < 0 are the same
            this->Shells[pair][shell] += z == 0 ? count : 2 * count;
          }
          if (kept)
          {
            (*kept)[begin + n] = count;
          }
        }
        this->AddAxes(z, values, this->Axes[pair]);
      });
    this->RequireIntegers(farthest, ranks);
    ranks.Sum(this->Shells[pair].data(), this->Shells[pair].size());
    ranks.Sum(this->Axes[pair].data(), this->Axes[pair].size());
  }

  ImageTwoPoint Finish(Communicator& ranks) const
  {
    ImageTwoPoint result = { this->Names, {}, {}, {} };
    TwoPointProbability& probability = result.Probability;
    std::vector<std::int64_t> all(this->Shells.front().size(), 0);
    for (int r = 0; r < probability.Phases(); ++r)
    {
      for (int s = r; s < probability.Phases(); ++s)
      {
        const std::vector<std::int64_t>& counts = this->Shells[probability.PairOf(r, s)];
        for (std::size_t n = 0; n < all.size(); ++n)
        {
          all[n] += (r == s ? 1 : 2) * counts[n];
        }
      }
    }
    if (all[0] == 0)
    {
      throw std::invalid_argument("The image requires voxels inside the mask, got none.");
    }
    const std::vector<double> lengths = this->Settings.Lags.ShellLengths();
    for (int r = 0; r < probability.Phases(); ++r)
    {
      for (int s = r; s < probability.Phases(); ++s)
      {
        const std::vector<std::int64_t>& counts = this->Shells[probability.PairOf(r, s)];
        std::vector<double> values(all.size());
        for (std::size_t n = 0; n < all.size(); ++n)
        {
          values[n] = static_cast<double>(counts[n]) / static_cast<double>(all[n]);
        }
        probability.S(r, s) = FitRadial(lengths, values, values[0], probability.Lags);
        if (r == s)
        {
          probability.Fractions[r] = values[0];
        }
      }
    }
    this->FindSurface(result);
    this->FindMaps(result, ranks);
    return result;
  }

private:
  using Triple2 = std::array<int, 2>;

  std::size_t PlaceOf(std::int64_t z) const
  {
    return static_cast<std::size_t>(z - this->Slab.Begin(this->Rank)) * this->Rows * this->Row;
  }

  // The counts one and two voxels away along each axis
  void AddAxes(int z, const std::vector<double>& values, std::array<std::int64_t, 6>& axes) const
  {
    const Triple& last = this->Settings.Lags.Last;
    const auto at = [&](int x, int y) {
      return std::llrint(values[(std::size_t(y) + last[1]) * this->Row + std::size_t(x) + last[0]]);
    };
    for (int j = 1; j <= 2; ++j)
    {
      if (z == 0 && last[0] >= j)
      {
        axes[j - 1] += at(j, 0);
      }
      if (z == 0 && last[1] >= j)
      {
        axes[2 + j - 1] += at(0, j);
      }
      if (z == j)
      {
        axes[4 + j - 1] += at(0, 0);
      }
    }
  }

  static void RequireIntegers(double farthest, Communicator& ranks)
  {
    double least = -farthest;
    ranks.Minimum(&least, 1);
    if (!(-least <= FarFromInteger))
    {
      throw std::invalid_argument(Text("Counts of voxels require transforms that are exact to ",
        FarFromInteger, ", got ", -least, ": the image is too large for double precision."));
    }
  }

  // The share of the pairs `j` voxels apart along an axis whose first voxel alone is in phase r
  double ShareApart(int r, int axis, int j) const
  {
    std::int64_t all = 0, apart = 0;
    for (int s = 0; s < this->Names.Phases(); ++s)
    {
      for (int t = s; t < this->Names.Phases(); ++t)
      {
        const std::int64_t count = this->Axes[this->Names.PairOf(s, t)][2 * axis + j - 1];
        all += s == t ? count : 2 * count;
        apart += s != t && (s == r || t == r) ? count : 0;
      }
    }
    return static_cast<double>(apart) / static_cast<double>(all);
  }

  void FindSurface(ImageTwoPoint& result) const
  {
    for (int r = 0; r < this->Names.Phases(); ++r)
    {
      double one = 0.0, extrapolated = 0.0, axes = 0.0;
      for (int q = 0; q < 3; ++q)
      {
        if (this->Settings.Lags.Last[q] >= 2)
        {
          const double p1 = this->ShareApart(r, q, 1), p2 = this->ShareApart(r, q, 2);
          one += 4.0 * p1 / this->Settings.Lags.Spacing[q];
          extrapolated += (8.0 * p1 - 2.0 * p2) / this->Settings.Lags.Spacing[q];
          axes += 1.0;
        }
      }
      // Without any axis, 0 / 0
      result.SurfaceAtOneVoxel.push_back(one / axes);
      result.Surface.push_back(extrapolated / axes);
    }
  }

  // Puts the planes of all ranks together, and those with z < 0 before them
  void FindMaps(ImageTwoPoint& result, Communicator& ranks) const
  {
    for (const std::vector<std::int64_t>& own : this->Maps)
    {
      std::vector<double> half;
      for (std::size_t n = 0; n < own.size(); ++n)
      {
        half.push_back(static_cast<double>(own[n]) / static_cast<double>(this->All[n]));
      }
      half = ranks.Concatenate(half);
      std::vector<double> whole(half.rbegin(), half.rend());
      whole.insert(whole.end(), half.begin() + this->Rows * this->Row, half.end());
      result.Maps.push_back(std::move(whole));
    }
  }

  const ImageSettings& Settings;
  const TwoPointProbability Names; // of the pairs
  const Slabs Slab;                // planes of lags
  const int Rank;
  const std::size_t Rows, Row;
  std::vector<std::int64_t> All;               // 2 W at the lags of this rank
  std::vector<std::vector<std::int64_t>> Maps; // counts at the lags of this rank
  std::vector<int> ShellOf;                    // of these lags
  std::vector<std::vector<std::int64_t>> Shells;
  std::vector<std::array<std::int64_t, 6>> Axes;
};

// How many of the `left` phases stay in so many places, while each phase after them comes to all of
// these in one place more. The last of them stays for the next group.
int GroupOf(int left, int places)
{
  return left <= places ? left : places - 1;
}

double NumberOfSpectra(int phases, int places)
{
  double made = 0.0;
  for (int left = phases; left > 0; left -= GroupOf(left, places))
  {
    made += left < phases ? left - 1 : left;
  }
  return made;
}

// The time of a spectrum over that of a product, for the progress
constexpr double SpectrumOverProduct = 3.0;
}

ImageTwoPoint CorrelateImage(const PhaseSlab& image, const ImageSettings& settings,
  Communicator& ranks, const std::function<bool(double)>& progress)
{
  const FourierTransform transform(
    TransformSize(image.Dimensions, settings), image.Dimensions, ranks);
  const int phases = settings.Phases;
  const int places = std::min(settings.Spectra, phases);
  const double work =
    SpectrumOverProduct * NumberOfSpectra(phases, places) + 0.5 * phases * (phases + 1.0);
  double done = 0.0;
  const auto tell = [&](double more)
  {
    done += more;
    if (!ranks.All(!progress || progress(std::min(1.0, done / work))))
    {
      throw std::invalid_argument("The statistics of the image were stopped before their end.");
    }
  };
  const auto make = [&](int phase, FourierTransform::Spectrum& spectrum)
  {
    transform.Forward(
      [&](int y, int z, double* line)
      {
        const std::uint8_t* row = image.Row(z, y);
        for (int x = 0; x < image.Dimensions[0]; ++x)
        {
          line[x] = row[x] == phase ? 1.0 : 0.0;
        }
      },
      spectrum, ranks);
    tell(SpectrumOverProduct);
  };
  PairCounts counts(settings, ranks);
  const auto correlate =
    [&](int r, int s, const FourierTransform::Spectrum& ofR, const FourierTransform::Spectrum& ofS)
  {
    counts.Add(r, s, transform, ofR, ofS, ranks);
    tell(1.0);
  };

  std::vector<FourierTransform::Spectrum> group(places);
  std::vector<int> left(phases);
  std::iota(left.begin(), left.end(), 0);
  while (!left.empty())
  {
    const int staying = GroupOf(static_cast<int>(left.size()), places);
    for (int n = 0; n < static_cast<int>(left.size()); ++n)
    {
      FourierTransform::Spectrum& spectrum = n < staying ? group[n] : group.back();
      if (n > 0 || static_cast<int>(left.size()) == phases)
      {
        make(left[n], spectrum);
      }
      for (int m = 0; m < std::min(n + 1, staying); ++m)
      {
        correlate(left[m], left[n], group[m], spectrum);
      }
    }
    // The last phase is the first of the next group
    std::swap(group.front(), group.back());
    std::rotate(left.begin(), left.begin() + staying, left.end());
    left.resize(left.size() - staying);
    std::rotate(left.begin(), left.end() - (left.empty() ? 0 : 1), left.end());
  }
  return counts.Finish(ranks);
}

ImageWork::ImageWork(const Triple& dimensions, const ImageSettings& settings, int ranks)
  : Phases(settings.Phases)
  , Maps(static_cast<int>(settings.Maps.size()))
  , Shells(settings.Lags.Shells())
{
  const Triple size = TransformSize(dimensions, settings);
  const Triple& last = settings.Lags.Last;
  this->Padded = static_cast<double>(size[0]) * size[1] * size[2];
  this->Lags = (last[2] + 1.0) / size[2];
  this->MapVoxels = (2.0 * last[0] + 1.0) * (2.0 * last[1] + 1.0) * (2.0 * last[2] + 1.0);
  // Half of the frequencies along x, rounded up to whole blocks, in pairs of numbers
  const double columns =
    (size[0] / 2 / LineTransform::Lanes + 1.0) * LineTransform::Lanes * size[1];
  this->MegabytesOfSpectrum =
    (columns / ranks + 2 * LineTransform::Lanes) * 16.0 * size[2] / BytesOfMegabyte;
  // Planes of lags twice, as they are sent and come; on one rank they stay where they are
  const double planes = columns * 16.0 * (last[2] + ranks) / ranks * (ranks > 1 ? 3.0 : 1.0);
  const double pairs = PairsOfPhases(this->Phases - 1);
  const double counts = this->MapVoxels / 2.0 / ranks * (12.0 + 8.0 * this->Maps) +
    this->MapVoxels * 16.0 * this->Maps + pairs * 8.0 * this->Shells;
  this->MegabytesBeside = 40.0 + (planes + counts) / BytesOfMegabyte;
}

int ImageWork::SpectraWithin(double megabytes) const
{
  const double fit = (megabytes - this->MegabytesBeside) / this->MegabytesOfSpectrum;
  return static_cast<int>(std::clamp(fit, 0.0, static_cast<double>(this->Phases)));
}

Estimate ImageWork::ForSpectra(int spectra) const
{
  // Nanoseconds of a number of a transform: of a spectrum, and of a product that is transformed
  // back to planes of lags
  constexpr double ofSpectrum = 10e-9, ofProduct = 4.5e-9;
  Estimate estimate;
  estimate.Seconds = this->Padded *
    (ofSpectrum * NumberOfSpectra(this->Phases, std::max(spectra, 2)) +
      ofProduct * PairsOfPhases(this->Phases - 1));
  estimate.MegabytesOfRank = this->MegabytesBeside + spectra * this->MegabytesOfSpectrum;
  return estimate;
}
}
