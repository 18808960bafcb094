// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/PairSums/ExactPairSum.h"

#include "Oracles.h"
#include "PairSumComparison.h"
#include "ThreadRanks.h"
#include "ruc/Particles/SphereOverlap.h"

#include <omp.h>

namespace
{
using ruc::LagGrid;
using ruc::SpherePack;
using ruc::TwoPointProbability;
using ruc::Window;

/**
 * S_rs of the modes by the definition: a sum over all pairs and images. With `quadrature` the mean
 * over directions is taken numerically, so that nothing of the core is used; else by the closed
 * form, which has tests of its own. `Bound` is that of the tables' error, with knots an eighth of
 * the smaller radius apart: the sum of the pairs' bounds.
 */
struct Expected
{
  std::vector<double> Values, Bound;
};

Expected BruteForce(
  const SpherePack& pack, const Window& box, const LagGrid& lags, int r, int s, bool quadrature)
{
  Expected expected;
  std::vector<double>& values = expected.Values;
  values.assign(lags.Count + 1, 0.0);
  expected.Bound.assign(lags.Count + 1, 1e-12); // rounding
  const auto add = [&](double a, double b, double d, double factor)
  {
    for (int k = 0; k <= lags.Count; ++k)
    {
      const double lag = k * lags.Spacing;
      if (d > 0.0)
      {
        expected.Bound[k] +=
          factor / box.Volume() * oracle::HermiteError(a, b, lag, d, 0.125 * std::min(a, b));
      }
      if (std::abs(d - lag) < a + b)
      {
        values[k] += factor / box.Volume() *
          (quadrature ? oracle::AveragedLens(a, b, lag, d)
                      : ruc::OrientationAveragedOverlap(a, b, lag, d).Value);
      }
    }
  };
  for (std::size_t i = 0; i < pack.Size(); ++i)
  {
    if (r == s && pack.Mode[i] == r + 1)
    {
      add(pack.Radius[i], pack.Radius[i], 0.0, 1.0);
    }
  }
  oracle::ForEachPair(pack, box, lags.Maximum() + 2.0 * pack.LargestRadius(),
    [&](std::size_t i, std::size_t j, const std::array<int, 3>&, double d)
    {
      const double orders = (pack.Mode[i] == r + 1 && pack.Mode[j] == s + 1) +
        (pack.Mode[j] == r + 1 && pack.Mode[i] == s + 1);
      if (orders > 0)
      {
        add(pack.Radius[i], pack.Radius[j], d, orders);
      }
    });
  return expected;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

void ExpectNear(const std::vector<double>& values, const Expected& expected)
{
  ASSERT_EQ(values.size(), expected.Values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    EXPECT_NEAR(values[k], expected.Values[k], expected.Bound[k]) << "lag " << k;
    // The bound has to say something: it is a few thousandths of the largest value at the most
    EXPECT_LT(
      expected.Bound[k], 3e-3 * *std::max_element(expected.Values.begin(), expected.Values.end()))
      << "lag " << k;
  }
}

SpherePack Lattice(const std::vector<ruc::Vector3>& sites, double edge, double radius)
{
  SpherePack pack;
  for (const ruc::Vector3& site : sites)
  {
    pack.X.push_back(edge * site[0]);
    pack.Y.push_back(edge * site[1]);
    pack.Z.push_back(edge * site[2]);
    pack.Radius.push_back(radius);
    pack.Mode.push_back(1);
  }
  ruc::SortCanonically(pack);
  return pack;
}

constexpr double FixedPointError = 1e-8; // of the closed form
}

TEST(ExactPairSum, OneSphereAloneIsItsOwnOverlap)
{
  // As long as no image is within reach, S_11(r) = c (1 - 3 r / 4a + r^3 / 16 a^3), and 0 from 2a
  // on.
  const Window box = oracle::PeriodicCube(10.0);
  SpherePack pack;
  pack.X = pack.Y = pack.Z = { 0.5 };
  pack.Radius = { 1.0 };
  pack.Mode = { 1 };
  const TwoPointProbability probability = ruc::SumPairs(pack, box, { 0.1, 79 });
  const double c = 4.0 / 3.0 * oracle::Pi / 1000.0;
  EXPECT_NEAR(probability.Fractions[0], c, 1e-17);
  for (int k = 0; k <= 79; ++k)
  {
    const double r = 0.1 * k;
    EXPECT_NEAR(
      probability.S(0, 0)[k], r < 2.0 ? c * (1.0 - 0.75 * r + r * r * r / 16.0) : 0.0, 1e-16)
      << k;
  }
}

TEST(ExactPairSum, OneSphereAndItsImages)
{
  // Lags go up to more than three edges
  const Window box = ruc::Window::MakeBox({ 0, 0, 0 }, { 3.0, 3.5, 4.0 }, { true, true, true });
  SpherePack pack;
  pack.X = pack.Y = pack.Z = { 2.9 };
  pack.Radius = { 1.2 };
  pack.Mode = { 1 };
  const LagGrid lags = { 0.4, 24 };
  const TwoPointProbability probability = ruc::SumPairs(pack, box, lags);
  ExpectNear(probability.S(0, 0), BruteForce(pack, box, lags, 0, 0, true));
}

TEST(ExactPairSum, TwoSpheresOfTwoModes)
{
  const Window box = oracle::PeriodicCube(5.0);
  SpherePack pack;
  pack.X = { 0.1, 4.0 };
  pack.Y = { 0.2, 0.3 };
  pack.Z = { 4.9, 1.9 };
  pack.Radius = { 1.1, 0.6 };
  pack.Mode = { 2, 1 };
  const LagGrid lags = { 0.25, 24 };
  const TwoPointProbability probability = ruc::SumPairs(pack, box, lags);
  for (int r = 0; r < 2; ++r)
  {
    for (int s = r; s < 2; ++s)
    {
      ExpectNear(probability.S(r, s), BruteForce(pack, box, lags, r, s, true));
    }
  }
}

TEST(ExactPairSum, CubicLattices)
{
  const std::vector<ruc::Vector3> simple = { { 0, 0, 0 } };
  const std::vector<ruc::Vector3> centred = { { 0, 0, 0 }, { 0.5, 0.5, 0.5 } };
  const std::vector<ruc::Vector3> faceCentred = { { 0, 0, 0 }, { 0.5, 0.5, 0 }, { 0.5, 0, 0.5 },
    { 0, 0.5, 0.5 } };
  const struct
  {
    const std::vector<ruc::Vector3>& Sites;
    double Radius, Fraction; // of touching spheres in the unit cube
  } lattices[] = { { simple, 0.5, oracle::Pi / 6.0 },
    { centred, std::sqrt(3.0) / 4.0, oracle::Pi * std::sqrt(3.0) / 8.0 },
    { faceCentred, std::sqrt(2.0) / 4.0, oracle::Pi * std::sqrt(2.0) / 6.0 } };
  for (const auto& lattice : lattices)
  {
    const double edge = 2.0, shrink = 1.0 - 1e-9;
    const SpherePack pack = Lattice(lattice.Sites, edge, edge * lattice.Radius * shrink);
    const Window box = oracle::PeriodicCube(edge);
    const LagGrid lags = { 0.15, 20 };
    const TwoPointProbability probability = ruc::SumPairs(pack, box, lags);
    EXPECT_NEAR(probability.Fractions[0], lattice.Fraction, 1e-8); // radii are shrunk by 1e-9
    ExpectNear(probability.S(0, 0), BruteForce(pack, box, lags, 0, 0, true));
  }
}

TEST(ExactPairSum, ALatticeOfTwoCellsIsTheSameMedium)
{
  // Repeating the cell changes nothing
  const SpherePack one = Lattice({ { 0, 0, 0 }, { 0.5, 0.5, 0.5 } }, 2.0, 0.8);
  SpherePack four = one;
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (const ruc::Vector3& shift : { ruc::Vector3{ 2, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 } })
    {
      four.Append(one, i);
      four.X.back() += shift[0];
      four.Y.back() += shift[1];
    }
  }
  ruc::SortCanonically(four);
  const LagGrid lags = { 0.11, 30 };
  const TwoPointProbability a = ruc::SumPairs(one, oracle::PeriodicCube(2.0), lags);
  const TwoPointProbability b =
    ruc::SumPairs(four, Window::MakeBox({ 0, 0, 0 }, { 4, 4, 2 }, { true, true, true }), lags);
  ExpectNear(a.S(0, 0), b.S(0, 0), 1e-12); // fixed point and rounding; the tables are the same
  ExpectNear(a.S(1, 1), b.S(1, 1), 1e-12);
}

TEST(ExactPairSum, RandomPackAgreesWithBruteForce)
{
  // A lag spacing finer and coarser than the knots, lags beyond half the box
  const Window box = oracle::PeriodicCube(6.0);
  const SpherePack pack = oracle::RelaxedPack({ 10, 25, 30 }, { 1.0, 0.65, 0.4 }, box, 4);
  for (const LagGrid& lags : { LagGrid{ 0.05, 80 }, LagGrid{ 0.6, 12 } })
  {
    const TwoPointProbability probability = ruc::SumPairs(pack, box, lags);
    for (int r = 0; r < 3; ++r)
    {
      for (int s = r; s < 3; ++s)
      {
        ExpectNear(probability.S(r, s), BruteForce(pack, box, lags, r, s, false));
      }
    }
  }
}

TEST(ExactPairSum, SumsAndLimits)
{
  const Window box = oracle::PeriodicCube(6.0);
  const SpherePack pack = oracle::RelaxedPack({ 10, 25, 30 }, { 1.0, 0.65, 0.4 }, box, 4);
  const TwoPointProbability probability = ruc::SumPairs(pack, box, { 0.2, 120 });
  double fractions = 0.0;
  for (int r = 0; r < 4; ++r)
  {
    fractions += probability.Fractions[r];
    for (int k = 0; k <= 120; ++k)
    {
      double sum = 0.0;
      for (int s = 0; s < 4; ++s)
      {
        sum += probability.S(r, s)[k];
        EXPECT_GE(probability.S(r, s)[k], -1e-6);
      }
      EXPECT_NEAR(sum, probability.Fractions[r], 1e-14) << r << " " << k;
    }
    for (int s = 0; s < 4; ++s)
    {
      EXPECT_NEAR(probability.S(r, s)[0], r == s ? probability.Fractions[r] : 0.0, 1e-12)
        << r << " " << s;
    }
  }
  EXPECT_NEAR(fractions, 1.0, 1e-14);
  double volume = 0.0;
  for (double radius : pack.Radius)
  {
    volume += 4.0 / 3.0 * oracle::Pi * std::pow(radius, 3);
  }
  EXPECT_NEAR(probability.Fractions[3], 1.0 - volume / 216.0, 1e-14);
}

TEST(ExactPairSum, FarAwayIsTheProductOfTheFractions)
{
  // Four edges away a shell of lags meets ~200 images; the mean over the last edge of lags is
  // closer still.
  const Window box = oracle::PeriodicCube(6.0);
  const SpherePack pack = oracle::RelaxedPack({ 10, 25 }, { 1.0, 0.65 }, box, 4);
  const TwoPointProbability probability = ruc::SumPairs(pack, box, { 0.1, 240 });
  for (int r = 0; r < 3; ++r)
  {
    for (int s = r; s < 3; ++s)
    {
      double mean = 0.0;
      for (int k = 181; k <= 240; ++k)
      {
        mean += probability.S(r, s)[k] / 60.0;
      }
      // The lattice sum over reciprocal vectors G: a mode of S decays as 1 / (G r), averaged over
      // an edge as 1 / (G r)^2 more; with G r >= 2 pi 3.5 and at most c_r (1 - c_r) in all modes
      // that is a few per mille of it.
      const double c = probability.Fractions[r] * probability.Fractions[s];
      const double variance = std::sqrt(probability.Fractions[r] * probability.Fractions[s]);
      EXPECT_NEAR(mean, c, 4e-3 * variance) << r << " " << s;
    }
  }
}

TEST(ExactPairSum, SlopeAtZeroIsAQuarterOfTheSurface)
{
  const Window box = oracle::PeriodicCube(6.0);
  SpherePack pack = oracle::RelaxedPack({ 10, 25 }, { 1.0, 0.65 }, box, 4);
  double surface = 0.0;
  for (double& radius : pack.Radius)
  {
    radius *= 0.9; // then no other sphere is within reach of the smallest lags
    surface += 4.0 * oracle::Pi * radius * radius / 216.0;
  }
  const double spacing = 0.01;
  const TwoPointProbability probability = ruc::SumPairs(pack, box, { spacing, 3 });
  const double slope = (probability.S(2, 2)[1] - probability.S(2, 2)[0]) / spacing;
  // S = c (1 - 3 r / 4 a + r^3 / 16 a^3): the quotient is off by r^2 / 12 a^2 of the slope
  EXPECT_NEAR(
    -slope, surface / 4.0, surface / 4.0 * spacing * spacing / (12.0 * 0.58 * 0.58) + 1e-12);
}

TEST(ExactPairSum, AgreesWithRandomPointsAndDirections)
{
  const Window box = oracle::PeriodicCube(6.0);
  const SpherePack pack = oracle::RelaxedPack({ 12, 28 }, { 1.0, 0.65 }, box, 14);
  const LagGrid lags = { 0.7, 6 };
  const TwoPointProbability probability = ruc::SumPairs(pack, box, lags);
  const auto phaseAt = [&](const ruc::Vector3& p)
  {
    for (std::size_t i = 0; i < pack.Size(); ++i)
    {
      const double dx = std::remainder(p[0] - pack.X[i], 6.0),
                   dy = std::remainder(p[1] - pack.Y[i], 6.0),
                   dz = std::remainder(p[2] - pack.Z[i], 6.0);
      if (dx * dx + dy * dy + dz * dz < pack.Radius[i] * pack.Radius[i])
      {
        return pack.Mode[i] - 1;
      }
    }
    return 2;
  };
  constexpr int samples = 150000;
  std::vector<std::vector<int>> hits(9, std::vector<int>(lags.Count + 1, 0));
  oracle::Uniform random(15);
  for (int n = 0; n < samples; ++n)
  {
    const ruc::Vector3 p = { random(0, 6), random(0, 6), random(0, 6) }, u = random.Direction();
    const int r = phaseAt(p);
    for (int k = 1; k <= lags.Count; ++k)
    {
      const double lag = k * lags.Spacing;
      ++hits[3 * r + phaseAt({ p[0] + lag * u[0], p[1] + lag * u[1], p[2] + lag * u[2] })][k];
    }
  }
  for (int r = 0; r < 3; ++r)
  {
    for (int s = 0; s < 3; ++s)
    {
      for (int k = 1; k <= lags.Count; ++k)
      {
        const double expected = probability.S(r, s)[k];
        // The standard error is binomial; 4.5 of them for 54 comparisons
        EXPECT_NEAR(double(hits[3 * r + s][k]) / samples, expected,
          4.5 * std::sqrt(expected * (1 - expected) / samples) + 1e-9)
          << r << " " << s << " " << k;
      }
    }
  }
}

TEST(ExactPairSum, TablesAndClosedFormAgree)
{
  const Window box = oracle::PeriodicCube(12.0);
  const SpherePack pack = oracle::RelaxedPack({ 90, 250 }, { 0.9, 0.6 }, box, 8);
  const SpherePack distinct = WithDistinctRadii(pack);
  const LagGrid lags = { 0.15, 40 };
  const TwoPointProbability tabulated = ruc::SumPairs(pack, box, lags),
                            direct = ruc::SumPairs(distinct, box, lags);
  for (int r = 0; r < 2; ++r)
  {
    for (int s = r; s < 2; ++s)
    {
      ExpectNear(direct.S(r, s), tabulated.S(r, s),
        TableError * std::min(direct.Fractions[r], direct.Fractions[s]));
      // The closed form is that of brute force, up to its fixed point; the tables are not, so that
      // the two methods do take different ways
      const std::vector<double> expected = BruteForce(distinct, box, lags, r, s, false).Values;
      ExpectNear(direct.S(r, s), expected, FixedPointError);
      EXPECT_GT(LargestDifference(tabulated.S(r, s), expected), FixedPointError);
    }
  }
}

TEST(ExactPairSum, OverlappingSpheresCountTwice)
{
  // This is no claim about a medium, but it is the same sum
  const Window box = oracle::PeriodicCube(5.0);
  SpherePack pack = oracle::RandomPack({ 20, 300 }, { 1.0, 0.4 }, box, 9);
  ruc::SortCanonically(pack);
  const LagGrid lags = { 0.2, 15 };
  const TwoPointProbability direct = ruc::SumPairs(WithDistinctRadii(pack), box, lags),
                            tabulated = ruc::SumPairs(pack, box, lags);
  for (int r = 0; r < 2; ++r)
  {
    for (int s = r; s < 2; ++s)
    {
      const Expected expected = BruteForce(pack, box, lags, r, s, false);
      ExpectNear(direct.S(r, s), expected.Values, TableError);
      ExpectNear(tabulated.S(r, s), expected);
    }
  }
}

namespace
{
void ExpectIndependentOfSharing(const SpherePack& pack, const Window& window, const LagGrid& lags)
{
  omp_set_num_threads(1);
  const auto expected = ruc::SumPairs(pack, window, lags).Values;
  for (int threads : { 2, 4 })
  {
    omp_set_num_threads(threads);
    EXPECT_TRUE(ruc::SumPairs(pack, window, lags).Values == expected) << threads;
  }
  omp_set_num_threads(1);
  for (int size : { 2, 3, 40 })
  {
    oracle::ThreadRanks::Run(size,
      [&](ruc::Communicator& ranks)
      {
        // One rank hands out what all hold
        const ruc::PackShare share =
          ruc::SharePack(ranks.Rank() == 0 ? pack : SpherePack(), window, true, ranks);
        EXPECT_TRUE(ruc::SumPairs(share, lags, ranks).Values == expected) << size;
      });
  }
}
}

TEST(ExactPairSum, DoesNotDependOnRanksAndThreads)
{
  const Window box = oracle::PeriodicCube(12.0);
  const SpherePack pack = oracle::RelaxedPack({ 90, 250 }, { 0.9, 0.6 }, box, 8);
  const Window open = Window::MakeBox({ 0, 0, 0 }, { 12, 12, 12 }, { false, false, false });
  for (const SpherePack& p : { pack, WithDistinctRadii(pack) })
  {
    ExpectIndependentOfSharing(p, box, { 0.2, 20 });
    ExpectIndependentOfSharing(p, open, { 0.2, 20 });
  }
}

TEST(ExactPairSum, ProgressRises)
{
  const Window box = oracle::PeriodicCube(12.0);
  const ruc::PackShare share =
    ruc::SharePack(oracle::RelaxedPack({ 90, 250 }, { 0.9, 0.6 }, box, 8), box);
  ruc::Communicator serial;
  omp_set_num_threads(1);
  std::vector<double> told;
  ruc::SumPairs(share, { 0.2, 20 }, serial,
    [&](double done)
    {
      told.push_back(done);
      return true;
    });
  ASSERT_GT(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
}

TEST(ExactPairSum, LagsOutOfRange)
{
  const SpherePack pack = Lattice({ { 0.1, 0.1, 0.1 }, { 0.5, 0.5, 0.5 } }, 10.0, 1.0);
  const Window periodic = oracle::PeriodicCube(10.0);
  const Window open = Window::MakeBox({ 0, 0, 0 }, { 10, 12, 14 }, { false, false, false });
  EXPECT_NO_THROW(ruc::SumPairs(pack, periodic, { 1.0, 40 }));
  EXPECT_SAYS(
    ruc::SumPairs(pack, periodic, { 1.0, 41 }), "MaximumLag requires 0 < MaximumLag <= 40");
  EXPECT_SAYS(ruc::SumPairs(pack, open, { 0.1, 80 }), "got 8");
  EXPECT_SAYS(ruc::SumPairs(pack, open, { 0.0, 10 }), "MaximumLag requires");
  EXPECT_SAYS(ruc::SumPairs(pack, open, { -0.1, 10 }), "MaximumLag requires");
  EXPECT_SAYS(ruc::SumPairs(pack, open, { std::nan(""), 10 }), "MaximumLag requires");
  EXPECT_SAYS(ruc::SumPairs(pack, open, { 0.1, 0 }),
    "NumberOfLags requires 1 <= NumberOfLags <= 100000, got 0");
  EXPECT_SAYS(ruc::SumPairs(pack, open, { 1e-6, 100001 }), "NumberOfLags");
  const SpherePack flat = Lattice({ { 0.1, 0.1, 0.1 }, { 0.5, 0.5, 0.15 } }, 10.0, 1.0);
  EXPECT_SAYS(ruc::SumPairs(flat,
                Window::MakeBox({ 0, 0, 0 }, { 10, 10, 2 }, { false, false, false }), { 0.1, 1 }),
    "edges longer than the largest sphere's diameter");
}
