// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/PairHistogram.h"

#include "Oracles.h"
#include "ruc/Particles/SphereOverlap.h"
#include "ruc/Statistics/PairSums/PairLoops.h"

TEST(PairHistogram, EveryUnorderedPairOfTypesIsAClass)
{
  const std::vector<ruc::SphereType> types = { { 1, 1.0 }, { 1, 1.1 }, { 2, 0.5 } };
  const ruc::PairHistogram histogram(types, { 0.1, 30 });
  ASSERT_EQ(histogram.NumberOfClasses(), 6);
  std::size_t size = 0;
  int c = 0;
  for (int p = 0; p < 3; ++p)
  {
    for (int q = p; q < 3; ++q, ++c)
    {
      EXPECT_EQ(histogram.LowerType(c), types[p]);
      EXPECT_EQ(histogram.HigherType(c), types[q]);
      EXPECT_EQ(histogram.Begin(c), size);
      size += histogram.Kernel(c).Size();
      for (const auto& lookup : { histogram.LookupRow(p)[q], histogram.LookupRow(q)[p] })
      {
        EXPECT_EQ(std::size_t(lookup.Begin), histogram.Begin(c));
        EXPECT_NEAR(1.7 * lookup.InverseSpacing + lookup.Shift,
          (1.7 - histogram.Kernel(c).First) / histogram.Kernel(c).Spacing, 1e-12);
        // From there on there is no overlap at any lag
        const ruc::PairKernel& kernel = histogram.Kernel(c);
        EXPECT_GE(kernel.First + std::floor(lookup.Last) * kernel.Spacing,
          3.0 + types[p].Radius + types[q].Radius);
        EXPECT_LT(lookup.Last, kernel.Intervals);
      }
    }
  }
  EXPECT_EQ(histogram.Size(), size);
}

TEST(PairHistogram, FixedPointScaleCannotOverflow)
{
  for (double heaviest : { 1e-9, 0.3, 1.0, 1.7, 1000.0, 1e12 })
  {
    for (std::int64_t spheres : { std::int64_t(1), std::int64_t(1081), std::int64_t(3000000) })
    {
      for (std::int64_t neighbours : { std::int64_t(1), std::int64_t(777), std::int64_t(1000000) })
      {
        const double scale = ruc::PairHistogram::FixedPointScale(spheres, neighbours, heaviest);
        EXPECT_EQ(std::exp2(std::round(std::log2(scale))), scale) << "no power of two";
        EXPECT_LE(scale * heaviest * spheres * neighbours, 0x1p62);
        EXPECT_LE(scale * heaviest, 0x1p50);
        // No factor of 4 is given away
        EXPECT_TRUE(4.0 * scale * heaviest * spheres * neighbours >= 0x1p62 ||
          4.0 * scale * heaviest >= 0x1p50);
      }
    }
  }
}

TEST(PairHistogram, CountedPairsGiveTheSumOfTheirOverlaps)
{
  const ruc::Window box = oracle::PeriodicCube(7.3);
  const std::vector<ruc::SphereType> types = { { 1, 1.0 }, { 2, 0.6 } };
  const ruc::SpherePack pack = oracle::RelaxedPack({ 12, 25 }, { 1.0, 0.6 }, box, 3);
  const ruc::LagGrid lags = { 0.25, 20 };
  const ruc::PairHistogram histogram(types, lags);
  // Farther than lags and contact reach, which adds nothing
  const double cutoff = 20 * 0.25 + 2.0 + 1.7;
  const ruc::CellList cells(pack, box, cutoff);
  std::vector<std::int32_t> typeOfPlace;
  for (std::uint32_t i : cells.Index)
  {
    typeOfPlace.push_back(pack.Mode[i] - 1);
  }
  const double scale =
    ruc::PairHistogram::FixedPointScale(pack.Size(), cells.MostNeighbours(), 1.0);
  std::vector<std::int64_t> counts(histogram.Size(), 0);
  ruc::CountPairs(histogram, cells, typeOfPlace, scale, 0, cells.Size(), counts.data());

  std::vector<std::vector<double>> expected(3, std::vector<double>(lags.Count + 1, 0.0));
  std::vector<double> pairs(3, 0.0);
  oracle::ForEachPair(pack, box, cutoff,
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    {
      const int c = pack.Mode[i] + pack.Mode[j] - 2;
      ++pairs[c];
      for (int k = 0; k <= lags.Count; ++k)
      {
        expected[c][k] +=
          ruc::OrientationAveragedOverlap(pack.Radius[i], pack.Radius[j], k * lags.Spacing, d)
            .Value;
      }
    });
  for (int c = 0; c < 3; ++c)
  {
    std::vector<double> weights, sums(lags.Count + 1, 0.0);
    double number = 0.0;
    for (std::size_t n = histogram.Begin(c); n < histogram.Begin(c + 1); ++n)
    {
      weights.push_back(counts[n] / scale);
      number += n % 2 == histogram.Begin(c) % 2 ? weights.back() : 0.0;
    }
    EXPECT_NEAR(number, pairs[c], 1e-6); // the two value weights of a pair add up to 1
    histogram.Kernel(c).AddOverlap(weights.data(), sums.data());
    for (int k = 0; k <= lags.Count; ++k)
    {
      EXPECT_NEAR(sums[k], expected[c][k], 1e-6 * pairs[c] * ruc::SphereVolume(0.6))
        << c << " " << k;
    }
  }
}

TEST(PairHistogram, SizesThatAreTooDifferentAreRefused)
{
  EXPECT_SAYS(ruc::PairHistogram({ { 1, 1.0 }, { 2, 1e-9 } }, { 0.1, 30 }),
    "The radii of the modes require tables of at most 1.07374e+09 numbers, got");
}
