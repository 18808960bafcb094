// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/Results/TwoPointChecks.h"

#include "Oracles.h"

#include <limits>

namespace
{
template <class Function>
std::vector<double> Sample(int count, double spacing, Function&& f)
{
  std::vector<double> values;
  for (int k = 0; k <= count; ++k)
  {
    values.push_back(f(k * spacing));
  }
  return values;
}
}

TEST(TwoPointChecks, GradientIsExactForQuadratics)
{
  for (int count : { 2, 3, 17 })
  {
    const std::vector<double> gradient =
      ruc::Gradient(Sample(count, 0.3, [](double r) { return 2.0 - 1.5 * r + 0.7 * r * r; }), 0.3);
    ASSERT_EQ(gradient.size(), std::size_t(count) + 1);
    for (int k = 0; k <= count; ++k)
    {
      EXPECT_NEAR(gradient[k], -1.5 + 1.4 * 0.3 * k, 1e-12); // rounding over the spacing
    }
  }
}

TEST(TwoPointChecks, GradientOfTwoValuesIsTheirQuotient)
{
  EXPECT_EQ(ruc::Gradient({ 1.0, 3.0 }, 0.5), (std::vector<double>{ 4.0, 4.0 }));
}

TEST(TwoPointChecks, GradientConvergesWithTheSquareOfTheSpacing)
{
  double error[2] = {};
  for (int n = 0; n < 2; ++n)
  {
    const int count = 40 << n;
    const double spacing = 2.0 / count;
    const std::vector<double> gradient =
      ruc::Gradient(Sample(count, spacing, [](double r) { return std::sin(r); }), spacing);
    for (int k = 0; k <= count; ++k)
    {
      error[n] = std::max(error[n], std::abs(gradient[k] - std::cos(k * spacing)));
    }
  }
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.2); // second order, ends included; the next order is 1/40
}

TEST(TwoPointChecks, SaturationLengthOfAnExponential)
{
  // |f - c| = e^-r and |f'| = e^-r: both are below the tolerance from -ln(tolerance) on, or
  // -ln(tolerance / length).
  const double spacing = 0.01;
  const std::vector<double> values =
    Sample(1500, spacing, [](double r) { return 0.2 + std::exp(-r); });
  for (double tolerance : { 1e-1, 1e-2, 1e-3 })
  {
    for (double length : { 0.5, 1.0, 3.0 })
    {
      const double exact = -std::log(tolerance / std::max(length, 1.0));
      // It is the next lag above; the discrete slope is off by spacing^2 / 6, relatively
      EXPECT_NEAR(ruc::SaturationLength(values, spacing, 0.2, tolerance, length),
        exact + 0.5 * spacing, 0.5 * spacing + 1e-4);
    }
  }
}

TEST(TwoPointChecks, SaturationLengthWaitsForTheLastExcursion)
{
  std::vector<double> values(101, 0.25);
  values[0] = 0.5;
  values[60] = 0.26; // its slopes reach the lags 59 and 61
  EXPECT_DOUBLE_EQ(ruc::SaturationLength(values, 0.5, 0.25, 1e-3, 1.0), 31.0);
  EXPECT_DOUBLE_EQ(ruc::SaturationLength(values, 0.5, 0.25, 0.011, 1.0),
    1.0); // only the start counts, up to the slope at lag 1
  values[100] = 0.3;
  EXPECT_TRUE(std::isnan(ruc::SaturationLength(values, 0.5, 0.25, 1e-3, 1.0)));
  EXPECT_DOUBLE_EQ(ruc::SaturationLength(std::vector<double>(11, 0.25), 0.5, 0.25, 0.0, 1.0), 0.0);
}

TEST(TwoPointChecks, ChecksOfAConstructedMedium)
{
  ruc::TwoPointProbability probability(1, { 0.1, 100 });
  probability.Fractions = { 0.3, 0.7 };
  probability.S(0, 0) = Sample(100, 0.1, [](double r) { return 0.09 + 0.21 * std::exp(-r); });
  probability.CompleteMatrix();
  probability.S(0, 0)[0] += 0.02; // an error that the check must find
  const std::vector<ruc::TwoPointCheck> checks =
    ruc::CheckTwoPointProbability(probability, 0.001, 1.0);
  ASSERT_EQ(checks.size(), 3u);
  const double limits[] = { 0.09, 0.21, 0.49 }, zero[] = { 0.02, 0.0, 0.0 };
  double longest = 0.0;
  for (int p = 0; p < 3; ++p)
  {
    EXPECT_NEAR(checks[p].Limit, limits[p], 1e-15);
    EXPECT_NEAR(checks[p].ErrorAtZero, zero[p], 1e-15);
    EXPECT_NEAR(checks[p].ErrorAtInfinity, 0.21 * std::exp(-10.0), 1e-15);
    EXPECT_NEAR(checks[p].SaturationLength, -std::log(0.001 / 0.21) + 0.05, 0.05 + 0.002);
    longest = std::max(longest, checks[p].SaturationLength);
  }
  EXPECT_EQ(ruc::SaturationLength(probability, 0.001, 1.0), longest);
  EXPECT_TRUE(std::isnan(ruc::SaturationLength(probability, 1e-6, 1.0)));
}

namespace
{
// A medium of two modes whose phases are independent beyond lag 0: S_rs(r) = c_r c_s
ruc::TwoPointProbability Independent()
{
  ruc::TwoPointProbability probability(2, { 0.5, 3 });
  probability.Fractions = { 0.2, 0.3, 0.5 };
  for (int r = 0; r < 3; ++r)
  {
    for (int s = r; s < 3; ++s)
    {
      const double both = probability.Fractions[r] * probability.Fractions[s];
      probability.S(r, s).assign(4, both);
      probability.S(r, s)[0] = r == s ? probability.Fractions[r] : 0.0;
    }
  }
  return probability;
}
}

TEST(RequireProbabilities, TakesWhatCanBe)
{
  EXPECT_NO_THROW(ruc::RequireProbabilities(Independent(), 1e-12));
}

TEST(RequireProbabilities, RefusesWhatCannotBe)
{
  const auto with = [](int r, int s, int k, double change)
  {
    ruc::TwoPointProbability probability = Independent();
    probability.S(r, s)[k] += change;
    return probability;
  };
  EXPECT_SAYS(ruc::RequireProbabilities(with(1, 1, 2, -0.2), 0.01),
    "from 0 to 1, got -0.11 for S_2_2 at r = 1");
  EXPECT_SAYS(ruc::RequireProbabilities(with(0, 2, 3, 1.0), 0.01),
    "from 0 to 1, got 1.1 for S_1_m at r = 1.5");
  EXPECT_SAYS(ruc::RequireProbabilities(with(0, 1, 1, 0.03), 0.01),
    "add up to the fraction of phase 1, 0.2, at every lag, got 0.23 at r = 0.5");
  EXPECT_SAYS(
    ruc::RequireProbabilities(with(1, 1, 0, -0.3), 0.01), "fractions > 0, got 0 for S_2_2");
  EXPECT_SAYS(
    ruc::RequireProbabilities(with(0, 0, 1, std::numeric_limits<double>::quiet_NaN()), 0.01),
    "got nan for S_1_1");
  EXPECT_NO_THROW(ruc::RequireProbabilities(with(0, 1, 1, 0.03), 0.04));
  // Everything adds up to each fraction, but the fractions do not add up to 1
  ruc::TwoPointProbability half = Independent();
  for (std::vector<double>& values : half.Values)
  {
    for (double& value : values)
    {
      value *= 0.5;
    }
  }
  EXPECT_SAYS(ruc::RequireProbabilities(half, 0.01), "that add up to 1, got 0.5");
}
