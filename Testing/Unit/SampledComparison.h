// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * @file
 * What chord and template sampling are compared with.
 */

#include "Oracles.h"
#include "ThreadRanks.h"
#include "ruc/Statistics/Sampling/SampledSums.h"
#include "ruc/Tracing/SamplingRegion.h"

#include <omp.h>

/**
 * Takes one thread as long as it lives: many short runs are faster on one, above all on a busy
 * machine.
 */
class OneThread
{
public:
  OneThread() { omp_set_num_threads(1); }
  ~OneThread() { omp_set_num_threads(this->Before); }

private:
  int Before = omp_get_max_threads();
};

/** The mean of functions on the lags and its standard error. */
class MeanFunction
{
public:
  explicit MeanFunction(std::size_t lags)
    : Sum(lags, 0.0)
    , Squares(lags, 0.0)
  {
  }
  void Add(const std::vector<double>& values)
  {
    this->Count += 1.0;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      this->Sum[k] += values[k];
      this->Squares[k] += values[k] * values[k];
    }
  }
  double Value(int k) const { return this->Sum[k] / this->Count; }
  double Error(int k) const
  {
    const double variance =
      std::max(this->Squares[k] / this->Count - this->Value(k) * this->Value(k), 0.0);
    return std::sqrt(variance / (this->Count - 1.0));
  }

private:
  std::vector<double> Sum, Squares;
  double Count = 0.0;
};

/**
 * Expects every value within so many of its standard errors, which must not be vast; 2e-6 is for
 * the error of the exact sum.
 */
inline void ExpectWithinErrors(
  const ruc::SampledTwoPoint& sampled, const ruc::TwoPointProbability& exact, double errors)
{
  for (int p = 0; p < exact.Pairs(); ++p)
  {
    for (int k = 0; k <= exact.Lags.Count; ++k)
    {
      EXPECT_NEAR(
        sampled.Mean.Values[p][k], exact.Values[p][k], errors * sampled.Errors[p][k] + 2e-6)
        << p << " " << k;
      EXPECT_LT(sampled.Errors[p][k], 0.02);
    }
  }
}

/**
 * Compares with the Boolean model with a fixed number N of spheres of radius a at random in a
 * periodic cube: the mean over realisations is S_mm(r) = (1 - V_union(r) / V)^N, which tends to
 * exp(-rho V_union). The scatter of the realisations, each sampled anew, is the standard error.
 */
template <class Sample>
void ExpectBooleanModel(Sample&& sample)
{
  const OneThread alone;
  constexpr int realisations = 40, spheres = 60;
  constexpr double a = 0.7, edge = 5.0;
  const ruc::LagGrid lags = { 0.2, 10 }; // to 2 a and beyond; less than edge - 2 a
  const ruc::Window box = oracle::PeriodicCube(edge);
  const ruc::SamplingRegion region(box, 0.0);
  MeanFunction mean(lags.Count + 1);
  for (int n = 1; n <= realisations; ++n)
  {
    const ruc::SpherePack pack = oracle::RandomPack({ spheres }, { a }, box, n);
    mean.Add(sample(pack, region, lags, n).Mean.S(1, 1));
  }
  for (int k = 0; k <= lags.Count; ++k)
  {
    const double single = 4.0 / 3.0 * oracle::Pi * a * a * a;
    const double both = 2.0 * single - oracle::LensVolume(a, a, k * lags.Spacing);
    const double expected = std::pow(1.0 - both / std::pow(edge, 3), spheres);
    EXPECT_NEAR(mean.Value(k), expected, 4.0 * mean.Error(k)) << k;
    EXPECT_LT(mean.Error(k), 0.02);
  }
}

inline void ExpectEqual(const ruc::SampledTwoPoint& a, const ruc::SampledTwoPoint& b)
{
  EXPECT_EQ(a.Samples, b.Samples);
  EXPECT_EQ(a.Mean.Values, b.Mean.Values);
  EXPECT_EQ(a.Mean.Fractions, b.Mean.Fractions);
  EXPECT_EQ(a.Errors, b.Errors);
  EXPECT_EQ(a.FractionErrors, b.FractionErrors);
  EXPECT_EQ(a.Asymmetry, b.Asymmetry);
  EXPECT_EQ(a.TotalError, b.TotalError);
}

/**
 * Expects that sample(share of the pack, ranks) gives `==` results on every rank, however many
 * ranks and threads there are and whatever their shares, of which one is empty or one is all.
 */
template <class Sample>
void ExpectEqualForRanksAndThreads(const ruc::SpherePack& pack, Sample&& sample)
{
  const int threads = omp_get_max_threads();
  ruc::Communicator serial;
  omp_set_num_threads(1);
  const ruc::SampledTwoPoint expected = sample(pack, serial);
  for (int more : { 2, 3 })
  {
    omp_set_num_threads(more);
    ExpectEqual(sample(pack, serial), expected);
  }
  omp_set_num_threads(threads);
  for (int size : { 2, 3, 5 })
  {
    for (bool allOnOne : { false, true })
    {
      std::vector<ruc::SpherePack> shares(size);
      for (std::size_t i = 0; i < pack.Size(); ++i)
      {
        // Rank 1 has none, or all
        const int rank = static_cast<int>((7 * i + i / 3) % size);
        shares[allOnOne ? 1 : rank == 1 ? 0 : rank].Append(pack, pack.Size() - 1 - i);
      }
      oracle::ThreadRanks::Run(size,
        [&](ruc::Communicator& ranks)
        {
          omp_set_num_threads(1 + ranks.Rank() % 2);
          ExpectEqual(sample(shares[ranks.Rank()], ranks), expected);
        });
    }
  }
}
