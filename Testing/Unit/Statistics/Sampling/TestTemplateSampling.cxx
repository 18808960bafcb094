// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/TemplateSampling.h"

#include "Oracles.h"
#include "SampledComparison.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"
#include "ruc/Statistics/Sampling/ChordSampling.h"

namespace
{
using ruc::LagGrid;
using ruc::SampledTwoPoint;
using ruc::SamplingRegion;
using ruc::SpherePack;
using ruc::Window;
}

TEST(TemplateSampling, AgreesWithTheExactSumOfAPeriodicPack)
{
  const Window box = Window::MakeBox({ -3, 1, 2 }, { 8.0, 6.0, 4.0 }, { true, true, true });
  const SpherePack pack = oracle::RelaxedPack({ 12, 20 }, { 0.9, 0.5 }, box, 3);
  const LagGrid lags = { 0.5, 10 };
  ruc::Communicator serial;
  const SampledTwoPoint sampled =
    ruc::SampleTemplate(pack, 2, SamplingRegion(box, 0.0), lags, { 1, 3200, 0.0 }, serial);
  ExpectWithinErrors(sampled, ruc::SumPairs(pack, box, lags), 5.0);
  EXPECT_EQ(sampled.Samples, 3200);
  // Its throws know a fraction by the centre alone: the standard error is that of a toss of coins,
  // itself uncertain by 1 / sqrt(2 x 100 batches).
  const double fraction = sampled.Mean.Fractions[2];
  const double toss = std::sqrt(fraction * (1.0 - fraction) / 3200.0);
  EXPECT_NEAR(sampled.FractionErrors[2], toss, 4.0 * toss / std::sqrt(200.0));
}

TEST(TemplateSampling, AgreesWithChordsInOneRegion)
{
  // Overlapping spheres and a mask with a hole: no other oracle
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 6, 6, 6 }, { false, false, false });
  const SpherePack pack = oracle::RandomPack({ 30, 30 }, { 0.9, 0.6 }, box, 3);
  std::vector<std::uint8_t> inside(6 * 6 * 6, 1);
  inside[2 + 6 * (3 + 6 * 2)] = inside[5] = inside[4] = 0;
  const SamplingRegion region(ruc::VoxelMask({ 6, 6, 6 }, { 0, 0, 0 }, { 1, 1, 1 }, inside), 0.0);
  const LagGrid lags = { 0.5, 8 };
  ruc::Communicator serial;
  const SampledTwoPoint thrown =
    ruc::SampleTemplate(pack, 2, region, lags, { 1, 3200, 0.0 }, serial);
  const SampledTwoPoint chords = ruc::SampleChords(pack, 2, region, lags, { 2, 6400, 0.0 }, serial);
  for (int p = 0; p < thrown.Mean.Pairs(); ++p)
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      EXPECT_NEAR(thrown.Mean.Values[p][k], chords.Mean.Values[p][k],
        4.5 * std::hypot(thrown.Errors[p][k], chords.Errors[p][k]) + 1e-12)
        << p << " " << k;
    }
  }
}

TEST(TemplateSampling, BooleanModel)
{
  ExpectBooleanModel(
    [](
      const SpherePack& pack, const SamplingRegion& region, const LagGrid& lags, std::uint32_t seed)
    {
      ruc::Communicator serial;
      return ruc::SampleTemplate(pack, 1, region, lags, { seed, 640, 0.0 }, serial);
    });
}

TEST(TemplateSampling, StandardErrorsCover)
{
  const OneThread alone;
  // As for chords: 136 and 190 of 200, with bounds 3.5 binomial standard deviations away
  const Window box = oracle::PeriodicCube(4.0);
  const SpherePack pack = oracle::RelaxedPack({ 6, 12 }, { 0.8, 0.5 }, box, 4);
  const LagGrid lags = { 0.8, 2 };
  const ruc::TwoPointProbability exact = ruc::SumPairs(pack, box, lags);
  const SamplingRegion region(box, 0.0);
  ruc::Communicator serial;
  int within[2] = {};
  for (std::uint32_t seed = 1; seed <= 200; ++seed)
  {
    const SampledTwoPoint sampled =
      ruc::SampleTemplate(pack, 2, region, lags, { seed, 640, 0.0 }, serial);
    const double off =
      std::abs(sampled.Mean.S(0, 2)[1] - exact.S(0, 2)[1]) / sampled.Errors[exact.PairOf(0, 2)][1];
    within[0] += off < 1.0;
    within[1] += off < 2.0;
  }
  EXPECT_NEAR(within[0], 136, 23);
  EXPECT_NEAR(within[1], 190, 11);
}

TEST(TemplateSampling, RanksAndThreadsGiveEqualResults)
{
  const Window box = Window::MakeBox({ 0, 0, 0 }, { 5, 6, 7 }, { true, true, true });
  const SpherePack pack = oracle::RandomPack({ 15, 40 }, { 0.9, 0.5 }, box, 3);
  const LagGrid lags = { 0.5, 6 };
  const SamplingRegion regions[] = { SamplingRegion(box, 0.0),
    SamplingRegion(Window::MakeBox({ 0, 0, 0 }, { 5, 6, 7 }, { false, true, false }), 0.5) };
  for (const SamplingRegion& region : regions)
  {
    ExpectEqualForRanksAndThreads(pack,
      [&](const SpherePack& own, ruc::Communicator& ranks) {
        return ruc::SampleTemplate(own, 2, region, lags, { 5, 200, 0.0 }, ranks);
      });
  }
}

TEST(TemplateSampling, RefusesBadInput)
{
  ruc::Communicator serial;
  EXPECT_SAYS(ruc::SampleTemplate({}, 1, SamplingRegion(oracle::PeriodicCube(5.0), 0.0), { 1.0, 2 },
                { 1, 0, 0.0 }, serial),
    "NumberOfThrows requires a number >= 2, without which no standard error is known, got 0.");
}
