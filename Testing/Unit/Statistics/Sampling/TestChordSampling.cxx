// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/ChordSampling.h"

#include "Oracles.h"
#include "SampledComparison.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Window/Directions.h"

#include <omp.h>

namespace
{
using oracle::Pi;
using ruc::LagGrid;
using ruc::SampledTwoPoint;
using ruc::SamplingRegion;
using ruc::SpherePack;
using ruc::TwoPointProbability;
using ruc::Window;

SampledTwoPoint Chords(const SpherePack& pack, int modes, const SamplingRegion& region,
  const LagGrid& lags, std::int64_t lines, std::uint32_t seed = 1)
{
  ruc::Communicator serial;
  return ruc::SampleChords(pack, modes, region, lags, { seed, lines, 0.0 }, serial);
}
}

TEST(ChordSampling, AgreesWithTheExactSumOfAPeriodicPack)
{
  // The box is half as long along the last axis, and lags reach beyond its edge
  const Window box = Window::MakeBox({ -3, 1, 2 }, { 8.0, 6.0, 4.0 }, { true, true, true });
  const SpherePack pack = oracle::RelaxedPack({ 12, 20 }, { 0.9, 0.5 }, box, 3);
  const LagGrid lags = { 0.25, 20 };
  const SampledTwoPoint sampled = Chords(pack, 2, SamplingRegion(box, 0.0), lags, 6400);
  ExpectWithinErrors(sampled, ruc::SumPairs(pack, box, lags), 5.0);
  EXPECT_NEAR(sampled.Samples, 6400.0, 640.0); // rows and columns of lines are whole numbers
  // The total error is the sum over all pairs that it is said to be
  double total = 0.0;
  for (int r = 0; r < 3; ++r)
  {
    for (int s = 0; s < 3; ++s)
    {
      total += ruc::DiscreteNorm(sampled.Errors[sampled.Mean.PairOf(r, s)]);
    }
  }
  EXPECT_NEAR(sampled.TotalError, total, 1e-14);
}

TEST(ChordSampling, StandardErrorsCover)
{
  const OneThread alone;
  // Of 200 independent runs 68.3 % and 95.4 % are to be within one and two standard errors (67.9
  // and 95.0 % with 64 batches): 136 and 190, with binomial standard deviations of 6.6 and 3.1. The
  // bounds are 3.5 of these away; 6 quantities are looked at.
  const Window box = oracle::PeriodicCube(4.0);
  const SpherePack pack = oracle::RelaxedPack({ 6, 12 }, { 0.8, 0.5 }, box, 4);
  const LagGrid lags = { 0.4, 4 };
  const TwoPointProbability exact = ruc::SumPairs(pack, box, lags);
  const SamplingRegion region(box, 0.0);
  const int pairs[][3] = { { 0, 0, 0 }, { 2, 2, 0 }, { 0, 1, 3 }, { 2, 2, 2 }, { 0, 2, 4 },
    { 1, 1, 1 } };
  int within[6][2] = {};
  for (std::uint32_t seed = 1; seed <= 200; ++seed)
  {
    const SampledTwoPoint sampled = Chords(pack, 2, region, lags, 640, seed);
    for (int n = 0; n < 6; ++n)
    {
      const auto [r, s, k] = pairs[n];
      const double off = std::abs(sampled.Mean.S(r, s)[k] - exact.S(r, s)[k]) /
        sampled.Errors[exact.PairOf(r, s)][k];
      within[n][0] += off < 1.0;
      within[n][1] += off < 2.0;
    }
  }
  for (const auto& counts : within)
  {
    EXPECT_NEAR(counts[0], 136, 23);
    EXPECT_NEAR(counts[1], 190, 11);
  }
}

TEST(ChordSampling, BooleanModel)
{
  ExpectBooleanModel([](const SpherePack& pack, const SamplingRegion& region, const LagGrid& lags,
                       std::uint32_t seed) { return Chords(pack, 1, region, lags, 640, seed); });
}

namespace
{
// A sampled region is that of a periodic pack, so every estimate has the same mean, but for the
// place of the region: averaged out by putting it anywhere. Spheres that reach in from outside are
// images, which a periodic window knows of and others must be given.
class RegionOfAPeriodicPack : public testing::Test
{
protected:
  const Window Cube = oracle::PeriodicCube(6.0);
  const SpherePack Pack = oracle::RelaxedPack({ 10, 20 }, { 0.9, 0.6 }, Cube, 5);
  const SpherePack Tiled = oracle::WithImages(Pack, 6.0);
  const LagGrid Lags = { 0.5, 4 };

  template <class RegionAt, class PackAt>
  void ExpectSameMean(RegionAt&& regionAt, PackAt&& packAt) const
  {
    constexpr int places = 40;
    const OneThread alone;
    const TwoPointProbability exact = ruc::SumPairs(this->Pack, this->Cube, this->Lags);
    std::vector<MeanFunction> means(exact.Pairs(), MeanFunction(this->Lags.Count + 1));
    oracle::Uniform random(3);
    for (int n = 0; n < places; ++n)
    {
      const ruc::Vector3 at = { random(0, 6), random(0, 6), random(0, 6) };
      const SampledTwoPoint sampled = Chords(packAt(at), 2, regionAt(at), this->Lags, 320, n + 1);
      for (int p = 0; p < exact.Pairs(); ++p)
      {
        means[p].Add(sampled.Mean.Values[p]);
      }
    }
    for (int p = 0; p < exact.Pairs(); ++p)
    {
      for (int k = 0; k <= this->Lags.Count; ++k)
      {
        // The estimates are ratios, of a bias of the order of their variance; 1e-3 allows for it
        EXPECT_NEAR(means[p].Value(k), exact.Values[p][k], 4.5 * means[p].Error(k) + 1e-3)
          << p << " " << k;
      }
    }
  }

  // The pack with its images on all sides
  template <class RegionAt>
  void ExpectSameMean(RegionAt&& regionAt) const
  {
    this->ExpectSameMean(
      regionAt, [&](const ruc::Vector3&) -> const SpherePack& { return this->Tiled; });
  }
};
}

TEST_F(RegionOfAPeriodicPack, Box)
{
  this->ExpectSameMean(
    [](const ruc::Vector3& at)
    {
      return SamplingRegion(
        Window::MakeBox({ at[0] - 3, at[1] - 3, at[2] - 3 }, { 5, 6, 7 }, { false, false, false }),
        1.0);
    });
}

TEST_F(RegionOfAPeriodicPack, Cylinder)
{
  this->ExpectSameMean(
    [](const ruc::Vector3& at)
    {
      return SamplingRegion(
        Window::MakeCylinder({ at[0] - 2, at[1] - 1, at[2] - 2 }, { 1, -0.5, 1 }, 2.5, 5.0), 1.0);
    });
}

TEST_F(RegionOfAPeriodicPack, PlateWithAHoleAndANotch)
{
  std::vector<std::uint8_t> inside(10 * 10 * 6, 1);
  for (int n = 0; n < 600; ++n)
  {
    const int x = n % 10, y = n / 10 % 10;
    inside[n] = !(x > 3 && x < 6 && y > 3 && y < 6) && !(x > 7 && y < 3);
  }
  this->ExpectSameMean(
    [&](const ruc::Vector3& at)
    {
      return SamplingRegion(ruc::VoxelMask({ 10, 10, 6 }, { at[0] - 3, at[1] - 3, at[2] - 2 },
                              { 0.6, 0.6, 0.6 }, inside),
        0.0);
    });
}

TEST_F(RegionOfAPeriodicPack, PartlyPeriodicBox)
{
  // Spheres once along x and y, and as tiled along z
  this->ExpectSameMean(
    [](const ruc::Vector3& at)
    {
      return SamplingRegion(
        Window::MakeBox({ at[0], at[1], at[2] - 3 }, { 6, 6, 6 }, { true, true, false }), 0.0);
    },
    [&](const ruc::Vector3& at)
    {
      SpherePack column;
      for (std::size_t i = 0; i < this->Tiled.Size(); ++i)
      {
        if (this->Tiled.X[i] >= at[0] && this->Tiled.X[i] < at[0] + 6 &&
          this->Tiled.Y[i] >= at[1] && this->Tiled.Y[i] < at[1] + 6)
        {
          column.Append(this->Tiled, i);
        }
      }
      return column;
    });
}

TEST(ChordSampling, AMaskOfABoxGivesTheResultOfTheBox)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 4, 5, 6 }, { false, false, false });
  const SpherePack pack = oracle::RandomPack({ 20, 20 }, { 0.7, 0.4 }, box, 3);
  const LagGrid lags = { 0.25, 8 };
  const SampledTwoPoint a = Chords(pack, 2, SamplingRegion(box, 0.5), lags, 640);
  const SampledTwoPoint b = Chords(pack, 2,
    SamplingRegion(ruc::VoxelMask({ 16, 20, 24 }, { 0, 0, 0 }, { 0.25, 0.25, 0.25 },
                     std::vector<std::uint8_t>(16 * 20 * 24, 1)),
      0.5),
    lags, 640);
  for (int p = 0; p < a.Mean.Pairs(); ++p)
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      // The ends of lines differ by rounding errors
      EXPECT_NEAR(a.Mean.Values[p][k], b.Mean.Values[p][k], 1e-12);
    }
  }
}

TEST(ChordSampling, OverlapIsCountedOnceAndGoesToTheLowestMode)
{
  // Concentric spheres: the small one of the higher mode is not seen, that of the lower mode is.
  const Window box = oracle::PeriodicCube(3.0);
  const SpherePack pack = oracle::RandomPack({ 1 }, { 1.0 }, box, 1);
  SpherePack oneMode = pack;
  oneMode.Append(pack, 0);
  oneMode.Radius[1] = 0.6;
  SpherePack both = oneMode;
  both.Mode[1] = 2;
  const LagGrid lags = { 0.3, 6 };
  const SamplingRegion region(box, 0.0);
  const SampledTwoPoint one = Chords(oneMode, 1, region, lags, 640);
  const SampledTwoPoint hidden = Chords(both, 2, region, lags, 640);
  EXPECT_EQ(hidden.Mean.Fractions[1], 0.0);
  EXPECT_EQ(hidden.Mean.S(0, 0), one.Mean.S(0, 0));
  EXPECT_EQ(hidden.Mean.S(2, 2), one.Mean.S(1, 1));
  std::swap(both.Mode[0], both.Mode[1]);
  const SampledTwoPoint seen = Chords(both, 2, region, lags, 6400);
  const double small = 4.0 / 3.0 * Pi * 0.216 / 27.0, large = 4.0 / 3.0 * Pi / 27.0;
  EXPECT_NEAR(seen.Mean.Fractions[0], small, 4.0 * seen.FractionErrors[0]);
  EXPECT_NEAR(seen.Mean.Fractions[1], large - small, 4.0 * seen.FractionErrors[1]);
}

TEST(ChordSampling, RanksAndThreadsGiveEqualResults)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 5, 6, 7 }, { true, true, true });
  const SpherePack pack = oracle::RandomPack({ 15, 40 }, { 0.9, 0.5 }, box, 3); // overlapping
  const LagGrid lags = { 0.3, 12 };
  std::vector<std::uint8_t> voxels(10 * 12 * 14, 1);
  std::fill(voxels.begin() + 500, voxels.begin() + 800, 0);
  const SamplingRegion regions[] = { SamplingRegion(box, 0.0),
    SamplingRegion(Window::MakeBox({ 0, 0, 0 }, { 5, 6, 7 }, { false, true, false }), 0.5),
    SamplingRegion(ruc::VoxelMask({ 10, 12, 14 }, { 0, 0, 0 }, { 0.5, 0.5, 0.5 }, voxels), 0.0) };
  const ruc::SamplingSettings fixed = { 5, 1000, 0.0 }, aimed = { 5, 0, 0.15 };
  for (const SamplingRegion& region : regions)
  {
    for (const ruc::SamplingSettings& settings : { fixed, aimed })
    {
      ExpectEqualForRanksAndThreads(pack,
        [&](const SpherePack& own, ruc::Communicator& ranks)
        { return ruc::SampleChords(own, 2, region, lags, settings, ranks); });
    }
  }
  ExpectEqualForRanksAndThreads(pack,
    [&](const SpherePack& own, ruc::Communicator& ranks)
    {
      return ruc::SampleChordsAlong(
        ruc::EvenDirections(2), own, 2, regions[0], lags, { 5, 100, 0.0 }, ranks)[1];
    });
}

TEST(ChordSampling, ReachesItsTargetError)
{
  const Window box = oracle::PeriodicCube(5.0);
  const SpherePack pack = oracle::RelaxedPack({ 20 }, { 0.7 }, box, 3);
  const LagGrid lags = { 0.25, 10 };
  const SamplingRegion region(box, 0.0);
  ruc::Communicator serial;
  const SampledTwoPoint sampled = ruc::SampleChords(pack, 1, region, lags, { 1, 0, 0.01 }, serial);
  EXPECT_LE(sampled.TotalError, 0.01);
  EXPECT_GT(sampled.TotalError, 0.008);
  // F2 against the exact sum is of the order of the total error, by its meaning
  EXPECT_LT(ruc::TwoPointDifference(sampled.Mean, ruc::SumPairs(pack, box, lags)), 3.0 * 0.01);
  EXPECT_SAYS(ruc::SampleChords(pack, 1, region, lags, { 1, 0, 1e-6 }, serial),
    "TargetError requires at least about");
}

TEST(ChordSampling, FractionsAlone)
{
  const Window box = oracle::PeriodicCube(5.0);
  const SpherePack pack = oracle::RelaxedPack({ 20 }, { 0.7 }, box, 3);
  const SampledTwoPoint sampled = Chords(pack, 1, SamplingRegion(box, 0.0), { 0.0, 0 }, 3200);
  const double fraction = 20.0 * 4.0 / 3.0 * Pi * 0.343 / 125.0;
  EXPECT_NEAR(sampled.Mean.Fractions[0], fraction, 4.0 * sampled.FractionErrors[0]);
  EXPECT_EQ(sampled.TotalError, sampled.FractionErrors[0] + sampled.FractionErrors[1]);
  // Without any sphere there is the matrix alone, known exactly
  const SampledTwoPoint empty = Chords({}, 0, SamplingRegion(box, 0.0), { 0.5, 3 }, 100);
  EXPECT_EQ(empty.Mean.S(0, 0), std::vector<double>(4, 1.0));
}

TEST(ChordSampling, DirectionsTellAnAnisotropicPack)
{
  // Planes of touching spheres. Along x, S_00(r, x) of one sphere a cell is the lens volume of the
  // sphere with its images along x alone; along the diagonal of the cube there is no image in
  // reach.
  const Window box = oracle::PeriodicCube(2.0);
  SpherePack pack = oracle::RandomPack({ 1 }, { 0.9 }, box, 1);
  const LagGrid lags = { 0.2, 10 };
  ruc::Communicator serial;
  std::vector<double> done;
  const double d = 1.0 / std::sqrt(3.0);
  const std::vector<SampledTwoPoint> along = ruc::SampleChordsAlong({ { 1, 0, 0 }, { d, d, d } },
    pack, 1, SamplingRegion(box, 0.0), lags, { 1, 6400, 0.0 }, serial,
    [&](double share, const std::string&)
    {
      done.push_back(share);
      return true;
    });
  ASSERT_EQ(along.size(), 2u);
  for (int n : { 0, 1 })
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      double expected = 0.0;
      for (int x = -2; x <= 2; ++x)
      {
        for (int y = -2; y <= 2; ++y)
        {
          for (int z = -2; z <= 2; ++z)
          {
            const double r = k * lags.Spacing;
            const double step[3] = { n == 0 ? r : d * r, n == 0 ? 0.0 : d * r,
              n == 0 ? 0.0 : d * r };
            expected += oracle::LensVolume(0.9, 0.9,
                          std::hypot(step[0] - 2.0 * x, step[1] - 2.0 * y, step[2] - 2.0 * z)) /
              8.0;
          }
        }
      }
      EXPECT_NEAR(along[n].Mean.S(0, 0)[k], expected, 4.5 * along[n].Errors[0][k] + 1e-12);
    }
  }
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.back(), 1.0);
}

TEST(ChordSampling, RefusesBadInputOnAllRanks)
{
  const SamplingRegion region(oracle::PeriodicCube(5.0), 0.0);
  oracle::ThreadRanks::Run(2,
    [&](ruc::Communicator& ranks)
    {
      const SpherePack none;
      EXPECT_SAYS(ruc::SampleChords(none, 1, region, { 1.0, 2 }, { 1, 0, 0.0 }, ranks),
        "NumberOfLines requires a number >= 2, without which no standard error is known, got 0.");
      EXPECT_SAYS(ruc::SampleChords(none, 1, region, { 1.0, 21 }, { 1, 9, 0.0 }, ranks),
        "MaximumLag requires 0 < MaximumLag <= 20, got 21.");
      EXPECT_SAYS(ruc::SampleChordsAlong({}, none, 1, region, { 1.0, 2 }, { 1, 9, -2.0 }, ranks),
        "TargetError requires a finite number >= 0, got -2.");
      ruc::ChordLengths lengths;
      EXPECT_SAYS(
        ruc::SampleChords(none, 1, region, { 1.0, 0 }, { 1, 9, 0.0 }, ranks, {}, &lengths),
        "Chord lengths require NumberOfLags >= 1, got 0.");
    });
}

// One centre far away from the others, so that the bounds of the centres are a rod: the square grid
// around it has some 10^9 places for every 4096 lines
TEST(ChordSampling, RefusesARegionThatIsTooLongForItsWidth)
{
  const Window rod = Window::MakeBox({ 0, 0, 0 }, { 1e7, 10.0, 10.0 }, { false, false, false });
  SpherePack pack = oracle::RandomPack(
    { 300 }, { 0.4 }, Window::MakeBox({ 0, 0, 0 }, { 10, 10, 10 }, { false, false, false }), 5);
  pack.X[0] = 1e7 - 1.0;
  EXPECT_SAYS(Chords(pack, 1, SamplingRegion(rod, 0.4), { 0.1, 10 }, 20000),
    "Chord Sampling requires a region whose lines lie in a grid of at most 2.5e+07 places, got ");
  const Window bar = Window::MakeBox({ 0, 0, 0 }, { 1e3, 10.0, 10.0 }, { false, false, false });
  pack.X[0] = 999.0;
  EXPECT_NO_THROW(Chords(pack, 1, SamplingRegion(bar, 0.4), { 0.1, 10 }, 2000));
}
