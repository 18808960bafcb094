// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThreePointProbability.h"

#include "Oracles.h"
#include "Statistics/FanComparison.h"
#include "ruc/Statistics/PairSums/ExactPairSum.h"

namespace
{
using namespace fans;
using oracle::Pi;
using ruc::TwoPointProbability;

/** S_rsq of all triples, s > q included, by name of the phases. */
class AllTriples
{
public:
  AllTriples(const SpherePack& pack, int modes, const SamplingRegion& region,
    const ThreePointGrid& grid, const FanSettings& settings)
    : Phases(modes + 1)
    , Sampled(Fans(pack, modes, region, grid, List(modes + 1), settings))
  {
  }

  double S(int r, int s, int q, int k1, int k2, int t) const
  {
    return this->Sampled.Value(this->Number(r, s, q), k1, k2, t);
  }
  double Error(int r, int s, int q, int k1, int k2, int t) const
  {
    return this->Sampled.Error(this->Number(r, s, q), k1, k2, t);
  }

private:
  static std::vector<PhaseTriple> List(int phases)
  {
    std::vector<PhaseTriple> list;
    for (int r = 0; r < phases; ++r)
    {
      for (int s = 0; s < phases; ++s)
      {
        for (int q = 0; q < phases; ++q)
        {
          list.push_back({ r, s, q });
        }
      }
    }
    return list;
  }
  std::size_t Number(int r, int s, int q) const
  {
    return (r * this->Phases + s) * this->Phases + q;
  }

  int Phases;
  ThreePointProbability Sampled;
};

template <class Visit>
void ForEachTriple(int phases, Visit&& visit)
{
  for (int r = 0; r < phases; ++r)
  {
    for (int s = 0; s < phases; ++s)
    {
      for (int q = 0; q < phases; ++q)
      {
        visit(r, s, q);
      }
    }
  }
}

// A periodic pack without overlap, of two modes, and all its triples
struct Periodic
{
  Window Box = Window::MakeBox({ -3, 1, 2 }, { 6.0, 5.0, 5.5 }, { true, true, true });
  SpherePack Pack = oracle::RelaxedPack({ 10, 16 }, { 0.9, 0.6 }, Box, 3);
  ThreePointGrid Grid = { { 0.45, 6 }, 8 };
  AllTriples All{ Pack, 2, SamplingRegion(Box, 0.0), Grid, { 2, 6400, true } };
};

const Periodic& PeriodicMedium()
{
  static const Periodic medium;
  return medium;
}

struct Bounded
{
  Window Box = Window::MakeBox({ 0, 0, 0 }, { 6.0, 5.0, 5.5 }, { false, true, false });
  SpherePack Pack = oracle::RandomPack({ 10, 20 }, { 0.9, 0.6 }, Box, 3);
  ThreePointGrid Grid = { { 0.3, 6 }, 8 };
  AllTriples All{ Pack, 2, SamplingRegion(Box, 0.9), Grid, { 2, 3200, false } };
};

// The limits (10) are whole-number identities of the counts of one run: whatever the region, a
// point at r = 0 is the centre. Ratios of whole numbers and of their doubles are the same number.
template <class Medium>
void ExpectLimits(const Medium& medium)
{
  const ThreePointGrid& grid = medium.Grid;
  const auto& all = medium.All;
  double greatest = 0.0;
  ForEachTriple(3,
    [&](int r, int s, int q)
    {
      for (int t = 0; t < grid.Angles(); ++t)
      {
        for (int k = 0; k < grid.Points(); ++k)
        {
          // r1 = 0: S_rq delta_rs at every angle; r2 = 0: S_rs delta_rq
          const double rq = all.S(r, r, q, 0, k, 0);
          EXPECT_EQ(all.S(r, s, q, 0, k, t), s == r ? rq : 0.0);
          EXPECT_EQ(all.S(r, q, s, k, 0, t), s == r ? rq : 0.0);
          // r1 = r2 at theta = 0: S_rs delta_sq
          EXPECT_EQ(all.S(r, s, q, k, k, 0), s == q ? all.S(r, r, s, 0, k, 0) : 0.0);
          greatest = std::max(greatest, rq);
        }
        // At both it is c_r
        EXPECT_EQ(all.S(r, s, q, 0, 0, t), r == s && r == q ? all.S(r, r, r, 0, 0, 0) : 0.0);
      }
    });
  EXPECT_GT(greatest, 0.3);
}

// The sum over q is S_rs of the same points, at every r2 and angle: a sum of three doubles
template <class Medium>
void ExpectSumOverPhase(const Medium& medium)
{
  ForEachPlace(medium.Grid,
    [&](int k1, int k2, int t)
    {
      double total = 0.0;
      for (int r = 0; r < 3; ++r)
      {
        for (int s = 0; s < 3; ++s)
        {
          double sum = 0.0;
          for (int q = 0; q < 3; ++q)
          {
            sum += medium.All.S(r, s, q, k1, k2, t);
          }
          total += sum;
          if (medium.Box.IsFullyPeriodic())
          {
            EXPECT_NEAR(sum, medium.All.S(r, s, r, k1, 0, t), 1e-15)
              << r << " " << s << " " << k1 << " " << k2 << " " << t;
          }
        }
      }
      // With a border the points that count depend on both lags, but are in one phase or another
      EXPECT_NEAR(total, 1.0, 2e-15);
    });
}
}

TEST(ThreePointProbability, HasItsLimits)
{
  ExpectLimits(PeriodicMedium());
  ExpectLimits(Bounded());
}

TEST(ThreePointProbability, SumOverAPhase)
{
  ExpectSumOverPhase(PeriodicMedium());
  ExpectSumOverPhase(Bounded());
}

TEST(ThreePointProbability, AgreesWithTheExactPairSum)
{
  // It is S_rs at r2 = 0, and summed over q at any r2 and angle. There are 9 pairs at 6 lags.
  const Periodic& medium = PeriodicMedium();
  const TwoPointProbability exact = ruc::SumPairs(medium.Pack, medium.Box, medium.Grid.Lags);
  for (int r = 0; r < 3; ++r)
  {
    for (int s = 0; s < 3; ++s)
    {
      for (int k = 0; k < medium.Grid.Points(); ++k)
      {
        const double error = medium.All.Error(r, s, r, k, 0, 2);
        // 1e-6 for the error of the exact sum
        EXPECT_NEAR(medium.All.S(r, s, r, k, 0, 2), exact.S(r, s)[k], 4.5 * error + 1e-6)
          << r << " " << s << " " << k;
        EXPECT_LT(error, 0.01);
        double sum = 0.0;
        for (int q = 0; q < 3; ++q)
        {
          sum += medium.All.S(r, s, q, k, 5, 3);
        }
        EXPECT_NEAR(sum, exact.S(r, s)[k], 4.5 * error + 1e-6) << r << " " << s << " " << k;
      }
    }
  }
}

TEST(ThreePointProbability, SwappedPhasesSwapTheLags)
{
  const Periodic& periodic = PeriodicMedium();
  const Bounded bounded;
  int different = 0;
  ForEachTriple(3,
    [&](int r, int s, int q)
    {
      ForEachPlace(periodic.Grid,
        [&](int k1, int k2, int t)
        {
          EXPECT_EQ(periodic.All.S(r, s, q, k1, k2, t), periodic.All.S(r, q, s, k2, k1, t));
          EXPECT_EQ(bounded.All.S(r, s, q, k1, k2, t), bounded.All.S(r, q, s, k2, k1, t));
          EXPECT_EQ(periodic.All.Error(r, s, q, k1, k2, t), periodic.All.Error(r, q, s, k2, k1, t));
          different += periodic.All.S(r, s, q, k1, k2, t) != periodic.All.S(r, s, q, k2, k1, t);
        });
    });
  EXPECT_GT(different, 1000);
}

TEST(ThreePointProbability, SwappedTriplesByThemselves)
{
  const Window box = oracle::PeriodicCube(5.0);
  const SpherePack pack = oracle::RandomPack({ 10, 16 }, { 0.9, 0.6 }, box, 3);
  const ThreePointGrid grid = { { 0.5, 4 }, 7 };
  const SamplingRegion region(box, 0.0);
  const ThreePointProbability up = Fans(pack, 2, region, grid, { { 0, 1, 2 } }, { 1, 200, true });
  const ThreePointProbability down =
    Fans(pack, 2, region, grid, { { 2, 2, 2 }, { 0, 2, 1 } }, { 1, 200, true });
  const ThreePointProbability both =
    Fans(pack, 2, region, grid, { { 0, 2, 1 }, { 0, 1, 2 } }, { 1, 200, true });
  ForEachPlace(grid,
    [&](int k1, int k2, int t)
    {
      EXPECT_EQ(up.Value(0, k1, k2, t), down.Value(1, k2, k1, t));
      EXPECT_EQ(up.Value(0, k1, k2, t), both.Value(1, k1, k2, t));
      EXPECT_EQ(up.Value(0, k1, k2, t), both.Value(0, k2, k1, t));
      EXPECT_EQ(up.Error(0, k1, k2, t), down.Error(1, k2, k1, t));
    });
}

TEST(ThreePointProbability, MatrixByInclusionAndExclusion)
{
  // With the indicator I of the spheres, (1 - I(x)) (1 - I(y)) (1 - I(z)), all from counts of one
  // run in a periodic box: exact but for the rounding of some hundred sums of numbers up to 1
  const Periodic& medium = PeriodicMedium();
  const AllTriples& all = medium.All;
  constexpr int modes = 2;
  ForEachPlace(medium.Grid,
    [&](int k1, int k2, int t)
    {
      const auto s = [&](int r, int p, int q) { return all.S(r, p, q, k1, k2, t); };
      double one[3] = {}, two[3] = {}, three = 0.0;
      ForEachTriple(modes + 1,
        [&](int r, int p, int q)
        {
          const bool x = r < modes, y = p < modes, z = q < modes;
          one[0] += x ? s(r, p, q) : 0.0;
          one[1] += y ? s(r, p, q) : 0.0;
          one[2] += z ? s(r, p, q) : 0.0;
          two[0] += x && y ? s(r, p, q) : 0.0;
          two[1] += x && z ? s(r, p, q) : 0.0;
          two[2] += y && z ? s(r, p, q) : 0.0;
          three += x && y && z ? s(r, p, q) : 0.0;
        });
      EXPECT_NEAR(s(modes, modes, modes),
        1.0 - one[0] - one[1] - one[2] + two[0] + two[1] + two[2] - three, 2e-14);
      // S_r and S_rs of x and y or z are those of any other run: at r2 = 0, r1 = 0
      double fraction = 0.0, pair = 0.0;
      for (int r = 0; r < modes; ++r)
      {
        fraction += all.S(r, r, r, 0, 0, 0);
        for (int p = 0; p < modes; ++p)
        {
          pair += all.S(r, p, r, k1, 0, 0);
        }
      }
      EXPECT_NEAR(one[0], fraction, 2e-14);
      EXPECT_NEAR(two[0], pair, 2e-14);
    });
}

TEST(ThreePointProbability, MatrixFromExactPairsAndSampledSpheres)
{
  // The same identity of the probabilities: S_mmm = 1 - 3 c + the pairs at the three sides of the
  // triangle, by the exact pair sum, - the sampled triples of spheres. What is off is an error of
  // S_mmm and of those triples, whose sum is not beyond the sum of the errors.
  const Periodic& medium = PeriodicMedium();
  const AllTriples& all = medium.All;
  const auto pairs = [&](double r)
  {
    const TwoPointProbability exact = ruc::SumPairs(medium.Pack, medium.Box, { r, 1 });
    return exact.S(0, 0)[1] + 2.0 * exact.S(0, 1)[1] + exact.S(1, 1)[1];
  };
  double spheres = 0.0;
  for (double radius : medium.Pack.Radius)
  {
    spheres += 4.0 / 3.0 * Pi * radius * radius * radius / medium.Box.Volume();
  }
  double greatest = 0.0;
  for (const auto& [k1, k2, t] : { std::array{ 1, 1, 1 }, { 1, 2, 3 }, { 2, 2, 4 }, { 3, 1, 2 },
         { 4, 6, 1 }, { 6, 6, 3 }, { 2, 5, 0 } })
  {
    const double r1 = 0.45 * k1, r2 = 0.45 * k2, angle = Pi * t / 4.0;
    const double r3 = std::sqrt(r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * std::cos(angle));
    double sampled = 0.0, error = all.Error(2, 2, 2, k1, k2, t);
    for (int n = 0; n < 8; ++n)
    {
      sampled += all.S(n / 4, n / 2 % 2, n % 2, k1, k2, t);
      error += all.Error(n / 4, n / 2 % 2, n % 2, k1, k2, t);
    }
    EXPECT_NEAR(all.S(2, 2, 2, k1, k2, t),
      1.0 - 3.0 * spheres + pairs(r1) + pairs(r2) + pairs(r3) - sampled, 4.0 * error)
      << k1 << " " << k2 << " " << t;
    greatest = std::max(greatest, error);
  }
  EXPECT_LT(greatest, 0.02);
}

TEST(ThreePointProbability, IsNoNumberWhereNothingIsKnown)
{
  // Three throws of two rays in a cube with lags near half of its edge: the points at the end of
  // both are hardly ever in it
  const SamplingRegion region(
    Window::MakeBox({ 0, 0, 0 }, { 1, 1, 1 }, { false, false, false }), 0.0);
  const ThreePointGrid grid = { { 0.2497, 2 }, 2 };
  const SpherePack pack = oracle::RandomPack({ 5 }, { 0.2 }, region.GetBounds(), 1);
  int known = 0, unknown = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed)
  {
    const ThreePointProbability sampled =
      Fans(pack, 1, region, grid, { { 0, 0, 0 }, { 1, 1, 1 } }, { seed, 3, true });
    ForEachPlace(grid,
      [&](int k1, int k2, int t)
      {
        const double value = sampled.Value(1, k1, k2, t), error = sampled.Error(1, k1, k2, t);
        EXPECT_EQ(std::isnan(value), std::isnan(sampled.Value(0, k1, k2, t)));
        EXPECT_EQ(std::isnan(value), std::isnan(error));
        EXPECT_TRUE(std::isnan(value) || (value >= 0.0 && value <= 1.0));
        known += !std::isnan(value);
        unknown += std::isnan(value);
      });
    EXPECT_FALSE(std::isnan(sampled.Value(1, 0, 0, 0)));
  }
  EXPECT_GT(known, 100);
  EXPECT_GT(unknown, 10);
  // A single batch, as after Stop, has no scatter
  ruc::Communicator serial;
  const ThreePointProbability single = ruc::SampleFans(pack, 1, region, grid, { { 1, 1, 1 } },
    { 1, 1000, true }, serial, [](double, const std::string&) { return false; });
  ASSERT_LT(single.GetThrows(), 1000);
  EXPECT_TRUE(std::isnan(single.Error(0, 0, 0, 0)));
  EXPECT_TRUE(std::isnan(single.ThirdOrderError(0).Zeta));
  EXPECT_TRUE(std::isnan(single.ThirdOrderError(0).Eta));
}
