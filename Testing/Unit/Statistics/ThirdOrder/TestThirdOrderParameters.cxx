// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Statistics/ThirdOrder/ThirdOrderParameters.h"

#include "Oracles.h"
#include "SampledComparison.h"
#include "ruc/Statistics/Sampling/FanSampling.h"

namespace
{
using oracle::Pi;
using ruc::ThirdOrderParameters;
using ruc::ThirdOrderRule;
using ruc::ThreePointGrid;
using ruc::Vector3;

double Legendre(int n, double x)
{
  double before = 1.0, now = x;
  for (int k = 2; k <= n; ++k)
  {
    before = std::exchange(now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k);
  }
  return n == 0 ? 1.0 : now;
}

// Legendre's P_n, n <= 4, integrated from x to 1
double LegendreBeyond(int n, double x)
{
  return (Legendre(n - 1, x) - Legendre(n + 1, x)) / (2.0 * n + 1.0);
}

// S_3(r1, r2, theta) on a grid, theta in radians
template <class Function>
std::vector<double> OnGrid(const ThreePointGrid& grid, Function&& s3)
{
  std::vector<double> values(grid.Size());
  for (int t = 0; t < grid.Angles(); ++t)
  {
    for (int k2 = 0; k2 < grid.Points(); ++k2)
    {
      for (int k1 = 0; k1 < grid.Points(); ++k1)
      {
        values[grid.PlaceOf(k1, k2, t)] =
          s3(k1 * grid.Lags.Spacing, k2 * grid.Lags.Spacing, 2.0 * Pi * t / grid.Directions);
      }
    }
  }
  return values;
}

ThirdOrderParameters Evaluate(
  const ThreePointGrid& grid, double fraction, const std::vector<double>& s3)
{
  return ThirdOrderRule::Parameters(
    ThirdOrderRule(grid).Integrate(fraction, [&](std::size_t place) { return s3[place]; }));
}

// Takes from a function on a grid what is at every step-th lag, up to a lag
struct Sampled
{
  ThreePointGrid Grid;
  std::vector<double> Values;
};

template <class Value>
Sampled Thinned(const ThreePointGrid& grid, int step, int lags, Value&& value)
{
  Sampled thin = { { { step * grid.Lags.Spacing, lags / step }, grid.Directions }, {} };
  thin.Values.resize(thin.Grid.Size());
  for (int t = 0; t < grid.Angles(); ++t)
  {
    for (int k2 = 0; k2 < thin.Grid.Points(); ++k2)
    {
      for (int k1 = 0; k1 < thin.Grid.Points(); ++k1)
      {
        thin.Values[thin.Grid.PlaceOf(k1, k2, t)] = value(step * k1, step * k2, t);
      }
    }
  }
  return thin;
}

/** A number and how far off it may be. */
struct Estimate
{
  double Value, Error;
};

/**
 * What the rule tends to with the lag spacing, from three spacings, each half of the one before:
 * its error is quadratic, then taken as cubic. The error is what that last step changed.
 */
Estimate Extrapolated(const double values[3])
{
  const double before = (4.0 * values[1] - values[0]) / 3.0;
  const double after = (4.0 * values[2] - values[1]) / 3.0;
  const double last = (8.0 * after - before) / 7.0;
  return { last, std::abs(last - after) };
}

// Nodes and weights of Gauss' rule on [0, 1]
std::vector<std::pair<double, double>> Gauss(int n)
{
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < n; ++i)
  {
    double x = std::cos(Pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int step = 0; step < 20; ++step)
    {
      slope = n * (x * Legendre(n, x) - Legendre(n - 1, x)) / (x * x - 1.0);
      x -= Legendre(n, x) / slope;
    }
    rule.emplace_back(0.5 * (x + 1.0), 1.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

/**
 * Zeta and eta of spheres of radius a on the simple cubic lattice of edge 1 with r1 and r2 up to
 * `reach`, without S_3: as a double integral over the points y, z within the reach of x
 *
 *     I_n = 1 / (8 pi^2) < I(x) int int I(x + y) I(x + z) P_n(cos(y, z)) / (y^3 z^3) dy dz >.
 *
 * A sphere cuts a cap off every shell around x, over which P_n(cos(y, z)) integrates to that of the
 * cap's axis: so the inner integrals are sums over pairs of spheres, of which each has a factor A_n
 * = int dr / r (2 pi int_cap P_n). For n = 2 and a whole sphere this is the dipole's V / d^3. The
 * mean over x in a sphere by Gauss' rule, in an eighth of it.
 */
ThirdOrderParameters OfCubicLattice(double a, double reach, int nodes)
{
  const double c = 4.0 / 3.0 * Pi * a * a * a;
  const std::vector<std::pair<double, double>> rule = Gauss(nodes), shells = Gauss(14);
  const int last = static_cast<int>(reach + 2.0 * a) + 1;
  struct Cap
  {
    Vector3 Axis;
    double Factors[2]; // A_2 and A_4
  };
  double sums[2] = {}, volume = 0.0;
  for (const auto& [radius, weight] : rule)
  {
    for (const auto& [cosine, weight2] : rule)
    {
      for (const auto& [turn, weight3] : rule)
      {
        const double lateral = a * radius * std::sqrt(1.0 - cosine * cosine);
        const Vector3 x = { lateral * std::cos(0.5 * Pi * turn),
          lateral * std::sin(0.5 * Pi * turn), a * radius * cosine };
        std::vector<Cap> caps;
        for (int n = 0; n < (2 * last + 1) * (2 * last + 1) * (2 * last + 1); ++n)
        {
          const int width = 2 * last + 1;
          Vector3 d = { n % width - last - x[0], n / width % width - last - x[1],
            n / (width * width) - last - x[2] };
          const double distance = std::hypot(d[0], d[1], d[2]);
          const double from = std::abs(distance - a), to = std::min(distance + a, reach);
          if (!(to > from))
          {
            continue;
          }
          Cap cap = { { d[0] / distance, d[1] / distance, d[2] / distance }, {} };
          for (const auto& [part, shell] : shells)
          {
            const double r = from + part * (to - from);
            const double edge = (r * r + distance * distance - a * a) / (2.0 * r * distance);
            const double factor = shell * (to - from) / r * 2.0 * Pi;
            cap.Factors[0] += factor * LegendreBeyond(2, edge);
            cap.Factors[1] += factor * LegendreBeyond(4, edge);
          }
          caps.push_back(cap);
        }
        const double share = weight * weight2 * weight3 * radius * radius;
        volume += share;
        for (const Cap& one : caps)
        {
          for (const Cap& other : caps)
          {
            const double x1 = one.Axis[0] * other.Axis[0] + one.Axis[1] * other.Axis[1] +
              one.Axis[2] * other.Axis[2];
            sums[0] += share * one.Factors[0] * other.Factors[0] * Legendre(2, x1);
            sums[1] += share * one.Factors[1] * other.Factors[1] * Legendre(4, x1);
          }
        }
      }
    }
  }
  const double both = c * (1.0 - c), i2 = c * sums[0] / volume / (8.0 * Pi * Pi),
               i4 = c * sums[1] / volume / (8.0 * Pi * Pi);
  const double zeta = 4.5 * i2 / both;
  return { zeta, 5.0 / 21.0 * zeta + 150.0 / 7.0 * i4 / both };
}
}

TEST(ThirdOrderRule, IntegratesPiecewiseLinearFunctionsExactly)
{
  // f(r1) g(r2) P_l(cos theta) with f = r up to b, from there on linearly down to 0 at R, and g =
  // r: int f / r = b + b R / (R - b) ln(R / b) - b, int g / r = R. The angular rule of n + 1 nodes
  // is exact up to the degree n, and for all odd functions.
  constexpr double c = 0.3, both = c * (1.0 - c);
  for (int directions : { 8, 10, 12, 16, 20, 40 })
  {
    for (int lags : { 8, 21, 40 })
    {
      const ThreePointGrid grid = { { 0.7, lags }, directions };
      ASSERT_TRUE(ThirdOrderRule(grid).IsValid());
      // On a lag that the rule of every second one has, too
      const double end = grid.Lags.Maximum(), b = 2 * (lags / 8) * grid.Lags.Spacing;
      const double f = b * end / (end - b) * std::log(end / b), g = end;
      for (int l = 0; l <= 8; ++l)
      {
        const std::vector<double> s3 = OnGrid(grid,
          [&](double r1, double r2, double theta)
          {
            const double left = r1 <= b ? r1 : b * (end - r1) / (end - b);
            return left * r2 * Legendre(l, std::cos(theta));
          });
        const ThirdOrderParameters found = Evaluate(grid, c, s3);
        const double zeta = l == 2 ? 4.5 / both * f * g * 2.0 / 5.0 : 0.0;
        const double eta =
          5.0 / 21.0 * zeta + (l == 4 ? 150.0 / 7.0 / both * f * g * 2.0 / 9.0 : 0);
        // Rounding of sums of numbers up to 150 / (7 c (1 - c)) f g
        const double rounding = 1e-13 / both * f * g;
        if (l % 2 == 1 || l + 2 <= directions / 2)
        {
          EXPECT_NEAR(found.Zeta, zeta, rounding) << l << " " << directions << " " << lags;
        }
        if (l % 2 == 1 || l + 4 <= directions / 2)
        {
          EXPECT_NEAR(found.Eta, eta, 30.0 * rounding) << l << " " << directions << " " << lags;
        }
      }
    }
  }
}

TEST(ThirdOrderRule, SeesBothLagsAlike)
{
  const ThreePointGrid grid = { { 0.3, 7 }, 12 };
  const auto s3 = [](double r1, double r2, double theta)
  { return std::exp(-r1) * r2 / (1.0 + r1 * r2) * std::cos(2.0 * theta); };
  const ThirdOrderParameters one = Evaluate(grid, 0.4, OnGrid(grid, s3));
  const ThirdOrderParameters other = Evaluate(
    grid, 0.4, OnGrid(grid, [&](double r1, double r2, double theta) { return s3(r2, r1, theta); }));
  EXPECT_GT(std::abs(one.Zeta), 0.1);
  EXPECT_NEAR(one.Zeta, other.Zeta, 1e-13 * std::abs(one.Zeta));
  EXPECT_NEAR(one.Eta, other.Eta, 1e-12 * std::abs(one.Eta));
  // Lengths have no scale
  const ThreePointGrid wide = { { 3.0, 7 }, 12 };
  EXPECT_EQ(Evaluate(wide, 0.4, OnGrid(grid, s3)).Zeta, one.Zeta);
}

TEST(ThirdOrderRule, IsNoNumberWithoutItsAngles)
{
  for (int directions : { 2, 4, 6, 7, 9, 21 })
  {
    const ThreePointGrid grid = { { 0.3, 3 }, directions };
    EXPECT_FALSE(ThirdOrderRule(grid).IsValid());
    const ThirdOrderParameters found = Evaluate(grid, 0.4, std::vector<double>(grid.Size(), 0.1));
    EXPECT_TRUE(std::isnan(found.Zeta));
    EXPECT_TRUE(std::isnan(found.Eta));
  }
  EXPECT_FALSE(ThirdOrderRule({ { 0.3, 1 }, 8 }).IsValid());
  EXPECT_TRUE(ThirdOrderRule({ { 0.3, 2 }, 8 }).IsValid());
}

namespace
{
/**
 * Zeta or eta of the Boolean model of spheres of radius 1 from its exact S_3: at lags up to 8 radii
 * and spacings of 1/10, 1/20 and 1/40, extrapolated; and what is beyond. Where the lags end,
 * correlations of two points at a small angle are left, of all (1 / R)^3: to what 16 radii have
 * more, at the first spacing, a seventh is added for what is beyond these.
 */
class OverlappingSpheres
{
public:
  OverlappingSpheres()
    : Fine{ { 0.025, 320 }, 40 }
    , Longer{ { 0.1, 160 }, 40 }
    , Volumes(UnionsOn(Fine))
    , FarVolumes(UnionsOn(Longer))
  {
  }

  /** `s3(V_union, r1, r2, r3)` is S_3 of a phase of that fraction. */
  template <class Function>
  std::array<Estimate, 2> Parameters(double fraction, Function&& s3) const
  {
    double found[2][3];
    for (int level = 0; level < 3; ++level)
    {
      const ThirdOrderParameters one =
        this->Evaluated(this->Fine, 4 >> level, fraction, this->Volumes, s3);
      found[0][level] = one.Zeta;
      found[1][level] = one.Eta;
    }
    const ThirdOrderParameters far =
      this->Evaluated(this->Longer, 1, fraction, this->FarVolumes, s3);
    std::array<Estimate, 2> estimates = { Extrapolated(found[0]), Extrapolated(found[1]) };
    for (int n = 0; n < 2; ++n)
    {
      const double tail = (n == 0 ? far.Zeta : far.Eta) - found[n][0];
      estimates[n].Value += 8.0 / 7.0 * tail;
      estimates[n].Error += 0.1 * std::abs(tail);
    }
    return estimates;
  }

private:
  static std::vector<double> UnionsOn(const ThreePointGrid& grid)
  {
    std::vector<double> volumes(grid.Size());
    for (int t = 0; t < grid.Angles(); ++t)
    {
      for (int k2 = 0; k2 < grid.Points(); ++k2)
      {
        for (int k1 = 0; k1 <= k2; ++k1)
        {
          volumes[grid.PlaceOf(k1, k2, t)] = volumes[grid.PlaceOf(k2, k1, t)] =
            oracle::UnionOfThree(
              1.0, k1 * grid.Lags.Spacing, k2 * grid.Lags.Spacing, 2.0 * Pi * t / grid.Directions);
        }
      }
    }
    return volumes;
  }

  template <class Function>
  static ThirdOrderParameters Evaluated(const ThreePointGrid& grid, int step, double fraction,
    const std::vector<double>& volumes, Function&& s3)
  {
    const Sampled thin = Thinned(grid, step, grid.Lags.Count,
      [&](int k1, int k2, int t)
      {
        const double r1 = k1 * grid.Lags.Spacing, r2 = k2 * grid.Lags.Spacing;
        const double cosine = std::cos(2.0 * Pi * t / grid.Directions);
        return s3(volumes[grid.PlaceOf(k1, k2, t)], r1, r2,
          std::sqrt(std::max(r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * cosine, 0.0)));
      });
    return Evaluate(thin.Grid, fraction, thin.Values);
  }

  ThreePointGrid Fine, Longer;
  std::vector<double> Volumes, FarVolumes;
};
}

TEST(ThirdOrderRule, OverlappingSpheres)
{
  // S. Torquato, Random Heterogeneous Materials (Springer 2002), the table of zeta_2 and eta_2 of
  // identical overlapping spheres for phi_2 = 0.1, ..., 0.9, quoted second-hand; eta_2 = 0.224 at
  // 0.3, which is not on the line of its neighbours, is left out. All else than the matrix, whose
  // S_mmm is exp(-rho V_union), has 1 - zeta.
  constexpr double zetas[] = { 0.056, 0.114, 0.171, 0.230, 0.290, 0.351, 0.415, 0.483, 0.558 };
  constexpr double etas[] = { 0.075, 0.149, 0.0, 0.295, 0.367, 0.439, 0.512, 0.583, 0.658 };
  const OverlappingSpheres model;
  for (int n = 0; n < 9; ++n)
  {
    const double matrix = 1.0 - 0.1 * (n + 1), rho = -std::log(matrix) / (4.0 / 3.0 * Pi);
    const auto [zeta, eta] = model.Parameters(
      matrix, [&](double volume, double, double, double) { return std::exp(-rho * volume); });
    // A unit of the last digit published is added, which is itself from quadrature
    EXPECT_NEAR(1.0 - zeta.Value, zetas[n], 0.001 + zeta.Error) << matrix;
    EXPECT_LT(zeta.Error, 0.0025);
    if (etas[n] > 0.0)
    {
      EXPECT_NEAR(1.0 - eta.Value, etas[n], 0.001 + eta.Error) << matrix;
    }
    EXPECT_LT(eta.Error, 0.0025);
    if (n % 4 == 2)
    {
      // The spheres' parameters from their own S_3, by inclusion and exclusion
      const auto two = [&](double r)
      { return std::exp(-rho * (8.0 / 3.0 * Pi - oracle::LensVolume(1.0, 1.0, r))); };
      const auto [zeta2, eta2] = model.Parameters(1.0 - matrix,
        [&](double volume, double r1, double r2, double r3)
        { return 1.0 - 3.0 * matrix + two(r1) + two(r2) + two(r3) - std::exp(-rho * volume); });
      EXPECT_NEAR(zeta.Value + zeta2.Value, 1.0, zeta.Error + zeta2.Error);
      EXPECT_NEAR(eta.Value + eta2.Value, 1.0, eta.Error + eta2.Error);
    }
  }
}

TEST(ThirdOrderRule, SampledCubicLattice)
{
  // One sphere in a periodic cube; the exact parameters with the same end of the lags. 20
  // directions are enough up to one or three halves of the edge, 2 and 3 radii: 40 change zeta by
  // 4e-4 there. Runs by themselves give the standard error of what is extrapolated from them.
  const OneThread alone;
  constexpr double c = 0.45;
  const double a = std::cbrt(3.0 * c / (4.0 * Pi));
  const ruc::SamplingRegion region(oracle::PeriodicCube(1.0), 0.0);
  const ruc::SpherePack pack = oracle::RandomPack({ 1 }, { a }, region.GetBounds(), 1);
  const ThreePointGrid grid = { { 0.0125, 120 }, 20 };
  const int ends[2] = { 80, 120 };
  MeanFunction mean(4);
  double change[4] = {};
  constexpr int runs = 16;
  ruc::Communicator serial;
  for (std::uint32_t seed = 1; seed <= runs; ++seed)
  {
    const ruc::ThreePointProbability sampled =
      ruc::SampleFans(pack, 1, region, grid, { { 0, 0, 0 } }, { seed, 5000, false }, serial);
    std::vector<double> found;
    for (int lags : ends)
    {
      double zeta[3], eta[3];
      for (int level = 0; level < 3; ++level)
      {
        const Sampled s3 = Thinned(grid, 4 >> level, lags,
          [&](int k1, int k2, int t) { return sampled.Value(0, k1, k2, t); });
        const ThirdOrderParameters one = Evaluate(s3.Grid, s3.Values[0], s3.Values);
        zeta[level] = one.Zeta;
        eta[level] = one.Eta;
      }
      for (const double* levels : { zeta, eta })
      {
        change[found.size()] +=
          (Extrapolated(levels).Value - (4.0 * levels[2] - levels[1]) / 3.0) / runs;
        found.push_back(Extrapolated(levels).Value);
      }
    }
    mean.Add(found);
  }
  int n = 0;
  for (int lags : ends)
  {
    const ThirdOrderParameters exact = OfCubicLattice(a, lags * grid.Lags.Spacing, 8);
    for (double expected : { exact.Zeta, exact.Eta })
    {
      EXPECT_NEAR(mean.Value(n), expected, 4.0 * mean.Error(n) + std::abs(change[n])) << lags;
      EXPECT_LT(4.0 * mean.Error(n) + std::abs(change[n]), 0.1 * expected);
      ++n;
    }
  }
}

TEST(ThirdOrderError, IsTheScatterOfRuns)
{
  // 60 runs of 64 batches know the scatter to 1 / sqrt(120), 9 %; the bounds are 4 of these away.
  // Batches of 50 throws, with some 22 in the sphere, make their own parameters less certain than
  // in proportion to 1 / sqrt(throws): a few parts in 22 more.
  const OneThread alone;
  const double a = std::cbrt(3.0 * 0.45 / (4.0 * Pi));
  const ruc::SamplingRegion region(oracle::PeriodicCube(1.0), 0.0);
  const ruc::SpherePack pack = oracle::RandomPack({ 1 }, { a }, region.GetBounds(), 1);
  const ThreePointGrid grid = { { 0.1, 8 }, 8 };
  MeanFunction parameters(4), errors(4);
  constexpr int runs = 60;
  ruc::Communicator serial;
  for (std::uint32_t seed = 1; seed <= runs; ++seed)
  {
    const ruc::ThreePointProbability sampled = ruc::SampleFans(
      pack, 1, region, grid, { { 0, 0, 0 }, { 1, 1, 1 } }, { seed, 3200, true }, serial);
    const ThirdOrderParameters one = sampled.ThirdOrder(0), other = sampled.ThirdOrder(1);
    parameters.Add({ one.Zeta, one.Eta, other.Zeta, other.Eta });
    const ThirdOrderParameters error = sampled.ThirdOrderError(0),
                               more = sampled.ThirdOrderError(1);
    errors.Add({ error.Zeta, error.Eta, more.Zeta, more.Eta });
  }
  for (int n = 0; n < 4; ++n)
  {
    const double scatter = std::sqrt(static_cast<double>(runs)) * parameters.Error(n);
    EXPECT_GT(errors.Value(n), (1.0 - 4.0 * 0.09) * scatter) << n;
    EXPECT_LT(errors.Value(n), (1.0 + 4.0 * 0.09 + 3.0 / 22.0) * scatter) << n;
  }
}
