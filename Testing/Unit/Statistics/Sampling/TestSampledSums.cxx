// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Sampling/SampledSums.h"

#include "Oracles.h"
#include "ThreadRanks.h"

namespace
{
using ruc::SampledRatios;
using ruc::SampledSums;
using ruc::SampledTwoPoint;
using ruc::SamplingSettings;

constexpr ruc::SampleNames Names = { "NumberOfLines", "lines" };

struct Batches
{
  std::vector<double> N, D;
};

Batches RandomBatches(int count, double mean, double spread)
{
  oracle::Uniform random(11);
  Batches batches;
  for (int b = 0; b < count; ++b)
  {
    const double d = random(0.5, 5.0);
    batches.D.push_back(d);
    batches.N.push_back(d * mean * (1.0 + spread * random(-1.0, 1.0)));
  }
  return batches;
}

// The formula of the header in long double, on numbers as they are
std::pair<double, double> RatioAndError(const Batches& batches)
{
  long double n = 0.0, d = 0.0, squares = 0.0;
  const std::size_t count = batches.N.size();
  for (std::size_t b = 0; b < count; ++b)
  {
    n += batches.N[b];
    d += batches.D[b];
  }
  for (std::size_t b = 0; b < count; ++b)
  {
    const long double e = batches.N[b] - n / d * batches.D[b];
    squares += e * e;
  }
  return { static_cast<double>(n / d),
    static_cast<double>(std::sqrt(squares * count / (count - 1.0L)) / d) };
}

void Add(const Batches& batches, std::size_t first, std::size_t step, SampledRatios& ratios)
{
  for (std::size_t b = first; b < batches.N.size(); b += step)
  {
    ratios.AddBatch(&batches.D[b]);
    ratios.AddRow(0, &batches.N[b], &batches.D[b], &batches.N[b]);
  }
}
}

TEST(SampledRatios, IsTheRatioEstimatorWithItsStandardError)
{
  ruc::Communicator serial;
  // Numbers of at most 1 are rounded to 9e-16, in which the error drowns below a spread of 1e-7.
  for (double mean : { 0.5, 1e-3, 1e-6 })
  {
    for (double spread : { 1.0, 1e-2, 1e-4 })
    {
      const Batches batches = RandomBatches(1000, mean, spread);
      const auto [ratio, error] = RatioAndError(batches);
      SampledRatios ratios(1, 1, 5.0, 5.0, true);
      ratios.BeginRound(serial, 1000);
      Add(batches, 0, 1, ratios);
      ratios.EndRound(serial);
      EXPECT_NEAR(ratios.Ratio(0, 0), ratio, 1e-15);
      EXPECT_NEAR(ratios.SecondRatio(0, 0), ratio, 1e-15);
      // Squares and products, (mean)^2 or mean or 1 times 1000, are off by some sqrt(1000) x 3e-16
      // x (1, mean, mean^2); relative to squares of the spread
      const double relative = 1e-14 / (std::sqrt(1000.0) * mean * mean * spread * spread) + 1e-9;
      EXPECT_NEAR(ratios.Error(0, 0), error, error * relative) << mean << " " << spread;
    }
  }
}

TEST(SampledRatios, ManyBatchesFitAndRoundsGoOn)
{
  // 2^26 batches leave 36 bits; coming from 50, what is there is shifted.
  ruc::Communicator serial;
  const Batches batches = RandomBatches(1000, 0.3, 0.5);
  const auto [ratio, error] = RatioAndError(batches);
  SampledRatios ratios(1, 1, 5.0, 5.0, true);
  ratios.BeginRound(serial, 500);
  Add(batches, 0, 2, ratios);
  ratios.EndRound(serial);
  ratios.BeginRound(serial, std::int64_t(1) << 26);
  Add(batches, 1, 2, ratios);
  ratios.EndRound(serial);
  EXPECT_NEAR(ratios.Ratio(0, 0), ratio, 1e-11);
  EXPECT_NEAR(ratios.Error(0, 0), error, 1e-8 * error);
  // Even when all of them are the largest there can be
  const double most = 5.0;
  SampledRatios full(1, 1, 5.0, 5.0);
  full.BeginRound(serial, 4096);
  for (int b = 0; b < 4096; ++b)
  {
    full.AddBatch(&most);
    full.AddRow(0, &most, &most);
  }
  EXPECT_EQ(full.Ratio(0, 0), 1.0);
  EXPECT_EQ(full.Error(0, 0), 0.0);
}

TEST(SampledRatios, RoundsAreSharedByRanks)
{
  const Batches batches = RandomBatches(101, 0.3, 0.5);
  ruc::Communicator serial;
  SampledRatios alone(1, 1, 5.0, 5.0, true);
  alone.BeginRound(serial, 202);
  Add(batches, 0, 1, alone);
  Add(batches, 0, 1, alone);
  for (int size : { 1, 3 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        SampledRatios shared(1, 1, 5.0, 5.0, true);
        for (int round = 1; round <= 2; ++round)
        {
          shared.BeginRound(ranks, 101 * round);
          Add(batches, ranks.Rank(), size, shared);
          shared.EndRound(ranks);
        }
        EXPECT_EQ(shared.Ratio(0, 0), alone.Ratio(0, 0));
        EXPECT_EQ(shared.Error(0, 0), alone.Error(0, 0));
      });
  }
}

TEST(SampledRatios, NothingToGoByIsNotANumber)
{
  SampledRatios ratios(2, 1, 1.0, 1.0);
  EXPECT_TRUE(std::isnan(ratios.Ratio(0, 0)));
  const double one = 1.0;
  ratios.AddBatch(&one);
  ratios.AddRow(0, &one, &one);
  EXPECT_EQ(ratios.Ratio(0, 0), 1.0);
  EXPECT_TRUE(std::isnan(ratios.Error(0, 0))); // one batch
  ratios.AddBatch(&one);
  EXPECT_EQ(ratios.Ratio(0, 0), 0.5);
  EXPECT_EQ(ratios.Ratio(1, 0), 0.0); // a row that was 0 in every batch
  EXPECT_EQ(ratios.Error(1, 0), 0.0);
}

TEST(SampledSums, SymmetrisesAndTellsTheAsymmetry)
{
  // One mode and the matrix; C_mm = 1, 0.5, C_01 = 0.25, C_10 = 0.125 at k = 1
  SampledSums sums(1, { 1.0, 1 }, 8.0); // a power of 2, so that nothing is rounded
  const double ones[] = { 1.0, 0.5 }, rs[] = { 0.0, 0.25 }, sr[] = { 0.0, 0.125 };
  sums.AddBatch({ nullptr, rs, sr, ones });
  sums.AddBatch({ ones, rs, sr, ones });
  const SampledTwoPoint result = sums.Result();
  // D = 3 and 2 x 0.375 + 3 x 0.5
  EXPECT_DOUBLE_EQ(result.Mean.Fractions[0], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.Mean.Fractions[1], 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.Mean.S(0, 1)[1], 0.375 / 2.25);
  EXPECT_EQ(result.Mean.S(0, 1)[0], 0.0);
  EXPECT_DOUBLE_EQ(result.Mean.S(0, 0)[1], 0.5 / 2.25);
  EXPECT_NEAR(result.Asymmetry[1], 0.125 / 0.1875, 1e-14);
  EXPECT_EQ(result.Asymmetry[0], 0.0);
  EXPECT_EQ(result.Asymmetry[2], 0.0);
  EXPECT_EQ(result.FractionErrors[0], result.Errors[0][0]);
  EXPECT_NEAR(result.TotalError,
    result.Errors[0][1] + 2.0 * result.Errors[1][1] + result.Errors[2][1], 1e-15);
}

TEST(SampledSums, RefusesBadSettings)
{
  const ruc::SamplingRegion region(
    ruc::Window::MakeBox({ 0, 0, 0 }, { 5, 6, 7 }, { false, false, false }), 0.0);
  const auto check = [&](SamplingSettings settings, int modes, ruc::LagGrid lags)
  { ruc::CheckSampling(settings, Names, modes, lags, region); };
  EXPECT_SAYS(check({ 1, 0, 0.0 }, 1, { 1.0, 2 }),
    "NumberOfLines requires a number >= 2, without which no standard error is known, got 0.");
  EXPECT_SAYS(check({ 1, 1, 0.0 }, 1, { 1.0, 2 }), "NumberOfLines requires a number >= 2");
  EXPECT_SAYS(check({ 1, std::int64_t(1) << 32, 0.0 }, 1, { 1.0, 2 }),
    "NumberOfLines requires a number <= 2147483648, got 4294967296.");
  EXPECT_SAYS(
    check({ 1, 9, -1.0 }, 1, { 1.0, 2 }), "TargetError requires a finite number >= 0, got -1.");
  EXPECT_SAYS(check({ 1, 9, NAN }, 1, { 1.0, 2 }), "TargetError requires a finite number >= 0");
  EXPECT_SAYS(
    check({ 1, 9, 0.0 }, 1, { 1.0, 5 }), "MaximumLag requires 0 < MaximumLag <= 4.995, got 5.");
  EXPECT_SAYS(check({ 1, 9, 0.0 }, 1, { 0.0, 5 }), "MaximumLag requires 0 < MaximumLag");
  EXPECT_SAYS(check({ 1, 9, 0.0 }, 1, { 1.0, -1 }),
    "NumberOfLags requires 1 <= NumberOfLags <= 100000, got -1.");
  EXPECT_SAYS(check({ 1, 9, 0.0 }, 1, { 1e-9, 100001 }), "got 100001.");
  EXPECT_SAYS(check({ 1, 9, 0.0 }, 400, { 1e-3, 1000 }),
    "NumberOfLags requires at most 620 lags for 400 modes, got 1000.");
  check({ 1, 0, 0.1 }, 1, { 1.0, 4 });
  check({ 1, 2, 0.0 }, 0, { 0.0, 0 });
}

TEST(SampledSums, BatchesHoldASixtyFourthOfTheSamples)
{
  EXPECT_EQ(ruc::SamplesInBatch({ 1, 1, 0.0 }, 32), 1);
  EXPECT_EQ(ruc::SamplesInBatch({ 1, 640, 0.0 }, 32), 10);
  EXPECT_EQ(ruc::SamplesInBatch({ 1, 641, 0.0 }, 32), 11);
  EXPECT_EQ(ruc::SamplesInBatch({ 1, 1000000, 0.0 }, 32), 32);
  EXPECT_EQ(ruc::SamplesInBatch({ 1, 1, 0.5 }, 32), 32);
}

namespace
{
// Samples that are in phase 0 with probability 1/2: the standard error of c_0 is 1 / (2 sqrt(n)),
// and the total of both phases twice that.
SampledTwoPoint TossCoins(const SamplingSettings& settings, int size, int atOnce,
  const ruc::SamplingProgress& progress, std::vector<std::int64_t>* taken = nullptr)
{
  SampledTwoPoint result = { { 1, { 0.0, 0 } }, {}, {}, {}, 0, 0.0 };
  oracle::ThreadRanks::Run(size,
    [&](ruc::Communicator& ranks)
    {
      const int samplesInBatch = ruc::SamplesInBatch(settings, 32);
      SampledSums sums(1, { 0.0, 0 }, samplesInBatch);
      const SampledTwoPoint own = ruc::TakeSamples(settings, Names, samplesInBatch, atOnce, sums,
        {}, ranks, ranks.Rank() == 0 ? progress : ruc::SamplingProgress(),
        [&](const ruc::BatchRange& range)
        {
          for (std::int64_t batch = range.First; batch < range.End; ++batch)
          {
            if (batch % size != ranks.Rank())
            {
              continue;
            }
            double heads = 0.0, tails = 0.0;
            for (std::int64_t n = range.FirstSample(batch); n < range.EndSample(batch); ++n)
            {
              (oracle::Uniform(n)() < 0.5 ? heads : tails) += 1.0;
              if (taken && size == 1)
              {
                taken->push_back(n);
              }
            }
            sums.AddBatch({ &heads, nullptr, nullptr, &tails });
          }
        });
      if (ranks.Rank() == size - 1)
      {
        result = own;
      }
    });
  return result;
}
}

TEST(SampledSums, TakesEverySampleOnce)
{
  for (std::int64_t samples : { 1, 63, 650, 3000 })
  {
    std::vector<std::int64_t> taken;
    std::vector<double> done;
    const SampledTwoPoint result = TossCoins(
      { 1, samples, 0.0 }, 1, 7,
      [&](double share, const std::string& text)
      {
        done.push_back(share);
        EXPECT_NE(text.find(" lines"), std::string::npos);
        return true;
      },
      &taken);
    EXPECT_EQ(result.Samples, samples);
    ASSERT_EQ(taken.size(), std::size_t(samples));
    for (std::int64_t n = 0; n < samples; ++n)
    {
      EXPECT_EQ(taken[n], n);
    }
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
    EXPECT_EQ(done.back(), 1.0);
  }
}

TEST(SampledSums, StopsWithTheSamplesTakenSoFar)
{
  // 3000 samples come in batches of 32, and so do 640.
  const SampledTwoPoint expected = TossCoins({ 1, 640, 0.0 }, 1, 5, {});
  for (int size : { 1, 3 })
  {
    const auto enough = [](double share, const std::string&) { return share < 640.0 / 3000.0; };
    const SampledTwoPoint result = TossCoins({ 1, 3000, 0.0 }, size, 5, enough);
    EXPECT_TRUE(result.Stopped);
    EXPECT_EQ(result.Samples, 640);
    EXPECT_EQ(result.Mean.Fractions, expected.Mean.Fractions);
    EXPECT_NEAR(result.FractionErrors[0], 0.5 / std::sqrt(640.0), 0.25 * 0.5 / std::sqrt(640.0));
  }
  EXPECT_FALSE(expected.Stopped);
  // A target out of reach, too
  const SampledTwoPoint aimed =
    TossCoins({ 1, 0, 1e-4 }, 3, 5, [](double share, const std::string&) { return share < 0.01; });
  EXPECT_TRUE(aimed.Stopped);
  EXPECT_GT(aimed.TotalError, 1e-4);
}

TEST(SampledSums, StopsAtTheTargetError)
{
  // 1 / sqrt(n) = 0.01 needs 10 000 samples. The error is itself uncertain by 1 / sqrt(2 batches) =
  // 4 %, so the number by 8 %.
  const SampledTwoPoint result = TossCoins({ 1, 0, 0.01 }, 1, 7, {});
  EXPECT_LE(result.TotalError, 0.01);
  EXPECT_NEAR(result.Samples, 10000.0, 3000.0);
  EXPECT_NEAR(result.Mean.Fractions[0], 0.5, 4.0 * result.FractionErrors[0]);
  const SampledTwoPoint shared = TossCoins({ 1, 0, 0.01 }, 3, 5, {});
  EXPECT_EQ(shared.Samples, result.Samples);
  EXPECT_EQ(shared.TotalError, result.TotalError);
  EXPECT_EQ(shared.Mean.Fractions, result.Mean.Fractions);
  // 2^31 samples would do for 2.2e-5.
  EXPECT_SAYS(TossCoins({ 1, 0, 1e-5 }, 1, 7, {}), "TargetError requires at least about 2");
  EXPECT_SAYS(TossCoins({ 1, 0, 1e-5 }, 1, 7, {}), "e-05, got 1e-05.");
}

TEST(SampledSums, SaysWhereATargetErrorHasNoPairs)
{
  ruc::Communicator serial;
  SampledSums sums(0, { 0.5, 1 }, 1.0);
  const double counts[] = { 1.0, 0.0 };
  EXPECT_SAYS(ruc::TakeSamples({ 1, 0, 0.1 }, Names, 32, 64, sums, {}, serial, {},
                [&](const ruc::BatchRange& range)
                {
                  for (std::int64_t b = range.First; b < range.End; ++b)
                  {
                    sums.AddBatch({ counts });
                  }
                }),
    "TargetError requires pairs of points at every lag, got none at 0.5 on 2048 lines.");
}
